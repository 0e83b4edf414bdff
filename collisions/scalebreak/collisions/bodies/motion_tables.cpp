#include <scalebreak/collisions/bodies/motion_tables.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace scalebreak {

std::vector<std::pair<std::string, double>> terms_of(const EnergyAccount& a) {
  return {{"kinetic", a.kinetic}, {"elastic", a.elastic},   {"damping", a.damping}, {"friction", a.friction},
          {"rolling", a.rolling}, {"adhesion", a.adhesion}, {"liquid", a.liquid}};
}

namespace report {

using Eigen::Vector3d;

void append(Row& row, const Vector3d& v) { row.insert(row.end(), {v[0], v[1], v[2]}); }
void append(std::vector<std::string>& header, const std::string& name, const std::string& unit) {
  for (const char* axis : {"x", "y", "z"}) header.push_back(fmt::format("{}_{} [{}]", name, axis, unit));
}
void append_terms(std::vector<std::string>& header) {
  for (const auto& [name, value] : terms_of({}))
    header.push_back(name + (name == "kinetic" || name == "elastic" ? "_energy [J]" : "_loss [J]"));
}
void append_terms(Row& row, const EnergyAccount& account) {
  for (const auto& [name, value] : terms_of(account)) row.emplace_back(value);
}

TimeAxis time_axis(double duration) {
  if (duration < 1e-3) return {"($1*1e6)", "time [us]"};
  return duration < 1 ? TimeAxis{"($1*1e3)", "time [ms]"} : TimeAxis{"1", "time [s]"};
}

std::string events_csv(const std::vector<MotionRecord::Change>& changes) {
  Csv csv({"time [s]", "first [-]", "second [-]", "change"});
  for (const auto& c : changes) csv.add({c.time, c.first + 1.0, c.second + 1.0, to_string(c.what)});
  return csv.text();
}

std::string under(const Input& input) {
  return input.scaling_law == "none" && input.scaling_factor == 1 ? ""
                                                                  : fmt::format(", {} at {:g}", input.scaling_law, input.scaling_factor);
}

Plot energy_plot(const std::string& file, int first_column, const std::vector<MotionRecord::Instant>& instants, const std::string& title) {
  const TimeAxis time = time_axis(instants.back().time);
  Plot plot{"energy", title, time.label, "energy [J]", false, false, {}};
  const auto legends = {"kinetic",       "elastic, in the contacts", "lost: normal dashpot", "lost: friction",
                        "lost: rolling", "lost: torn adhesion",      "liquid, kept and lost"};
  int term = 0;
  for (const char* legend : legends) {
    const auto index = static_cast<std::size_t>(term);
    const bool seen = std::any_of(instants.begin(), instants.end(), [&](const auto& i) { return terms_of(i.energy)[index].second != 0; });
    if (seen) plot.curves.push_back({file, time.column, std::to_string(first_column + term), legend, false, term});
    ++term;
  }
  return plot;
}

}  // namespace report
}  // namespace scalebreak

#include "flow_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/flow_json.hpp>
#include <scalebreak/measure/flow_measurement.hpp>
#include <scalebreak/statistics/standard_error.hpp>

#include "lammps_series.hpp"
#include "peer_scene.hpp"

namespace scalebreak::peers {
namespace {

constexpr PeerScene gas = {"flow", 1e8, false, false, 0, 0};

/// Of independent values.
Measured independent_mean(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += std::pow(value - sum / count, 2);
  return {sum / count, std::sqrt(squares / (count - 1) / count)};
}

constexpr const char* head =
    " | unit | scalebreak | LAMMPS | scalebreak − LAMMPS | in standard errors |\n| --- | --- | --- | --- | --- | --- |\n";

/// One value of each engine for each state.
std::string row(const std::string& name, const std::string& unit, const std::vector<double>& ours, const std::vector<double>& theirs) {
  std::vector<double> between;
  for (std::size_t k = 0; k < ours.size(); ++k) between.push_back(ours[k] - theirs[k]);
  const Measured our = independent_mean(ours), their = independent_mean(theirs), difference = independent_mean(between);
  const double scale = 100 / std::abs(their.value);
  return fmt::format("| {} | {} | {:.5g} ± {:.1g} | {:.5g} ± {:.1g} | {:+.2f} % ± {:.2f} % | {:+.1f} |\n", name, unit, our.value, our.error,
                     their.value, their.error, scale * difference.value, scale * difference.error, difference.value / difference.error);
}

std::vector<std::vector<SeriesRow>> read_all(const Runs& runs) {
  if (runs.states.size() != runs.series.size() || runs.states.size() < 3)
    throw InputError(
        fmt::format("--states: found {}, and {} --series; allowed: as many of both, at least 3", runs.states.size(), runs.series.size()));
  std::vector<std::vector<SeriesRow>> all;
  for (const std::string& file : runs.series) {
    all.push_back(read_series(file));
    if (all.back().size() != all.front().size()) throw InputError(file + ": of another length than the first series");
  }
  return all;
}

FlowResult run_shear(const Runs& runs, System state, double rate, const std::vector<SeriesRow>& rows) {
  state.cell.shear_rate = rate;
  for (std::size_t i = 0; i < state.count(); ++i) state.velocity[i] += mean_flow(state.cell, state.position[i].z());
  DemSetup setup = peer_setup(gas, runs.restitution, false);
  setup.threads = runs.threads;
  Dem dem(state, setup);
  FlowMeasurement measurement;
  for (const SeriesRow& r : rows) {
    dem.advance(r.step - dem.steps());
    const System system = dem.system();
    const std::vector<ContactForce> contacts = dem.contact_forces();
    const DemTotals& totals = dem.totals();
    measurement.add({.system = system,
                     .contacts = contacts,
                     .contact_starts = totals.contact_starts,
                     .elastic_energy = dem.elastic_energy(),
                     .contact_time = totals.contact_time,
                     .contact_moment = totals.contact_moment});
  }
  return measurement.result();
}

double solid_density(const System& state) {
  double mass = 0;
  for (const double m : state.mass) mass += m;
  return mass / state.cell.volume();
}

struct Thermal {
  double temperature, rotational_energy;
};
Thermal thermal(const System& system) {
  Thermal sum{0, 0};
  for (std::size_t i = 0; i < system.count(); ++i) {
    sum.temperature += system.velocity[i].squaredNorm() / 3;
    sum.rotational_energy += system.inertia(i) * system.spin[i].squaredNorm() / 2;
  }
  const double count = static_cast<double>(system.count());
  return {sum.temperature / count, sum.rotational_energy / count};
}

}  // namespace

std::string compare_shear(const Runs& runs, double rate) {
  const auto series = read_all(runs);
  double solids = 0;  // per volume of the cell [kg/m³]
  struct Column {
    const char* name;
    std::function<double(const SeriesRow&)> theirs;
  };
  const Column columns[] = {{"temperature", [](const SeriesRow& r) { return r.temperature; }},
                            {"rotational_energy", [](const SeriesRow& r) { return r.rotational_energy; }},
                            {"coordination", [](const SeriesRow& r) { return r.coordination; }},
                            {"pressure", [&](const SeriesRow& r) { return r.contact_pressure + solids * r.temperature; }},
                            {"stress_contact_zx", [](const SeriesRow& r) { return r.contact_stress_xz; }}};
  std::vector<std::vector<double>> ours(std::size(columns)), theirs(std::size(columns));
  std::vector<std::string> units(std::size(columns));
  for (std::size_t k = 0; k < series.size(); ++k) {
    const System state = peer_state(runs.states[k], false);
    solids = solid_density(state);
    const std::vector<Quantity> found = all_quantities(run_shear(runs, state, rate, series[k]));
    for (std::size_t c = 0; c < std::size(columns); ++c) {
      const auto quantity = std::find_if(found.begin(), found.end(), [&](const Quantity& q) { return q.name == columns[c].name; });
      if (quantity == found.end()) throw WorkError(fmt::format("{} is not among what a flow measures", columns[c].name));
      ours[c].push_back(quantity->measured.value);
      units[c] = quantity->unit;
      double sum = 0;
      for (const SeriesRow& r : series[k]) sum += columns[c].theirs(r);
      theirs[c].push_back(sum / static_cast<double>(series[k].size()));
    }
  }
  std::string table = std::string("| quantity") + head;
  for (std::size_t c = 0; c < std::size(columns); ++c) table += row(columns[c].name, units[c], ours[c], theirs[c]);
  return table;
}

std::string compare_cooling(const Runs& runs) {
  const auto series = read_all(runs);
  DemSetup setup = peer_setup(gas, runs.restitution, false);
  setup.threads = runs.threads;
  std::vector<std::vector<Thermal>> ours(series.size());
  for (std::size_t k = 0; k < series.size(); ++k) {
    Dem dem(peer_state(runs.states[k], false), setup);
    for (const SeriesRow& r : series[k]) {
      dem.advance(r.step - dem.steps());
      ours[k].push_back(thermal(dem.system()));
    }
  }
  std::string table = std::string("| after steps, quantity") + head;
  for (std::size_t i = 1; i < series.front().size(); ++i) {
    std::vector<double> temperature[2], rotation[2];
    for (std::size_t k = 0; k < series.size(); ++k) {
      temperature[0].push_back(ours[k][i].temperature);
      temperature[1].push_back(series[k][i].temperature);
      rotation[0].push_back(ours[k][i].rotational_energy);
      rotation[1].push_back(series[k][i].rotational_energy);
    }
    const std::string step = fmt::format("{}, ", series.front()[i].step);
    table += row(step + "temperature", "m2/s2", temperature[0], temperature[1]);
    table += row(step + "rotational_energy", "J", rotation[0], rotation[1]);
  }
  return table;
}

}  // namespace scalebreak::peers

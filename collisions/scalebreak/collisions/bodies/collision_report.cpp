#include <scalebreak/collisions/bodies/collision_report.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/collisions/bodies/motion_tables.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

using Eigen::Vector3d;
using namespace report;

std::vector<Plot> write_head_on(const Input& input, const SceneCollision& result, const std::filesystem::path& folder) {
  const ScaledContact contact = contact_of(input);
  const double speed = input.normal_speed;
  Csv csv({"time [s]", "overlap [m]", "contact_radius [m]", "approach_speed [m/s]", "elastic_force [N]", "damping_force [N]", "force [N]"});
  for (const TrajectoryPoint& p : contact.trajectory(speed, input.tolerance, 400))
    csv.add({p.time, p.overlap, p.contact_radius, p.speed, p.elastic_force, p.damping_force, p.elastic_force + p.damping_force});
  write_file(folder / "trajectory.csv", csv.text());
  std::vector<MotionRecord::Change> changes = {{0, 0, 1, ContactChange::touch}};
  if (!result.pair->stuck) changes.push_back({result.motion.last_separation, 0, 1, ContactChange::separation});
  write_file(folder / "events.csv", events_csv(changes));
  Plot plot{"force_overlap",
            fmt::format("Normal force and overlap at {:.4g} m/s ({}{})", speed, to_string(contact.kind()), under(input)),
            "overlap [m]",
            "force, positive in repulsion [N]",
            false,
            false,
            {}};
  plot.curves = {{"trajectory.csv", "2", "7", "with the dashpot"}, {"trajectory.csv", "2", "5", "without the dashpot", false, 2}};
  return {plot};
}

/// Of a pair: one row an instant.
std::vector<Plot> write_pair(const Input& input, const SceneCollision& result, const std::filesystem::path& folder) {
  const MotionRecord record = record_motion(input, 200);
  const Vector3d along = result.pair->surface_direction;
  std::vector<std::string> header = {
      "time [s]",   "overlap [m]", "normal_force [N]", "liquid_force [N]", "tangential_force [N]", "surface_speed [m/s]",
      "slides [-]", "rolls [-]"};
  for (const char* body : {"1", "2"}) {
    append(header, std::string("velocity") + body, "m/s");
    append(header, std::string("spin") + body, "rad/s");
  }
  const std::size_t first_term = header.size() + 1;
  append_terms(header);
  Csv csv(header);
  bool rolls = false, wet = false;
  for (const auto& instant : record.instants) {
    Row row = {instant.time};
    if (instant.contacts.empty()) {
      row.resize(8);
    } else {
      const ContactState& c = instant.contacts.front();
      row.insert(row.end(), {c.overlap, c.normal_force, c.liquid_force, c.tangential_force.dot(along), c.surface_velocity.dot(along),
                             static_cast<double>(c.slides), static_cast<double>(c.rolls)});
      rolls = rolls || c.rolls;
      wet = wet || c.liquid_force != 0;
    }
    for (const MovingBody& body : instant.bodies) {
      append(row, body.velocity);
      append(row, body.spin);
    }
    append_terms(row, instant.energy);
    csv.add(row);
  }
  write_file(folder / "trajectory.csv", csv.text());
  write_file(folder / "events.csv", events_csv(record.changes));
  const std::string what =
      fmt::format("{:.4g} m/s normal, {:.4g} m/s tangential{}", result.pair->impact_speed, result.pair->tangential_speed, under(input));
  const TimeAxis time = time_axis(record.instants.back().time);
  Plot normal{"force_overlap", "Normal force and overlap: " + what, "overlap [m]", "force, positive in repulsion [N]", false, false, {}};
  // A bridge is stretched much further than the solids are pressed together.
  const std::string overlap = fmt::format("($2 > {:.17g} ? $2 : NaN)", -result.motion.max_overlap);
  normal.curves = {{"trajectory.csv", overlap, "3", "spring and dashpot"}};
  if (wet) normal.curves.push_back({"trajectory.csv", overlap, "4", "liquid", false, 1});
  std::vector<Plot> plots = {normal,
                             energy_plot("trajectory.csv", static_cast<int>(first_term), record.instants, "Where the energy is: " + what)};
  if (wet && input.surface.attraction_range == AttractionRange::bridge) {
    Plot bridge{"bridge_force",
                "Force of the liquid bridge: " + what,
                "separation of the surfaces [m]",
                "force, positive in repulsion [N]",
                true,
                false,
                {}};
    bridge.curves = {{"trajectory.csv", "(-$2)", "4", "capillary and viscous", false, 1, "$2 < 0"}};
    plots.push_back(bridge);
  }
  if (input.surface.tangential != TangentialModel::none) {
    Plot force{"tangential_force",
               "Friction on the first body: " + what,
               time.label,
               "force along the surfaces' motion at first touch [N]",
               false,
               false,
               {}};
    force.curves = {{"trajectory.csv", time.column, "5", "spring holds", false, 0, "$7 == 0"},
                    {"trajectory.csv", time.column, "5", "slides", false, 2, "$7 == 1"}};
    plots.push_back(force);
  }
  if (input.surface.spins()) {
    Plot speed{"surface_speed",
               "Speed of the first surface past the second: " + what,
               time.label,
               "speed along its direction at first touch [m/s]",
               false,
               false,
               {}};
    speed.curves = {{"trajectory.csv", time.column, "6", "not sliding", false, 0, "$7 == 0"},
                    {"trajectory.csv", time.column, "6", "sliding", false, 2, "$7 == 1"}};
    if (rolls) speed.curves.push_back({"trajectory.csv", time.column, "6", "rolling at its limit", true, 3, "$8 == 1"});
    plots.push_back(speed);
  }
  return plots;
}

}  // namespace

std::vector<std::string> write_collision_files(const Input& input, const SceneCollision& result, const std::filesystem::path& folder) {
  const auto plots = result.head_on         ? write_head_on(input, result, folder)
                     : input.bodies.empty() ? write_pair(input, result, folder)
                                            : write_bodies(input, result, folder);
  std::vector<std::string> missing;
  for (const Plot& plot : plots) {
    if (!draw(plot, folder)) missing.push_back(plot.name);
  }
  return missing;
}

}  // namespace scalebreak

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/collisions/bodies/motion_tables.hpp>
#include <scalebreak/output/atomic_file.hpp>

namespace scalebreak::report {

using Eigen::Vector3d;

namespace {

/// The two axes along which the scene is largest.
std::pair<int, int> widest_plane(const std::vector<MotionRecord::Instant>& instants) {
  Vector3d low = Vector3d::Constant(INFINITY), high = -low;
  for (const auto& instant : instants) {
    for (const MovingBody& body : instant.bodies) low = low.cwiseMin(body.position), high = high.cwiseMax(body.position);
  }
  int thinnest = 0;
  // Where two are equal, the first axes win.
  for (int axis = 1; axis < 3; ++axis) thinnest = high[axis] - low[axis] <= high[thinnest] - low[thinnest] ? axis : thinnest;
  return {thinnest == 0 ? 1 : 0, thinnest == 2 ? 1 : 2};
}

std::string outlines_csv(const MotionRecord& record, std::pair<int, int> plane) {
  Csv csv({"body [-]", "when", "across [m]", "up [m]"});
  for (std::size_t b = 0; b < record.instants.front().bodies.size(); ++b) {
    for (const char* when : {"start", "end"}) {
      const MovingBody& body = (*when == 's' ? record.instants.front() : record.instants.back()).bodies[b];
      for (int k = 0; k <= 72; ++k) {
        const double angle = std::numbers::pi * k / 36;
        csv.add({static_cast<double>(b + 1), when, body.position[plane.first] + body.radius * std::cos(angle),
                 body.position[plane.second] + body.radius * std::sin(angle)});
      }
    }
  }
  return csv.text();
}

std::string bodies_csv(const MotionRecord& record) {
  std::vector<std::string> header = {"time [s]", "body [-]"};
  append(header, "position", "m");
  append(header, "velocity", "m/s");
  append(header, "spin", "rad/s");
  Csv csv(header);
  for (std::size_t b = 0; b < record.instants.front().bodies.size(); ++b) {
    for (const auto& instant : record.instants) {
      Row row = {instant.time, static_cast<double>(b + 1)};
      append(row, instant.bodies[b].position);
      append(row, instant.bodies[b].velocity);
      append(row, instant.bodies[b].spin);
      csv.add(row);
    }
  }
  return csv.text();
}

std::string contacts_csv(const MotionRecord& record) {
  Csv csv({"time [s]", "first [-]", "second [-]", "overlap [m]", "normal_force [N]", "liquid_force [N]", "tangential_force [N]",
           "surface_speed [m/s]", "slides [-]", "rolls [-]"});
  for (const auto& instant : record.instants) {
    for (const ContactState& c : instant.contacts) {
      csv.add({instant.time, c.first + 1.0, c.second + 1.0, c.overlap, c.normal_force, c.liquid_force, c.tangential_force.norm(),
               c.surface_velocity.norm(), static_cast<double>(c.slides), static_cast<double>(c.rolls)});
    }
  }
  return csv.text();
}

std::string energy_csv(const MotionRecord& record) {
  std::vector<std::string> header = {"time [s]", "contacts [-]", "largest_overlap [m]"};
  append_terms(header);
  Csv csv(header);
  for (const auto& instant : record.instants) {
    const auto touching = std::count_if(instant.contacts.begin(), instant.contacts.end(), [](const auto& c) { return c.touching; });
    Row row = {instant.time, static_cast<double>(touching), instant.largest_overlap};
    append_terms(row, instant.energy);
    csv.add(row);
  }
  return csv.text();
}

}  // namespace

std::vector<Plot> write_bodies(const Input& input, const SceneCollision& result, const std::filesystem::path& folder) {
  const MotionRecord record = record_motion(input, 40);
  const auto plane = widest_plane(record.instants);
  write_file(folder / "trajectory.csv", bodies_csv(record));
  write_file(folder / "contacts.csv", contacts_csv(record));
  write_file(folder / "energy.csv", energy_csv(record));
  write_file(folder / "outlines.csv", outlines_csv(record, plane));
  write_file(folder / "events.csv", events_csv(record.changes));
  const std::size_t count = result.before.size();
  const TimeAxis time = time_axis(result.motion.time);
  const std::string what = fmt::format("{} bodies, {} contacts{}", count, result.motion.touches, under(input));
  const auto axis = [](int k) { return std::string(1, "xyz"[k]); };
  Plot speeds{"speeds", "Speeds: " + what, time.label, "speed [m/s]", false, false, {}};
  Plot paths{"paths",
             "Outlines at the start (grey) and the end, paths of the centres: " + what,
             axis(plane.first) + " [m]",
             axis(plane.second) + " [m]",
             false,
             false,
             {},
             true};
  // A legend of more than a dozen bodies would be longer than the plot.
  constexpr std::size_t legend_cap = 12;
  const auto of_body = [&](std::size_t b, const char* column) { return fmt::format("${} == {}", column, b + 1); };
  constexpr int grey = 8;
  for (std::size_t b = 0; b < count; ++b)
    paths.curves.push_back({"outlines.csv", "3", "4", "", false, grey, of_body(b, "1") + " && strcol(2) eq 'start'"});
  for (std::size_t b = 0; b < count; ++b) {
    const std::string legend = count <= legend_cap ? fmt::format("body {}", b + 1) : "";
    const int style = static_cast<int>(b % 8);
    speeds.curves.push_back({"trajectory.csv", time.column, "(sqrt($6**2 + $7**2 + $8**2))", legend, false, style, of_body(b, "2")});
    paths.curves.push_back({"outlines.csv", "3", "4", legend, false, style, of_body(b, "1") + " && strcol(2) eq 'end'"});
    paths.curves.push_back(
        {"trajectory.csv", std::to_string(3 + plane.first), std::to_string(3 + plane.second), "", false, style, of_body(b, "2")});
  }
  return {speeds, paths, energy_plot("energy.csv", 4, record.instants, "Where the energy is: " + what)};
}

}  // namespace scalebreak::report

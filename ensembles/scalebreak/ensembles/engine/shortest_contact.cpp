#include <scalebreak/ensembles/engine/shortest_contact.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/scene/flow_scene.hpp>

namespace scalebreak {
namespace {

constexpr double collision_tolerance = 1e-6;
/// A pair that sticks has no contact time; a little above its sticking speed it has.
constexpr double above_sticking = 2;

struct Meeting {
  Bodies bodies;
  std::string of;
};

/// Everyone who can meet, of the original system.
std::vector<Meeting> meetings(const Input& input, const std::array<double, 2>& smallest, bool walls) {
  const double size = size_factor(*find_scaling_law(input.scaling_law), input.scaling_factor);
  const Material* const materials[] = {&input.material, &input.second};
  constexpr const char* names[] = {"[material]", "[second]"};
  std::vector<Meeting> all;
  for (const std::size_t a : {0, 1}) {
    if (smallest[a] == 0) continue;
    for (std::size_t b = a; b < 2; ++b) {
      if (smallest[b] == 0) continue;
      all.push_back({{*materials[a], *materials[b], input.wall, {smallest[a] / size, smallest[b] / size}},
                     fmt::format("{} with {}", names[a], names[b])});
    }
    if (walls) all.push_back({{*materials[a], *materials[a], input.wall, {smallest[a] / size}}, fmt::format("{} with [wall]", names[a])});
  }
  return all;
}

ShortestContact contact_between(const Input& input, const Meeting& who, const MeetingSpeed& meeting, const TableStore* tables) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  const ScaledContact contact(input.contact, who.bodies, law, input.scaling_factor);
  const double speed = std::max(meeting.speed, above_sticking * contact.sticking_speed(collision_tolerance).value_or(0));
  ShortestContact result{.meeting = meeting, .of = who.of};
  if (!tables) {
    result.resolved = "no tables are used";
  } else if (law.direct_force) {
    result.resolved = fmt::format("the direct-force law {} has no table", law.name);
  } else {
    const ReducedCollision problem = contact.reduced(speed);
    const std::optional<TableRow> row = obtain_table({contact.kind(), input.table_tolerance}, *tables).table.row(problem.damping_ratio);
    const std::optional<TableOutcome> found = row ? row->find(problem.speed) : std::nullopt;
    result.tabulated = found.has_value();
    if (found) {
      result.time = found->contact_time * problem.scales.time * contact.scaled().time;
      return result;
    }
    result.resolved = "the table does not reach so far";
  }
  result.time = contact.collide(speed, collision_tolerance).contact_time.value_or(0);
  return result;
}

}  // namespace

MeetingSpeed fastest_meeting(const CellInput& cell, const Eigen::Vector3d& size, double largest_radius, double speed, double density) {
  const MeetingSpeed all[] = {{"speed at the start", speed},
                              {"shear rate x diameter", mean_shear_rate(cell, size.z()) * 2 * largest_radius},
                              {"wall speed", cell.wall_speed},
                              {"fall through the cell", std::sqrt(2 * cell.gravity.cwiseAbs().dot(size))},
                              {"pressure", std::sqrt(cell.pressure / density)}};
  const MeetingSpeed fastest =
      *std::max_element(std::begin(all), std::end(all), [](const MeetingSpeed& a, const MeetingSpeed& b) { return a.speed < b.speed; });
  return fastest.speed > 0 ? fastest : MeetingSpeed{};
}

ShortestContact shortest_contact(const Input& input, const std::array<double, 2>& smallest, bool walls, const MeetingSpeed& meeting,
                                 const TableStore* tables) {
  ShortestContact shortest{.meeting = meeting};
  if (meeting.speed == 0) return shortest;
  for (const Meeting& who : meetings(input, smallest, walls)) {
    const ShortestContact contact = contact_between(input, who, meeting, tables);
    if (contact.time > 0 && (shortest.time == 0 || contact.time < shortest.time)) shortest = contact;
  }
  return shortest;
}

}  // namespace scalebreak

#include <scalebreak/start/touching_contacts.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <scalebreak/cell/cell_grid.hpp>
#include <scalebreak/scene/check_bodies.hpp>

namespace scalebreak {

std::vector<ContactMemory> touching_contacts(const System& system) {
  std::vector<ContactMemory> contacts;
  if (system.count() == 0) return contacts;
  double fastest = 0;
  for (const Eigen::Vector3d& velocity : system.velocity) fastest = std::max(fastest, velocity.norm());
  const auto touch = [&](double gap, double radius, double approach) {
    return gap <= touching_gap * radius && gap >= -touching_overlap * radius && std::abs(approach) <= resting_speed * fastest;
  };
  const auto add = [&](std::size_t first, std::int32_t second) {
    contacts.push_back({.first = static_cast<std::int32_t>(first), .second = second, .begun = system.time});
  };
  const double reach = 2 * touching_gap * *std::max_element(system.radius.begin(), system.radius.end());
  CellGrid(system.cell, system.position, system.radius, reach)
      .for_each_pair([&](std::uint32_t i, std::uint32_t j, const Eigen::Vector3d& difference) {
        const double distance = difference.norm(), gap = distance - system.radius[i] - system.radius[j];
        const double approach = (system.velocity[i] - system.velocity[j]).dot(difference) / distance;
        if (touch(gap, std::min(system.radius[i], system.radius[j]), approach))
          add(std::min(i, j), static_cast<std::int32_t>(std::max(i, j)));
      });
  for (std::size_t i = 0; i < system.count(); ++i) {
    for (const int axis : {0, 1, 2}) {
      if (!system.cell.walled(axis)) continue;
      for (const bool upper : {false, true}) {
        const double place = upper ? system.cell.size[axis] : 0;
        if (touch(std::abs(place - system.position[i][axis]) - system.radius[i], system.radius[i], system.velocity[i][axis]))
          add(i, wall_number(axis, upper));
      }
    }
  }
  std::sort(contacts.begin(), contacts.end(),
            [](const ContactMemory& a, const ContactMemory& b) { return std::pair(a.first, a.second) < std::pair(b.first, b.second); });
  return contacts;
}

}  // namespace scalebreak

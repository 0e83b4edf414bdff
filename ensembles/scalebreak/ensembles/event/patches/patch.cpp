#include <scalebreak/ensembles/event/patches/patch.hpp>

#include <algorithm>

namespace scalebreak {

void Patch::advance_to(double time) {
  const double span = time - group.time();
  group.advance_to(time, 2 * swerve(span) + group.laws().largest_reach());
  for (Offset& each : offset) each.shift.x() += each.drift * span;
}

void Patch::absorb(const Patch& other, const Offset& by) {
  group.absorb(other.group, by.shift, {by.drift, 0, 0});
  sphere.insert(sphere.end(), other.sphere.begin(), other.sphere.end());
  for (const Offset& each : other.offset) offset.push_back({each.shift + by.shift, each.drift + by.drift});
  fastest = std::max(fastest, other.fastest);
  look_at_speeds();
}

Patch Patch::part(const std::vector<std::uint32_t>& which) const {
  Patch part{group.part(which), {}, {}, fastest};
  for (const std::uint32_t k : which) part.sphere.push_back(sphere[k]), part.offset.push_back(offset[k]);
  return part;
}

void Patch::look_at_speeds() {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::uint32_t k = 0; k < group.count(); ++k) mean += group.velocity(k) / group.count();
  double most = 0;
  for (std::uint32_t k = 0; k < group.count(); ++k) {
    const GroupSphere one = group.sphere(k);
    most = std::max(most, (one.velocity - mean).norm() + (group.laws().turns() ? one.radius * one.spin.norm() : 0.0));
  }
  for (const dem::WallView& wall : group.laws().walls()) most = std::max(most, (mean - Eigen::Vector3d(wall.velocity.x, 0, 0)).norm());
  fastest = std::max(fastest, 2 * most);
}

}  // namespace scalebreak

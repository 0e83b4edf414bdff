#include <scalebreak/ensembles/event/patches/patch.hpp>

#include <algorithm>
#include <cmath>

namespace scalebreak {
namespace {

/// A bound on how fast any two surfaces of a group come together [m/s].
double fastest_meeting(const DemGroup& group) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::uint32_t k = 0; k < group.count(); ++k) mean += group.velocity(k) / group.count();
  double most = 0;
  for (std::uint32_t k = 0; k < group.count(); ++k) {
    const GroupSphere one = group.sphere(k);
    most = std::max(most, (one.velocity - mean).norm() + (group.laws().turns() ? one.radius * one.spin.norm() : 0.0));
  }
  for (const dem::WallView& wall : group.laws().walls()) most = std::max(most, (mean - Eigen::Vector3d(wall.velocity.x, 0, 0)).norm());
  return 2 * most;
}

}  // namespace

void Patch::add(std::uint32_t number, const GroupSphere& which, const Offset& by) {
  group.add(which);
  sphere.push_back(number), offset.push_back(by), push.push_back(0);
}

void Patch::advance_to(double time, double forget) {
  const double span = time - group.time();
  // Twice as much, as they may be pushed on the way; what adheres is held further off than touch.
  group.advance_to(time, 2 * fastest_meeting(group) * span + 2 * group.laws().largest_reach());
  for (Offset& each : offset) each.shift.x() += each.drift * span;
  const double keep = std::exp2(-span / forget);
  for (double& each : push) each *= keep;
}

double Patch::best_stretch(double most) const {
  constexpr double noticeable = 0.005, least = 1.0 / 8;
  double radius = group.radius(0);
  for (std::uint32_t k = 1; k < group.count(); ++k) radius = std::min(radius, group.radius(k));
  return std::clamp(noticeable * radius / std::max(fastest_meeting(group), 1e-300), least * most, most);
}

void Patch::absorb(const Patch& other, const Offset& by) {
  group.absorb(other.group, by.shift, {by.drift, 0, 0});
  sphere.insert(sphere.end(), other.sphere.begin(), other.sphere.end());
  push.insert(push.end(), other.push.begin(), other.push.end());
  for (const Offset& each : other.offset) offset.push_back({each.shift + by.shift, each.drift + by.drift});
}

Patch Patch::part(const std::vector<std::uint32_t>& which) const {
  Patch part{group.part(which), {}, {}, stretch, {}};
  for (const std::uint32_t k : which) part.sphere.push_back(sphere[k]), part.offset.push_back(offset[k]), part.push.push_back(push[k]);
  return part;
}

}  // namespace scalebreak

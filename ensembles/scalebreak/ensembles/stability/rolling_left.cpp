#include <scalebreak/ensembles/stability/rolling_left.hpp>

#include <algorithm>
#include <cmath>

#include <scalebreak/dem/dem.hpp>
#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>

namespace scalebreak {
namespace {

constexpr double looked_at = 0.1;  ///< of the motion, at its end

/// R* |ω_rel| without its twist, of a pair whose line of centres is `branch`. A plane has no spin, and an infinite radius.
double rolling_speed(const MovingBody& a, const MovingBody& b, const Eigen::Vector3d& branch, const Eigen::Vector3d& spin) {
  const double curvature = (a.plane ? 0 : 1 / a.radius) + (b.plane ? 0 : 1 / b.radius);
  return (spin - spin.dot(branch) / branch.squaredNorm() * branch).norm() / curvature;
}

Eigen::Vector3d branch_of(const MovingBody& a, const MovingBody& b) {
  return a.plane || b.plane ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(b.position - a.position);
}

bool touch(const MovingBody& a, const MovingBody& b) {
  const double reach = (a.plane ? 0 : a.radius) + (b.plane ? 0 : b.radius);
  return (a.plane || b.plane ? std::abs(a.position.z() - b.position.z()) : (a.position - b.position).norm()) < reach;
}

/// Of what the soft-sphere engine holds.
double rolling_speed(const CollisionScene& scene, const Dem& dem) {
  const System now = dem.system();
  double largest = 0;
  for (const ContactForce& contact : dem.contact_forces()) {
    if (!contact.touching) continue;
    const auto first = static_cast<std::size_t>(contact.first);
    const bool wall = contact.second < 0;
    const MovingBody& a = scene.moving.bodies[first];
    const MovingBody& b = wall ? scene.moving.bodies.back() : scene.moving.bodies[static_cast<std::size_t>(contact.second)];
    const Eigen::Vector3d other = wall ? Eigen::Vector3d::Zero() : Eigen::Vector3d(now.spin[static_cast<std::size_t>(contact.second)]);
    largest = std::max(largest, rolling_speed(a, b, contact.branch, now.spin[first] - other));
  }
  return largest;
}

}  // namespace

bool comes_to_rest(const CollisionScene& scene, double share) {
  if (scene.duration == 0 || scene.input.surface.rolling == RollingModel::none) return false;
  const auto& end = scene.reference.bodies;
  bool touches = false;
  for (std::size_t i = 0; i < end.size(); ++i) {
    for (std::size_t j = i + 1; j < end.size(); ++j) {
      if (!touch(end[i], end[j])) continue;
      touches = true;
      if (rolling_speed(end[i], end[j], branch_of(end[i], end[j]), end[i].spin - end[j].spin) > share * scene.speed) return false;
    }
  }
  return touches;
}

double rolling_left(const CollisionScene& scene, Integrator integrator, double step_fraction, int phases) {
  double largest = 0;
  for (int k = 0; k < phases; ++k) {
    const SteppedStart start = stepped_start(scene, integrator, step_of(scene, step_fraction), (k + 0.5) / phases);
    Dem dem(start.system, start.setup);
    dem.keep_sums(false);
    const long looks = std::max(1L, static_cast<long>(looked_at * static_cast<double>(start.steps)));
    if (start.steps > looks) dem.advance(start.steps - looks);
    for (long look = 0; look < looks; ++look) {
      dem.advance(1);
      largest = std::max(largest, rolling_speed(scene, dem));
    }
  }
  return largest / scene.speed;
}

}  // namespace scalebreak

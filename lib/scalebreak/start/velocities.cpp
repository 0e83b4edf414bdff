#include <scalebreak/start/velocities.hpp>

#include <cmath>

#include <fmt/format.h>
#include <boost/random/normal_distribution.hpp>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

void take_out_momentum(System& system) {
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  double mass = 0;
  for (std::size_t i = 0; i < system.count(); ++i) {
    momentum += system.mass[i] * system.velocity[i];
    mass += system.mass[i];
  }
  for (Eigen::Vector3d& velocity : system.velocity) velocity -= momentum / mass;
}

void set_root_mean_square(System& system, double speed) {
  double sum = 0;
  for (const Eigen::Vector3d& velocity : system.velocity) sum += velocity.squaredNorm();
  const double factor = speed / std::sqrt(sum / static_cast<double>(system.count()));
  for (Eigen::Vector3d& velocity : system.velocity) velocity *= factor;
}

}  // namespace

void set_velocities(System& system, double speed, std::mt19937_64& random) {
  system.velocity.assign(system.count(), Eigen::Vector3d::Zero());
  if (speed > 0) {
    if (system.count() < 2)
      throw InputError(
          fmt::format("particles.speed: found {:g} for a single sphere; allowed: 0, as the total momentum is to be zero", speed));
    boost::random::normal_distribution<double> normal;
    for (Eigen::Vector3d& velocity : system.velocity) {
      for (int axis = 0; axis < 3; ++axis) velocity[axis] = normal(random);
    }
    for (int again = 0; again < 2; ++again) {  // the second time takes out what rounding left
      take_out_momentum(system);
      set_root_mean_square(system, speed);
    }
  }
  for (std::size_t i = 0; i < system.count(); ++i) system.velocity[i] += mean_flow(system.cell, system.position[i].z());
}

}  // namespace scalebreak

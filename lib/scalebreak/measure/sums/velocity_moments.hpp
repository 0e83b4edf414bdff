#pragma once

#include <Eigen/Core>

namespace scalebreak {

/// Moments of the velocities of a slab's spheres, from which the spread about any profile that is linear across the slab follows
/// afterwards. Linear in its content, so it may be added up and averaged over time.
///
/// Entries, with a weight w and the place s in [0, 1] across the slab: Σw, Σws, Σws², Σwv, Σwsv, Σwvvᵀ (xx, yy, zz, xy, xz, yz).
using VelocityMoments = Eigen::Array<double, 15, 1>;

inline void add_velocity(Eigen::Ref<VelocityMoments> moments, double weight, double place, const Eigen::Vector3d& v) {
  moments.head<3>() += weight * Eigen::Array3d(1, place, place * place);
  moments.segment<3>(3) += weight * v.array();
  moments.segment<3>(6) += weight * place * v.array();
  moments.segment<3>(9) += weight * v.array().square();
  moments.tail<3>() += weight * Eigen::Array3d(v.x() * v.y(), v.x() * v.z(), v.y() * v.z());
}

/// Σ w (v − u)(v − u)ᵀ about the profile u that goes linearly from `lower` to `upper` across the slab.
[[nodiscard]] inline Eigen::Matrix3d spread(const VelocityMoments& moments, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  const Eigen::Vector3d slope = upper - lower;
  const Eigen::Vector3d sum = moments.segment<3>(3), placed = moments.segment<3>(6);
  Eigen::Matrix3d square = moments.segment<3>(9).matrix().asDiagonal();
  square(0, 1) = square(1, 0) = moments[12];
  square(0, 2) = square(2, 0) = moments[13];
  square(1, 2) = square(2, 1) = moments[14];
  const Eigen::Matrix3d mixed = lower * sum.transpose() + slope * placed.transpose();
  const Eigen::Matrix3d cross = lower * slope.transpose();
  return square - mixed - mixed.transpose() + moments[0] * lower * lower.transpose() + moments[1] * (cross + cross.transpose()) +
         moments[2] * slope * slope.transpose();
}

}  // namespace scalebreak

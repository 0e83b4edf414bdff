#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

// When spheres that fly freely meet, as times from now on; infinite where they never do. Roots are taken in the form without
// cancellation, and a sphere that overlaps by rounding and approaches meets now.

namespace scalebreak {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// In this order of additions, whatever compiles it.
[[nodiscard, gnu::always_inline]] inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// When two centres a vector `apart`, in relative motion at `velocity`, come to the distance: |apart + velocity t| = distance.
[[nodiscard, gnu::always_inline]] inline double time_to_meet(const Eigen::Vector3d& apart, const Eigen::Vector3d& velocity,
                                                             double distance) {
  const double approach = dot(apart, velocity);
  if (approach >= 0) return never;
  const double gap = dot(apart, apart) - distance * distance;
  const double discriminant = approach * approach - dot(velocity, velocity) * gap;
  if (discriminant < 0) return never;
  return std::max(0.0, gap / (std::sqrt(discriminant) - approach));
}

/// The square of the least distance that two centres a vector `apart`, in relative motion at `velocity`, come to within `horizon`.
[[nodiscard]] inline double least_square_distance(const Eigen::Vector3d& apart, const Eigen::Vector3d& velocity, double horizon) {
  const double square = velocity.squaredNorm();
  const double time = square > 0 ? std::clamp(-apart.dot(velocity) / square, 0.0, horizon) : 0.0;
  return (apart + time * velocity).squaredNorm();
}

/// When a height above a wall, changing at `velocity` and `acceleration`, falls to `radius`.
[[nodiscard]] inline double time_to_wall(double height, double velocity, double acceleration, double radius) {
  const double gap = height - radius;
  if (gap <= 0) {  // by rounding, or as a contact that lasts has put it: then it comes back only by acceleration
    if (velocity < 0 || (velocity == 0 && acceleration < 0)) return 0;
    if (acceleration >= 0) return never;
    const double above = velocity * velocity - 2 * acceleration * gap;  // does it come out at all?
    return (velocity + (above > 0 ? std::sqrt(above) : velocity)) / -acceleration;
  }
  const double discriminant = velocity * velocity - 2 * acceleration * gap;
  if (discriminant < 0) return never;
  const double root = std::sqrt(discriminant);
  if (velocity < 0) return 2 * gap / (root - velocity);
  return acceleration < 0 ? (velocity + root) / -acceleration : never;
}

/// When |away + velocity t| grows to `allowance` − `shrinking` t; now if it is that far already.
[[nodiscard]] inline double time_to_leave(const Eigen::Vector3d& away, const Eigen::Vector3d& velocity, double allowance,
                                          double shrinking) {
  const double left = away.squaredNorm() - allowance * allowance;
  if (allowance <= 0 || left >= 0) return 0;
  const double square = velocity.squaredNorm() - shrinking * shrinking;
  const double half = away.dot(velocity) + shrinking * allowance;
  return -left / (half + std::sqrt(std::max(0.0, half * half - square * left)));
}

}  // namespace scalebreak

#pragma once

#include <Eigen/Core>

namespace scalebreak {

/// A sphere on its path since its last event: one cache line, all that its neighbours look at. SI; times are relative ones.
struct alignas(64) FlyingSphere {
  Eigen::Vector3d position{0, 0, 0};  ///< at `time`; not brought back into the cell
  double time = 0;
  Eigen::Vector3d velocity{0, 0, 0};  ///< at `time`
  double radius = 0;
};
static_assert(sizeof(FlyingSphere) == 64);

/// On a parabola, or without gravity on a line: the same expression, so that a scene without gravity does not pay for it.
template <bool falls>
[[nodiscard, gnu::always_inline]] inline Eigen::Vector3d position_at(const FlyingSphere& sphere, double time,
                                                                     const Eigen::Vector3d& gravity) {
  const double flown = time - sphere.time;
  if constexpr (falls) return sphere.position + flown * (sphere.velocity + flown / 2 * gravity);
  return sphere.position + flown * sphere.velocity;
}

template <bool falls>
[[nodiscard, gnu::always_inline]] inline Eigen::Vector3d velocity_at(const FlyingSphere& sphere, double time,
                                                                     const Eigen::Vector3d& gravity) {
  if constexpr (falls) return sphere.velocity + (time - sphere.time) * gravity;
  return sphere.velocity;
}

}  // namespace scalebreak

#pragma once

#include <array>

#include <Eigen/Core>

#include <scalebreak/cell/boundary.hpp>

namespace scalebreak {

/// The place of a flow: a box with its lower corner at the origin. Flow is along x, the gradient along z, vorticity along y.
///
/// Lees–Edwards: with `shear_rate` the image above the upper z face moves at shear_rate × size.z along x and is displaced by
/// `shear_offset` (in [0, size.x)). Walls: the lower z wall moves at −wall_speed along x, the upper one at +wall_speed.
struct Cell {
  Eigen::Vector3d size{0, 0, 0};  ///< [m]
  std::array<Boundary, 3> boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  double shear_rate = 0;    ///< of the images across z [1/s]
  double shear_offset = 0;  ///< of the image above, along x [m]
  double wall_speed = 0;    ///< [m/s]

  bool operator==(const Cell&) const = default;

  [[nodiscard]] bool periodic(int axis) const { return boundary[static_cast<std::size_t>(axis)] == Boundary::periodic; }
  [[nodiscard]] bool walled(int axis) const { return boundary[static_cast<std::size_t>(axis)] == Boundary::wall; }
  [[nodiscard]] double volume() const { return size.prod(); }
};

/// From one centre to the nearest image of another: their difference, brought back across the periodic faces.
[[nodiscard]] Eigen::Vector3d nearest_image(const Cell& cell, Eigen::Vector3d difference);

/// The velocity of that nearest image beyond the sphere's own: shear_rate × size.z along x for each crossing of z.
[[nodiscard]] Eigen::Vector3d image_velocity(const Cell& cell, const Eigen::Vector3d& difference);

/// A centre brought back into the cell, and the velocity that it has there.
void wrap(const Cell& cell, Eigen::Vector3d& position, Eigen::Vector3d& velocity);

/// The cell a time later: its upper image has moved on.
[[nodiscard]] Cell advanced(Cell cell, double time);

/// The mean flow at a height in homogeneous shear: shear_rate (z − size.z/2) along x, so that the net momentum is zero.
[[nodiscard]] Eigen::Vector3d mean_flow(const Cell& cell, double height);

}  // namespace scalebreak

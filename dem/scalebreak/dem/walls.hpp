#pragma once

#include <vector>

#include <scalebreak/cell/cell.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>

namespace scalebreak::dem {

/// The walls of a cell; `stops_spin`: a sphere that touches one has no spin.
[[nodiscard]] inline std::vector<WallView> walls_of(const Cell& cell, bool stops_spin) {
  std::vector<WallView> walls;
  for (const int axis : {0, 1, 2}) {
    if (!cell.walled(axis)) continue;
    for (const double side : {-1.0, 1.0}) {
      WallView wall{.axis = axis, .side = side, .place = side < 0 ? 0.0 : cell.size[axis], .stops_spin = stops_spin};
      if (axis == 2) wall.velocity.x = side * cell.wall_speed;
      walls.push_back(wall);
    }
  }
  return walls;
}

}  // namespace scalebreak::dem

#pragma once

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// The tilt xz of LAMMPS' box: the displacement of the upper image along x, by the nearer way, within half the length.
[[nodiscard]] inline double lammps_tilt(const Cell& cell) {
  return cell.shear_offset > cell.size.x() / 2 ? cell.shear_offset - cell.size.x() : cell.shear_offset;
}

}  // namespace scalebreak

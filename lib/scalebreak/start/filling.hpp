#pragma once

#include <cstdint>
#include <vector>

#include <scalebreak/cell/cell.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// What a cell is to be filled with, SI; one entry a sphere in every list.
struct Filling {
  Cell cell;
  std::vector<double> radius;          ///< [m]
  std::vector<std::uint8_t> material;  ///< as in System
  std::vector<double> mass;            ///< [kg]
  double speed = 0;                    ///< root mean square of the speeds about the mean flow, the same for every size [m/s]
  std::uint64_t seed = 0, replica = 0;
  double gap = 1e-6;  ///< least distance of two surfaces over the sum of their radii, and of a surface from a face over the radius
};

/// Spheres at random without overlap: random centres, moved apart and shaken, so that the structure is that of a fluid of hard
/// spheres, not of a crystal. Reaches a volume fraction of 0.6 in a periodic cell with spheres of one size; they keep clear of
/// faces that are not periodic. Velocities are Maxwellian about the mean flow of the cell, with the given speed and no momentum
/// about that flow, both to rounding; spins are zero. The same for the same seed and replica, on any platform.
///
/// Throws WorkError with the volume fraction it reached, InputError where a sphere alone does not fit, or is to move alone.
[[nodiscard]] System fill(const Filling& filling);

/// Solid volume over the cell's.
[[nodiscard]] double volume_fraction(const Cell& cell, const std::vector<double>& radius);

}  // namespace scalebreak

#pragma once

#include <string>

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// One frame as OVITO reads it: Lattice (with shear_offset as the x component of its third vector), Origin, pbc, Time, and
/// Properties pos, radius, velo, angular_velocity, mass, material, id, in SI.
[[nodiscard]] std::string extended_xyz(const System& system);

/// Spheres of the last frame, by the same names (also vel and velocity); radius is needed, other properties are skipped. With a
/// Lattice the cell is set, its lower corner at the origin: a face without pbc is `open`. Throws InputError with file and line.
[[nodiscard]] System read_extended_xyz(const std::string& file);

}  // namespace scalebreak

#pragma once

#include <string>

#include <scalebreak/scene/flow_input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// One frame as OVITO reads it: Lattice (with shear_offset as the x component of its third vector), Origin, pbc, Time, and
/// Properties pos, then of radius, velo, angular_velocity, mass and material those that are among the fields, and id, in SI.
[[nodiscard]] std::string extended_xyz(const System& system, const ParticleFields& fields = all_particle_fields);

/// Spheres of the last frame, by the same names (also vel and velocity); radius is needed, other properties are skipped. With a
/// Lattice the cell is set, its lower corner at the origin: a face without pbc is `open`. Throws InputError with file and line.
[[nodiscard]] System read_extended_xyz(const std::string& file);

}  // namespace scalebreak

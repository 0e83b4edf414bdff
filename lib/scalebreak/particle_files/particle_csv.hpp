#pragma once

#include <string>

#include <scalebreak/scene/flow_input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// One row a sphere: "x [m]", …, "radius [m]", "velocity_x [m/s]", …, "spin_x [rad/s]", …, "mass [kg]", "material [-]": the
/// position, and of the rest the fields.
[[nodiscard]] std::string particles_csv(const System& system, const ParticleFields& fields = all_particle_fields);

/// Spheres by those headers, in any order; velocity, spin, mass and material may be missing, and columns of other names, like
/// "id [-]", are skipped. A known name in another unit is refused. The cell is not in the file. Throws InputError with file and line.
[[nodiscard]] System read_particles_csv(const std::string& file);

}  // namespace scalebreak

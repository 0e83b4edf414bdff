#pragma once

#include <cstdint>
#include <string>

#include <scalebreak/scene/flow_input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// One frame of a LAMMPS dump as text: the step's number, the box, and for each sphere id (from 1), position, and of diameter,
/// velocity, spin, mass and type (material + 1) those whose fields are given, in SI. OVITO and LAMMPS' read_dump read it.
[[nodiscard]] std::string lammps_dump(const System& system, std::uint64_t step, const ParticleFields& fields = all_particle_fields);

}  // namespace scalebreak

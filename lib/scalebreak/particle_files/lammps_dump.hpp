#pragma once

#include <cstdint>
#include <string>

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// One frame of a LAMMPS dump as text: the step's number, the box, and for each sphere id (from 1), type (material + 1), diameter,
/// position, velocity and spin, in SI. OVITO and LAMMPS' read_dump read it.
[[nodiscard]] std::string lammps_dump(const System& system, std::uint64_t step);

}  // namespace scalebreak

#pragma once

#include <string>

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// A LAMMPS data file for atom_style sphere: box (tilted along x across z where the cell is sheared), `id type diameter density x y z`,
/// and velocities with spins, in SI. Type is material + 1.
[[nodiscard]] std::string lammps_data(const System& system);

/// Spheres of such a file, in the order of their ids; the lower corner of the box goes to the origin, and boundaries are periodic:
/// the file does not say. Image flags and other sections are skipped. A tilted box is refused. Throws InputError with file and line.
[[nodiscard]] System read_lammps_data(const std::string& file);

}  // namespace scalebreak

#pragma once

#include <string>

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// Spheres of a file, by its ending: .csv, .xyz or .extxyz (its last frame), .data or .lmp (LAMMPS). `mass` is empty where the file
/// gives none, the cell's size zero where it gives no cell. Throws InputError with file, line, what was found and what is allowed.
[[nodiscard]] System read_particles(const std::string& file);

}  // namespace scalebreak

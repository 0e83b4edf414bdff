#pragma once

#include <random>

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// Gives the spheres Maxwellian velocities about the cell's mean flow: no momentum about that flow, and `speed` [m/s] as root mean
/// square, both to rounding. Throws InputError where a single sphere is to have a speed.
void set_velocities(System& system, double speed, std::mt19937_64& random);

}  // namespace scalebreak

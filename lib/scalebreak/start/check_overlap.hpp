#pragma once

#include <string>

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// Throws InputError where two spheres, or a sphere and a wall, overlap by more than `touching_overlap` of the (smaller) radius; it
/// names the worst pair by its numbers in the list, from 1. `where` stands before the sentence, like "start.csv: ".
void check_no_overlap(const System& system, const std::string& where = "");

/// The least distance of two surfaces over the sum of the radii, or of a surface and a face that is not periodic over the radius;
/// negative where they overlap, and `below` where none is nearer than that.
[[nodiscard]] double least_gap_ratio(const System& system, double below);

}  // namespace scalebreak

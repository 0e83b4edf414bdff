#pragma once

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// How far spheres best go between two lists: far where they fly far, less where a list would grow long. Measured, docs/event_driven.md [m].
[[nodiscard]] double fast_allowance(const System& system);

/// Throws InputError where there are too many spheres, or a periodic edge is too short for the lists of the largest spheres.
void check_room_for_lists(const System& system, double allowance);

}  // namespace scalebreak

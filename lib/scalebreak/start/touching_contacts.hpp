#pragma once

#include <vector>

#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// The contacts of spheres with each other and with walls that touch at rest: overlap up to `touching_overlap` and gap up to `touching_gap` of
/// the (smaller) radius, approach up to `resting_speed` of the largest speed. What attracts at first touch holds them from there on; what
/// does not lets go of them again. Those that approach begin their contacts as all others do.
[[nodiscard]] std::vector<ContactMemory> touching_contacts(const System& system);

}  // namespace scalebreak

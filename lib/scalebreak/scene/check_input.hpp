#pragma once

#include <vector>

#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// Overlap over radius up to which spheres count as touching at the start.
inline constexpr double touching_overlap = 1e-9;

/// Fills in what depends on other keys, then looks for what is missing or cannot go together. Throws InputError.
void complete_and_check(Input& input, const std::vector<Assignment>& given);

}  // namespace scalebreak

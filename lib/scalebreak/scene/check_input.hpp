#pragma once

#include <vector>

#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// Overlap over radius up to which spheres count as touching at the start.
inline constexpr double touching_overlap = 1e-9;

/// Speed across the line of centres over the closing speed up to which bodies meet head-on: directions given in six digits.
inline constexpr double head_on_share = 1e-6;

/// Fills in what depends on other keys, then looks for what is missing or cannot go together. Throws InputError.
void complete_and_check(Input& input, const std::vector<Assignment>& given);

}  // namespace scalebreak

#pragma once

#include <scalebreak/scene/given.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Fills in what depends on other keys, then looks for what is missing or cannot go together. Throws InputError.
void complete_and_check(Input& input, const Given& given);

}  // namespace scalebreak

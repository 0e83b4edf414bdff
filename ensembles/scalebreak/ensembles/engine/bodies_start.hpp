#pragma once

#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// A pair or a few bodies of the SCALED system as a soft-sphere engine starts with them, SI, at time 0: in a cell with open faces, or above
/// a wall. Positions are those of `moving_scene` moved by the same vector; body k is sphere k. Throws InputError where a body is fixed.
[[nodiscard]] System bodies_start(const Input& input);

}  // namespace scalebreak

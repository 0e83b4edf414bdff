#pragma once

#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// The same spheres in the same cell with nothing that takes or gives energy: restitution 1, no adhesion, no friction, rolling or liquid,
/// no shear, no gravity, walls that stand still. What its energy does is the work of the step.
[[nodiscard]] Input elastic_scene(Input input);

}  // namespace scalebreak

#pragma once

#include <scalebreak/ensembles/tradeoff/collision_scene.hpp>

namespace scalebreak {

/// Does a collision end with bodies that touch and, exactly, do not roll on each other any more? "Not": slower than this share of the scene's speed.
[[nodiscard]] bool comes_to_rest(const CollisionScene& scene, double share);

/// The largest rolling speed, R* times the rolling spin, of touching bodies in the last tenth of the motion, over the
/// scene's speed; of starts at so many points of a step.
[[nodiscard]] double rolling_left(const CollisionScene& scene, Integrator integrator, double step_fraction, int phases);

}  // namespace scalebreak

#pragma once

#include <scalebreak/ensembles/tradeoff/collision_scene.hpp>

namespace scalebreak {

/// step_fraction times the Rayleigh time of the smallest body of the scene, scaled [s].
[[nodiscard]] double step_of(const CollisionScene& scene, double step_fraction);

/// A collision by the soft-sphere engine. `step` in s; with a duration it is made a little smaller, so that the end falls on a step. The
/// bodies start `phase` of a step before the scene does (0 to 1), each in free flight. Without a duration it ends when nothing acts any more; what acts still after twice
/// the time that it takes exactly has not parted. Only contacts of solids are counted as force evaluations.
[[nodiscard]] CollisionOutcome step_collision(const CollisionScene& scene, Integrator integrator, double step, double phase);

/// The same by the exact engine.
[[nodiscard]] CollisionOutcome move_collision(const CollisionScene& scene, double tolerance);

}  // namespace scalebreak

#pragma once

#include <scalebreak/dem/dem.hpp>
#include <scalebreak/ensembles/tradeoff/collision_scene.hpp>

namespace scalebreak {

/// step_fraction times the Rayleigh time of the smallest body of the scene, scaled [s].
[[nodiscard]] double step_of(const CollisionScene& scene, double step_fraction);

/// What the soft-sphere engine starts a collision with. `step` in s; with a duration it is made a little smaller, so that the end falls on
/// a step. The bodies start `phase` of a step (0 to 1) before the scene does, each in free flight.
struct SteppedStart {
  System system;
  DemSetup setup;
  long steps = 0;  ///< to the end of the exact motion
};
[[nodiscard]] SteppedStart stepped_start(const CollisionScene& scene, Integrator integrator, double step, double phase);

/// A collision by the soft-sphere engine from that start. Without a duration it ends when nothing acts any more; what acts still after
/// twice the time that it takes exactly has not parted. Of force evaluations those of touching solids are counted.
[[nodiscard]] CollisionOutcome step_collision(const CollisionScene& scene, Integrator integrator, double step, double phase);

/// The same by the exact engine. Throws what `move_bodies` throws.
[[nodiscard]] CollisionOutcome move_collision(const CollisionScene& scene, double tolerance, Stepper stepper = MotionOptions{}.stepper);

}  // namespace scalebreak

#pragma once

#include <string>

#include <scalebreak/dem/dem.hpp>

namespace scalebreak {

/// What became of a flow, or of a collision, at one step.
struct StepTrial {
  double fraction = 0;    ///< of the Rayleigh time
  double step = 0;        ///< [s]
  double collisions = 0;  ///< of each sphere, mean
  double energy_growth =
      0;  ///< logarithm of the energy (kinetic and elastic) at the end over that at the start, per collision of each sphere
  double motion_error = 0;   ///< of a collision: the largest over the phases of a step, CollisionError::motion
  double rolling_left = 0;   ///< of a collision that comes to rest: see rolling_left
  std::string stopped = {};  ///< why it could not go on, a sentence; empty: it went on to the end
};

/// Runs an elastic flow from its start until each sphere has had so many collisions on the mean, or its energy is ten times what it was.
/// A run that the engine stops as unstable is told of in `stopped`. Throws WorkError where nothing collides.
[[nodiscard]] StepTrial try_step(const System& start, const DemSetup& setup, double collisions);

}  // namespace scalebreak

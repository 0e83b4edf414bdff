#pragma once

#include <array>
#include <string>

#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// What the bounds on a step depend on beside the laws, of the scaled system.
struct StepScene {
  std::array<double, 2> smallest = {0, 0};  ///< radius of the spheres of [material] and of [second]; 0: none [m]
  double speed = 0;                         ///< of a collision that occurs [m/s]
};

/// Of the spheres of a start that move at `speed` about the mean flow [m/s]: the fastest of that, of what shear gives two spheres that
/// pass each other (shear rate × largest diameter), and of a fall through the cell.
[[nodiscard]] StepScene step_scene(const Input& input, const System& start, double speed);

/// The same without a start, from the sizes that are expected. Not of a flow that starts from a file.
[[nodiscard]] StepScene expected_step_scene(const Input& input);

/// The step of the soft-sphere engine: step_fraction × Rayleigh's, unless that exceeds a bound (dem/critical_step.hpp) and step_bounds holds.
struct StepChoice {
  double step = 0;           ///< [s]
  double asked = 0;          ///< step_fraction × Rayleigh's [s]
  std::string limit;         ///< what decided: "step_fraction", or the bound that it exceeds
  std::string bound;         ///< the smallest bound
  double bound_step = 0;     ///< its step [s]
  double speed = 0;          ///< of the collision that was looked at [m/s]; 0: nothing moves
  double contact_time = 0;   ///< its contact time [s]; 0: none
  std::string warning = {};  ///< a sentence where step_fraction exceeds a bound
};
[[nodiscard]] StepChoice choose_step(const Input& input, const StepScene& scene);

}  // namespace scalebreak

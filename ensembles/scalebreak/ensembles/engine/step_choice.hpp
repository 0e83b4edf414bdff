#pragma once

#include <array>
#include <string>

#include <scalebreak/ensembles/engine/shortest_contact.hpp>
#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// What the bounds on a step depend on beside the laws, of the scaled system.
struct StepScene {
  std::array<double, 2> smallest = {0, 0};  ///< radius of the spheres of [material] and of [second]; 0: none [m]
  MeetingSpeed meeting;                     ///< the fastest that occurs
  bool walls = false;                       ///< do spheres meet walls?
};

/// Of the spheres of a start that move at `speed` about the mean flow [m/s].
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
  ShortestContact contact;   ///< by which the bound of the contact time goes
  std::string warning = {};  ///< a sentence where step_fraction exceeds a bound
};

/// Contact times come from tables; without `tables` (null) all of them are resolved exactly.
[[nodiscard]] StepChoice choose_step(const Input& input, const StepScene& scene, const TableStore* tables);

}  // namespace scalebreak

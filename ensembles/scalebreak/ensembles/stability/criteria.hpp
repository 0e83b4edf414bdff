#pragma once

#include <span>
#include <vector>

#include <scalebreak/ensembles/stability/step_trial.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// By what a step counts as stable: a number of its trial that must not exceed a limit.
struct StabilityCriterion {
  const char *name, *unit, *meaning;
  const char *plot, *axis;  ///< title and label of a plot of it
  double (*of)(const StepTrial&);
  double Input::*limit;
  bool at_rest = false;  ///< of collisions that end at rest alone

  [[nodiscard]] bool holds(const StepTrial& trial, const Input& input) const { return trial.stopped.empty() && of(trial) <= input.*limit; }
};

/// All criteria of flows, or of collisions.
[[nodiscard]] std::span<const StabilityCriterion> stability_criteria(bool flow);

/// Those that an input is told by: a step is sought for each. Throws what `collision_scene` throws.
[[nodiscard]] std::vector<StabilityCriterion> stability_criteria(const Input& input);

}  // namespace scalebreak

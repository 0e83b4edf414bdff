#pragma once

#include <span>

#include <scalebreak/ensembles/stability/step_trial.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// By what a step counts as stable: a number of its trial that must not exceed a limit.
struct StabilityCriterion {
  const char *name, *unit, *meaning;
  double (*of)(const StepTrial&);
  double Input::*limit;

  [[nodiscard]] bool holds(const StepTrial& trial, const Input& input) const { return trial.stopped.empty() && of(trial) <= input.*limit; }
};

/// All criteria of flows, or of collisions: a step is sought for each.
[[nodiscard]] std::span<const StabilityCriterion> stability_criteria(bool flow);

}  // namespace scalebreak

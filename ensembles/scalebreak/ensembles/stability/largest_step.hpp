#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <scalebreak/ensembles/stability/step_trial.hpp>

namespace scalebreak {

/// Between what steps a flow ceases to be stable, and all that was tried on the way.
struct LargestStep {
  std::optional<StepTrial> stable;    ///< at the largest step found stable; none: unstable down to the smallest tried
  std::optional<StepTrial> unstable;  ///< at the smallest step found unstable; none: stable up to the largest tried
  std::vector<StepTrial> tried;

  /// Both ends of the bracket are known.
  [[nodiscard]] bool found() const { return stable && unstable; }
  [[nodiscard]] double fraction() const;    ///< its geometric middle, of the Rayleigh time; it must be found
  [[nodiscard]] double half_width() const;  ///< of the bracket
};

/// Bisects the step as a fraction of the Rayleigh time, from 1/1000 to 4, until the bracket is narrower than 2 %.
[[nodiscard]] LargestStep largest_step(const std::function<StepTrial(double fraction)>& at,
                                       const std::function<bool(const StepTrial&)>& is_stable);

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <cmath>

#include <scalebreak/collisions/steps/embedded_pairs.hpp>
#include <scalebreak/collisions/steps/step_tries.hpp>

namespace scalebreak {

/// Steps of an embedded pair, as long as the error that it estimates allows: of component i at most the tolerance times system.scale(i).
template <class State, class Pair>
class EmbeddedSteps {
 public:
  EmbeddedSteps(double tolerance, double first_step) : tolerance_(tolerance), next_step_(first_step) {}

  /// A step from `before`, where the rate is `rate`, of at most `longest`; its length. Throws WorkError where there is none.
  template <class System>
  double take(System& system, const State& before, const State& rate, State& after, State& end_rate, double longest) {
    error_ = before;
    for (;;) {
      const double h = std::min(next_step_, longest);
      pair_.step(system, before, rate, after, end_rate, h, error_);
      double norm = 1e-8;
      bool finite = true;
      for (std::size_t i = 0; i < after.size(); ++i) {
        const double ratio = std::abs(error_[i]) / (tolerance_ * system.scale(i));
        finite = finite && std::isfinite(after[i]) && std::isfinite(ratio);
        norm = std::max(norm, ratio);
      }
      tries_.add();
      const double root = Pair::root(norm);
      if (!finite || norm > 1) {
        next_step_ = h * (finite ? std::max(0.2, 0.85 / root) : 0.1);
        StepTries::check(next_step_, finite);
        continue;
      }
      Pair::finish(system, after, end_rate);
      next_step_ = h * std::clamp(0.88 * std::sqrt(last_root_) / root, 0.2, 4.0);
      last_root_ = root;
      return h;
    }
  }

  /// The state at u (0 to 1) of the step that was taken last, of length h.
  template <class System>
  void at(System& system, const State& before, const State& rate, const State& end_rate, double u, double h, State& state) {
    pair_.at(system, before, rate, end_rate, u, h, state);
  }

  /// The motion has changed its law: no longer what the last steps were like.
  void restart() { last_root_ = 1; }

 private:
  Pair pair_;
  double tolerance_;
  double next_step_;
  double last_root_ = 1;
  State error_{};
  StepTries tries_;
};

}  // namespace scalebreak

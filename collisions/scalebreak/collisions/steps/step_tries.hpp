#pragma once

#include <scalebreak/base/error.hpp>

namespace scalebreak {

/// Counts the steps that are tried, and refuses a motion that does not get on.
class StepTries {
 public:
  /// Throws WorkError beyond a cap.
  void add() {
    if (++tries_ > cap)
      throw WorkError("the motion has not ended after 2000000 steps; give its [[body]] scene a run.duration, or a shorter one");
  }

  /// Of a step that was refused, and the next one. Throws WorkError where that is too small.
  static void check(double next, bool finite) {
    if (!(next > 1e-14)) throw WorkError(finite ? "the motion stalled: its step fell to zero" : "the motion left the finite numbers");
  }

 private:
  static constexpr int cap = 2'000'000;
  int tries_ = 0;
};

}  // namespace scalebreak

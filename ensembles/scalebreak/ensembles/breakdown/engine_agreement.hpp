#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/breakdown/study_result.hpp>

namespace scalebreak {

/// How far two engines are apart in one quantity, over all flows that both ran.
struct QuantityAgreement {
  std::string name;
  int flows = 0;
  /// Of their differences over the standard errors of these: a χ² of as many degrees of freedom where the two do the same. A difference over an error
  /// from few runs is Student's; it counts as the normal number that is as seldom (B. L. Welch, Biometrika 34, 28 (1947)).
  double squares = 0;
  double chance = 1;  ///< that noise alone makes as much
};

/// Two engines on the same flows: the same law and factor at the same point.
struct EngineAgreement {
  std::string first, second;
  std::vector<QuantityAgreement> quantities;  ///< what is judged (verdicts.hpp)
  /// All of them, as if they were independent. Those of one flow hang together, so that their sum is larger, or smaller, more often than its chance says.
  QuantityAgreement all;
  std::optional<Comparison> farthest;  ///< the difference that is the least likely
  double farthest_squares = 0;
};

/// Of the first engine of a study with each other one, in the order of the grid.
[[nodiscard]] std::vector<EngineAgreement> engine_agreements(const StudyResult& study);

/// "hybrid and dem on 12 flows, …: granular temperature 11.3 over 12 (probability 0.5), … all 61.0 over 60 (0.44); least likely is shear stress by +3.1 % ± 1.2 %".
[[nodiscard]] std::string sentence(const EngineAgreement& agreement);

}  // namespace scalebreak

#pragma once

#include <string>
#include <vector>

#include <scalebreak/measure/flow_result.hpp>

namespace scalebreak {

/// A quantity that original and scaled systems are compared by.
struct StudyQuantity {
  const char *name, *unit;
  /// What a law that enlarges spheres by l claims to multiply it by, as a power of l: speeds, densities and stresses are kept, lengths and
  /// times grow as l (Hu 2024, SUP, method 1). Laws of stiffness claim to keep everything.
  double size_power;
  const char* what;  ///< for people
};

/// All of them, in the order of the files. Those named `…_middle` are means over the middle of a gap, 0.2 to 0.8 of its height (Washino et al. 2024, Fig. 13).
[[nodiscard]] const std::vector<StudyQuantity>& study_quantities();
[[nodiscard]] const StudyQuantity& study_quantity(const std::string& name);

/// Those that a flow has, in that order; `walled`: between walls along z.
[[nodiscard]] std::vector<Quantity> studied(const FlowResult& result, bool walled);

}  // namespace scalebreak

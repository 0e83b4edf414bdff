#pragma once

#include <string>
#include <vector>

#include <scalebreak/measure/flow_result.hpp>
#include <scalebreak/scene/input.hpp>

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

/// Is it a bed, of spheres that fall onto a floor and that nothing drives?
[[nodiscard]] bool is_bed(const Input& scene);

/// Those that a flow has, in that order: the means over a gap between walls along z, the volume fraction of a bed in a bed.
[[nodiscard]] std::vector<Quantity> studied(const FlowResult& result, const Input& scene);

}  // namespace scalebreak

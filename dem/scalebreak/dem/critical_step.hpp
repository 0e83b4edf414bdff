#pragma once

#include <string>
#include <vector>

#include <scalebreak/dem/dem.hpp>

namespace scalebreak {

/// A bound on the step, and where it comes from.
struct StepBound {
  std::string name;  ///< "Rayleigh", "oscillation", "contact time"
  double step = 0;   ///< [s]
};

/// The critical step of the smallest spheres of a flow of the scaled system, the smallest bound first:
///
///     Rayleigh:     π r √(ρ/G) / (0.8766 + 0.163 ν)                       (Washino et al. 2024, eq. 55)
///     linear:       (2π/10 … see there) √(m/k)                            (Washino et al. 2024, eq. 54)
///     contact time: that of a collision at the speeds that occur, over 30 (if `contact_time` is above 0 [s])
///
/// Under a direct-force law the original's times the factor^overlap (Hu 2024, section 3.3.4).
[[nodiscard]] std::vector<StepBound> critical_steps(const DemSetup& setup, double smallest_radius, double contact_time = 0);

/// The Rayleigh step alone, of the scaled system: what step_fraction is a fraction of.
[[nodiscard]] double rayleigh_step(const DemSetup& setup, double smallest_radius);

}  // namespace scalebreak

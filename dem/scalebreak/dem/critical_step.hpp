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

/// The critical steps of the smallest spheres of a flow of the scaled system, the smallest first:
///
///     Rayleigh:     π r √(2ρ(1 + ν)/E) / (0.8766 + 0.163 ν)       of Hertz and JKR contacts (Washino et al. 2024, eq. 55)
///     oscillation:  2π f_l √(m/k), f_l = 0.1                      of linear contacts (Washino et al. 2024, eq. 54)
///     contact time: a thirtieth of it, if `contact_time` is above 0 [s]
///
/// Under a direct-force law they are the original's × l^overlap (Hu 2024, section 3.3.4), and × l^{x/2} where the law makes the inertia of
/// the pair smaller, by l^x.
[[nodiscard]] std::vector<StepBound> critical_steps(const DemSetup& setup, double smallest_radius, double contact_time = 0);

/// The Rayleigh step alone, of the scaled system: what step_fraction is a fraction of.
[[nodiscard]] double rayleigh_step(const DemSetup& setup, double smallest_radius);

}  // namespace scalebreak

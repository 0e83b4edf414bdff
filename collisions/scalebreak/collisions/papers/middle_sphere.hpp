#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <scalebreak/collisions/papers/paper_case.hpp>
#include <scalebreak/collisions/papers/paper_curve.hpp>

// Three spheres in contact range (Washino et al. 2024, section 4): the velocities of the middle one in the variables in which the
// softened system should repeat the original.

namespace scalebreak {

/// The middle sphere of the row, and what is said of it.
inline constexpr std::size_t middle_sphere = 1;
inline constexpr std::array<const char*, 3> middle_quantities = {"velocity_y", "velocity_x", "spin_z"};
inline constexpr std::array<const char*, 3> middle_words = {"normal velocity", "tangential velocity", "spin"};
/// Steps of the grid of dimensionless time on which curves are compared and written.
inline constexpr int middle_grid = 2000;

/// The middle sphere's motion, dimensionless.
struct MiddleCurve {
  CaseSystem system;
  bool rolling = true;
  std::array<PaperCurve, 3> curve;
  bool lost = false;  ///< deeper than spheres go: not followed to the end
  double overlap_over_radius = 0;
  double turned = 0;  ///< [rad]
  int touches = 0;
};

/// The time by which a system as it starts is measured, W eqs 57 and 59 or 83, with radius, mass and stiffness of the middle sphere [s].
[[nodiscard]] double characteristic_time(const Input& input, const CaseSystem& system);

/// Follows a system over a dimensionless duration.
[[nodiscard]] MiddleCurve follow_middle(const Input& input, const CaseSystem& system, double duration);

/// What is said of one system.
struct MiddleComparison {
  CaseSystem system;
  std::array<std::optional<double>, 3> distance;  ///< from the original's curve, over its range
  double overlap_over_radius, overlap_over_reduced_radius, turned;
};

/// The curves on the grid, and the comparisons, a row each.
[[nodiscard]] std::string middle_curves_csv(const std::vector<const MiddleCurve*>& curves, double duration);
[[nodiscard]] std::string middle_limit_csv(const std::vector<MiddleComparison>& comparisons);

/// Plots over the files curves.csv, factors.csv and limit.csv of these two.
[[nodiscard]] std::vector<CasePlot> middle_plots(const Input& input, const std::vector<MiddleCurve>& scaled, bool with_rolling);

}  // namespace scalebreak

#pragma once

#include <array>
#include <cmath>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/contact/reduced.hpp>
#include <scalebreak/table/impact_plane.hpp>

// What the builders of oblique and of rolling tables share.

namespace scalebreak {

/// k_t over what it is reduced by: the linear contact's k, or F_po/δ₀ of adhesion.
[[nodiscard]] inline double reduced_spring(const ContactKind& kind, const NormalPair& pair, double spring_constant) {
  if (!kind.adhesive()) return spring_constant / pair.spring_constant;
  const auto scales = reduce(kind, pair, 1.0).scales;
  return spring_constant * scales.overlap / scales.force;
}

/// The reduced sticking speed squared, 0 without adhesion. Throws WorkError where every collision sticks.
[[nodiscard]] inline double reduced_sticking_squared(const ContactKind& kind, double damping_ratio) {
  const double stick = reduced_sticking_speed(kind, damping_ratio);
  if (!std::isfinite(stick)) throw WorkError("every collision of this pair sticks: its damping ratio is 1 or more");
  return kind.adhesive() ? stick * stick : 0.0;
}

/// Below this share of ψ₀ a speed does not matter, and beyond so many ψ₀ nothing new happens.
inline constexpr double least_ratio = 1e-3, most_ratio = 1e6;

/// Where a table is measured, none of its nodes: the i-th point of Roberts' sequence.
[[nodiscard]] inline std::array<double, 2> sample_point(bool adhesive, int i) {
  const auto at = [i](double step) { return std::fmod(0.5 + step * (i + 1), 1.0); };
  return {adhesive ? at(0.7548776662466927) : 0.5, at(0.5698402909980532)};
}

}  // namespace scalebreak

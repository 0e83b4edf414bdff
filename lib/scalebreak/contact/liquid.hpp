#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scalebreak/base/scalar.hpp>
#include <scalebreak/contact/surface_kind.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// A pendular liquid bridge between two bodies at separation S = −δ (below `separation_min` it is taken as that).
///
/// Capillary force (Rabinovich–Lambert; Washino et al. 2024, eq. 22; Hu 2024, eq. 2.43), in attraction:
///
///     4πR*σ cosθ / (1 + 1/(√(1 + V/(πR*S²)) − 1)),   from first touch to rupture at (1 + θ/2) V^{1/3} (Hu 2024, eq. 2.44)
///
/// Viscous coefficients (Adams & Perchard; Goldman; Washino et al. 2024, eqs 28–30), of the normal speed, the tangential speed
/// of the centres, and the rolling r₁ω₁ + r₂ω₂:
///
///     C_N = 6πμR*²/S,  C_T = 6πμR* (8/15 ln(R*/S) + 0.9588),
///     C_R = 6πμR* (2/15 ln(R*/S) − 0.2526) while that is positive, else 6πμR*/8 q⁴ (1 − 3q/8), q = R*/(S + R*)
template <class T>
struct LiquidOf {
  bool capillary = false, viscous = false;
  AttractionRange range = AttractionRange::bridge;
  T radius = 0;          ///< R* [m]
  T tension = 0;         ///< 4πR*σ cosθ [N]
  T spread = 0;          ///< V/(πR*) [m²]
  T drag = 0;            ///< 6πμR* [N s/m]
  T separation_min = 0;  ///< [m]
  T rupture = 0;         ///< [m]

  [[nodiscard]] static LiquidOf make(const SurfaceKind& kind, const NormalPair& pair, const SurfacePair& surfaces) {
    constexpr double pi = std::numbers::pi;
    return {.capillary = kind.capillary() && surfaces.surface_tension > 0,
            .viscous = kind.viscous() && surfaces.viscosity > 0,
            .range = kind.attraction_range,
            .radius = pair.radius,
            .tension = 4 * pi * pair.radius * surfaces.surface_tension * std::cos(surfaces.contact_angle),
            .spread = surfaces.bridge_volume / (pi * pair.radius),
            .drag = 6 * pi * surfaces.viscosity * pair.radius,
            .separation_min = surfaces.separation_min,
            .rupture = (1 + surfaces.contact_angle / 2) * std::cbrt(surfaces.bridge_volume)};
  }

  [[nodiscard]] bool acts() const { return capillary || viscous; }
  /// Can a bridge outlive the contact of the solids?
  [[nodiscard]] bool bridges() const { return acts() && range == AttractionRange::bridge && rupture > 0; }

  /// Attraction at separation S ≥ separation_min [N].
  [[nodiscard]] T capillary_force(T separation) const {
    using std::sqrt;
    if (!capillary) return T(0);
    // With q = √(1 + spread/S²) the force is tension (q − 1)/q, written so that nothing cancels where q is near 1.
    const T ratio = spread / (separation * separation), q = sqrt(1 + ratio);
    return tension * ratio / (q * (q + 1));
  }
  /// Work done against the capillary force from first touch to separation S, which is negative in contact [J].
  [[nodiscard]] T capillary_energy(T separation) const {
    using std::min, std::sqrt;
    if (!capillary) return T(0);
    const T near = min(separation, separation_min);
    const auto primitive = [&](T s) { return tension * (s - sqrt(s * s + spread)); };
    return near * capillary_force(separation_min) + choose(separation > near, T(primitive(separation) - primitive(separation_min)), T(0));
  }
  [[nodiscard]] T normal_drag(T separation) const { return viscous ? T(drag * radius / separation) : T(0); }
  [[nodiscard]] T tangential_drag(T separation) const {
    using std::log;
    return viscous ? T(drag * (8.0 / 15 * log(radius / separation) + 0.9588)) : T(0);
  }
  [[nodiscard]] T rolling_drag(T separation) const { return rolling_drag(separation, separation >= rolling_branch()); }
  template <class Mask>
  [[nodiscard]] T rolling_drag(T separation, Mask second_branch) const {
    using std::log;
    if (!viscous) return T(0);
    const T q = radius / (separation + radius);
    return choose(second_branch, T(drag / 8 * q * q * q * q * (1 - 3 * q / 8)), T(drag * (2.0 / 15 * log(radius / separation) - 0.2526)));
  }
  /// The separation at which C_R takes its second branch: where its first turns negative.
  [[nodiscard]] T rolling_branch() const { return radius * std::exp(-0.2526 * 15 / 2); }

  /// The same law of another scalar, its numbers given by `value`, a function of a pointer to member of Liquid.
  template <class Value>
  [[nodiscard]] static LiquidOf from(const LiquidOf<double>& form, Value value) {
    using Source = LiquidOf<double>;
    return {form.capillary,          form.viscous,           form.range,           value(&Source::radius),
            value(&Source::tension), value(&Source::spread), value(&Source::drag), value(&Source::separation_min),
            value(&Source::rupture)};
  }
};
using Liquid = LiquidOf<double>;

}  // namespace scalebreak

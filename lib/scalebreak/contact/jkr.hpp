#pragma once

#include <cmath>
#include <numbers>

#include <scalebreak/base/scalar.hpp>
#include <scalebreak/contact/normal_terms.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// Johnson–Kendall–Roberts contact (Chen & Elliott, eqs 8 and 9), γ the surface energy of ONE surface:
///
///     δ = a²/R* − √(4πγa/E*),  F = 4E* a³/(3R*) − 4 √(πγE* a³)
///
/// in the regular coordinate x = √a (see Linear), where both are polynomials and the tear-off fold is
/// an ordinary point. Dashpot: 2√(5/3) β √(m* E* a) on the contact radius (Chen & Elliott, eqs 20–23), or
/// 2√(5/3) β √(m* E*) (R* δ)^{1/4}, zero for δ ≤ 0, on the overlap (Washino et al. 2024, eq. 15).
template <class T, DampingOn damping_on = DampingOn::contact_radius>
struct Jkr {
  T curvature;         ///< 1/R* [1/m]
  T adhesive_overlap;  ///< √(4πγ/E*) [m^{1/2}]
  T stiffness;         ///< 4E*/(3R*) [N/m³]
  T adhesive_force;    ///< 4 √(πγE*) [N/m^{3/2}]
  T dashpot;           ///< 2√(5/3) β √(m* E*) [N s/m^{3/2}]
  T radius;            ///< R* [m]
  AdhesionRange range;

  static constexpr NormalTraits traits{.name = "jkr",
                                       .without_adhesion = "hertz",
                                       .furthest_end = AdhesionRange::full,
                                       .damping_on = damping_on,
                                       .coordinate = Coordinate::radius_root};

  /// The surface energy must be positive: without it the contact is Hertz's.
  [[nodiscard]] static Jkr make(const NormalPairOf<T>& pair, AdhesionRange range) {
    using std::sqrt;
    const T pi_gamma = std::numbers::pi_v<T> * pair.surface_energy;
    return {1 / pair.radius,
            sqrt(4 * pi_gamma / pair.young),
            4 * pair.young / (3 * pair.radius),
            4 * sqrt(pi_gamma * pair.young),
            2 * sqrt(T(5) / 3) * pair.damping_ratio * sqrt(pair.mass * pair.young),
            pair.radius,
            range};
  }

  /// √a_0, δ_0, τ, F_po (see reduced.hpp), whatever the speed.
  [[nodiscard]] static ReducedScales<T> scales(const NormalPairOf<T>& pair, T) {
    using std::cbrt, std::sqrt;
    const T pi_gamma = std::numbers::pi_v<T> * pair.surface_energy;
    const T contact_radius = cbrt(9 * pi_gamma * pair.radius * pair.radius / pair.young);
    const T unit = contact_radius * contact_radius / pair.radius;
    const T force_unit = 3 * pi_gamma * pair.radius;
    return {sqrt(contact_radius), unit, sqrt(pair.mass * unit / force_unit), force_unit};
  }
  [[nodiscard]] static NormalPairOf<T> reduced_pair(T beta) {
    return {
        .mass = 1, .radius = 1, .young = 3, .surface_energy = 1 / (3 * std::numbers::pi_v<T>), .spring_constant = 1, .damping_ratio = beta};
  }
  /// The pair R* = E* = m* = 1 that, hit at speed 1, has reduced speed v̂: the same collision in the units of its impact, in which
  /// nothing is large when v̂ is.
  [[nodiscard]] static NormalPairOf<T> pair_of_unit_impact(T beta, T reduced_speed) {
    using std::pow;
    const T energy = pow(3 / (reduced_speed * reduced_speed), T(3) / 5) / (9 * std::numbers::pi_v<T>);
    return {.mass = 1, .radius = 1, .young = 1, .surface_energy = energy, .spring_constant = 1, .damping_ratio = beta};
  }

  [[nodiscard]] T overlap(T x) const { return x * (curvature * x * x * x - adhesive_overlap); }
  [[nodiscard]] T overlap_slope(T x) const { return 4 * curvature * x * x * x - adhesive_overlap; }
  [[nodiscard]] T force(T x) const {
    const T cube = x * x * x;
    return cube * (stiffness * cube - adhesive_force);
  }

  [[nodiscard]] T force_slope(T x) const {
    const T square = x * x, cube = square * x;
    return square * (6 * stiffness * cube - 3 * adhesive_force);
  }
  /// F_po = 3πγR* [N].
  [[nodiscard]] T pull_off_force() const { return adhesive_force * adhesive_force / (4 * stiffness); }
  /// F_N of friction: the effective load |4â³ − 4â^{3/2} + 2| F_po (Washino et al. 2024, eq. 18), which is F + 2F_po and
  /// never negative. It holds no dashpot.
  [[nodiscard]] T load(T x, T) const { return force(x) + 2 * pull_off_force(); }
  [[nodiscard]] T load_rate(T x, T x_rate, T) const { return force_slope(x) * x_rate; }
  [[nodiscard]] T root_radius(T x) const { return x; }

  [[nodiscard]] T damping(T x) const {
    using std::sqrt;
    if constexpr (damping_on == DampingOn::contact_radius) {
      return dashpot * x;
    } else {
      return damping_of_root(sqrt(sqrt(positive_part(overlap(x)))));
    }
  }

  [[nodiscard]] T damping_slope(T) const requires(damping_on == DampingOn::contact_radius) { return dashpot; }

  /// The dashpot on the overlap, as a function of w = δ^{1/4}, in which it is smooth.
  [[nodiscard]] T damping_of_root(T w) const requires(damping_on == DampingOn::overlap) {
    using std::sqrt;
    return dashpot / sqrt(sqrt(curvature)) * w;
  }

  /// Work done against the force from first touch (δ = 0, x = touch()) to x [J].
  [[nodiscard]] T energy(T x) const { return primitive(x) - primitive(touch()); }

  /// x at a given overlap: the largest real root of x⁴/R* − √(4πγ/E*) x − δ = 0, without a branch.
  /// Below the fold it returns the fold. Ferrari's resolvent P³ + 4RδP − q² = 0 with q = R√(4πγ/E*),
  /// its root written so that nothing cancels: P = q²/(A² + AB + B²) with A³ − B³ = q², AB = 4Rδ/3.
  [[nodiscard]] T coordinate(T overlap) const {
    using std::sqrt;
    const T q = adhesive_overlap * radius, square = q * q;
    const T third = T(4) / 3 * radius * overlap;
    const T sum = square / 2 + sqrt(positive_part(T(square * square / 4 + third * third * third)));  // A³
    const T inverse = inverse_cube_root(sum);
    const T a = sum * inverse * inverse, b = third * inverse;
    const T root = sqrt(a * a + a * b + b * b);
    const T p = q / root;
    return (p + sqrt(positive_part(T(2 * root - p * p)))) / 2;
  }

  /// The same contact where nothing damps: below zero overlap, of the dashpot on the overlap.
  [[nodiscard]] Jkr<T, DampingOn::contact_radius> undamped() const {
    return {curvature, adhesive_overlap, stiffness, adhesive_force, T(0), radius, range};
  }

  /// x where dδ/dx = 0: no contact exists below (point S).
  [[nodiscard]] T fold() const {
    using std::cbrt;
    return cbrt(adhesive_overlap / (4 * curvature));
  }
  [[nodiscard]] T touch() const {
    using std::cbrt;
    return cbrt(adhesive_overlap / curvature);
  }
  /// x where spring and adhesion balance.
  [[nodiscard]] T bottom() const {
    using std::cbrt;
    return cbrt(adhesive_force / stiffness);
  }
  /// x at the force minimum −3πγR*, where a³ = 9πγR*²/(4E*) (point C).
  [[nodiscard]] T pull_off() const {
    using std::cbrt;
    return cbrt(3 * adhesive_overlap / (4 * curvature));
  }
  /// x where the contact ends, as `range` has it.
  [[nodiscard]] T separation() const {
    switch (range) {
      case AdhesionRange::full: return fold();
      case AdhesionRange::pull_off: return pull_off();
      case AdhesionRange::touch: break;
    }
    return touch();
  }

  /// The same law of another scalar, its numbers given by `value`, a function of a pointer to member.
  template <class Value>
  [[nodiscard]] static Jkr from(const Jkr<double, damping_on>& form, Value value) {
    using Source = Jkr<double, damping_on>;
    return {value(&Source::curvature),
            value(&Source::adhesive_overlap),
            value(&Source::stiffness),
            value(&Source::adhesive_force),
            value(&Source::dashpot),
            value(&Source::radius),
            form.range};
  }

 private:
  /// ∫ F dδ = ∫ F (dδ/dx) dx, term by term.
  [[nodiscard]] T primitive(T x) const {
    const T cube = x * x * x;
    const T fourth = cube * x;
    return fourth *
           (cube * (T(2) / 5 * stiffness * curvature * cube - (stiffness * adhesive_overlap + 4 * adhesive_force * curvature) / 7) +
            adhesive_force * adhesive_overlap / 4);
  }
};

template <class T>
using JkrOnOverlap = Jkr<T, DampingOn::overlap>;
template <class T>
using JkrOnRadius = Jkr<T, DampingOn::contact_radius>;

}  // namespace scalebreak

#pragma once

#include <cmath>

#include <scalebreak/contact/normal_terms.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// Hertz contact with Tsuji's dashpot (Washino et al. 2024, eqs 10 and 15; Antypov & Elliott 2011):
///
///     δ = a²/R*,  F = 4E* a³/(3R*),  η = 2√(5/3) β √(m* E* a)
///
/// in the regular coordinate x = √a (see Linear), where all three are polynomials.
template <class T>
struct Hertz {
  T curvature;  ///< 1/R* [1/m]
  T stiffness;  ///< 4E*/(3R*) [N/m³]
  T dashpot;    ///< 2√(5/3) β √(m* E*) [N s/m^{3/2}]
  T radius;     ///< R* [m]

  static constexpr NormalTraits traits{.name = "hertz"};

  [[nodiscard]] static Hertz make(const NormalPairOf<T>& pair, AdhesionRange) {
    using std::sqrt;
    return {1 / pair.radius, 4 * pair.young / (3 * pair.radius), 2 * sqrt(T(5) / 3) * pair.damping_ratio * sqrt(pair.mass * pair.young),
            pair.radius};
  }

  /// Overlap (m*v²/(E*√R*))^{2/5} of a pair that meets at `speed`; its reduced speed is 1.
  [[nodiscard]] static ReducedScales<T> scales(const NormalPairOf<T>& pair, T speed) {
    using std::pow, std::sqrt;
    const T overlap = pow(pair.mass * speed * speed / (pair.young * sqrt(pair.radius)), T(2) / 5);
    return {sqrt(sqrt(pair.radius * overlap)), overlap, overlap / speed, pair.mass * speed * speed / overlap};
  }
  [[nodiscard]] static NormalPairOf<T> reduced_pair(T beta) {
    return {.mass = 1, .radius = 1, .young = 1, .surface_energy = 0, .spring_constant = 1, .damping_ratio = beta};
  }

  [[nodiscard]] T overlap(T x) const { return curvature * x * x * x * x; }
  [[nodiscard]] T overlap_slope(T x) const { return 4 * curvature * x * x * x; }
  [[nodiscard]] T force(T x) const {
    const T cube = x * x * x;
    return stiffness * cube * cube;
  }
  [[nodiscard]] T force_slope(T x) const {
    const T square = x * x;
    return 6 * stiffness * square * square * x;
  }
  [[nodiscard]] T damping(T x) const { return dashpot * x; }
  [[nodiscard]] T damping_slope(T) const { return dashpot; }
  [[nodiscard]] T load(T, T total_force) const { return total_force; }
  [[nodiscard]] T load_rate(T, T, T total_force_rate) const { return total_force_rate; }
  [[nodiscard]] T root_radius(T x) const { return x; }
  /// Work done against the force from zero overlap to x [J].
  [[nodiscard]] T energy(T x) const {
    const T square = x * x;
    const T fourth = square * square;
    return T(2) / 5 * stiffness * curvature * fourth * fourth * square;
  }
  [[nodiscard]] T coordinate(T overlap) const {
    using std::sqrt;
    return sqrt(sqrt(overlap * radius));
  }
  [[nodiscard]] T touch() const { return T(0); }
  [[nodiscard]] T bottom() const { return T(0); }
  [[nodiscard]] T separation() const { return T(0); }

  /// The same law of another scalar, its numbers given by `value`, a function of a pointer to member.
  template <class Value>
  [[nodiscard]] static Hertz from(const Hertz<double>&, Value value) {
    using Source = Hertz<double>;
    return {value(&Source::curvature), value(&Source::stiffness), value(&Source::dashpot), value(&Source::radius)};
  }
};

}  // namespace scalebreak

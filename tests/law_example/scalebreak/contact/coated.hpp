#pragma once

#include <cmath>
#include <numbers>

#include <scalebreak/contact/normal_terms.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// Spheres with a soft coat of thickness h = R*/10, which gives way like a mattress of springs (Johnson 1985, section 4.3), and a dashpot
/// whose restitution is that put in:
///
///     F = kδ², k = πE*R*/h,  a = √(2R*δ),  η = 2β √(3/2 m*k δ)
///
/// in x = (R*δ)^{1/4}. coated_test.cpp has the closed form of its collisions.
template <class T>
struct Coated {
  T curvature;  ///< 1/R* [1/m]
  T stiffness;  ///< k/R*² [N/m⁴]
  T dashpot;    ///< 2β √(3/2 m*k/R*) [N s/m²]
  T radius;     ///< R* [m]

  static constexpr NormalTraits traits{.name = "coated"};

  [[nodiscard]] static Coated make(const NormalPairOf<T>& pair, AdhesionRange) {
    using std::sqrt;
    const T k = 10 * std::numbers::pi_v<T> * pair.young;
    return {1 / pair.radius, k / (pair.radius * pair.radius), 2 * pair.damping_ratio * sqrt(T(3) / 2 * pair.mass * k / pair.radius),
            pair.radius};
  }

  /// Overlap (m*v²/E*)^{1/3} of a pair that meets at `speed`; its reduced speed is 1.
  [[nodiscard]] static ReducedScales<T> scales(const NormalPairOf<T>& pair, T speed) {
    using std::cbrt, std::sqrt;
    const T unit = cbrt(pair.mass * speed * speed / pair.young);
    return {sqrt(sqrt(pair.radius * unit)), unit, unit / speed, pair.mass * speed * speed / unit};
  }
  [[nodiscard]] static NormalPairOf<T> reduced_pair(T beta) {
    return {.mass = 1, .radius = 1, .young = 1, .surface_energy = 0, .spring_constant = 1, .damping_ratio = beta};
  }

  [[nodiscard]] T overlap(T x) const { return curvature * x * x * x * x; }
  [[nodiscard]] T overlap_slope(T x) const { return 4 * curvature * x * x * x; }
  [[nodiscard]] T force(T x) const {
    const T square = x * x, fourth = square * square;
    return stiffness * fourth * fourth;
  }
  [[nodiscard]] T force_slope(T x) const {
    const T square = x * x;
    return 8 * stiffness * square * square * square * x;
  }
  [[nodiscard]] T damping(T x) const { return dashpot * x * x; }
  [[nodiscard]] T damping_slope(T x) const { return 2 * dashpot * x; }
  [[nodiscard]] T load(T, T total_force) const { return total_force; }
  [[nodiscard]] T load_rate(T, T, T total_force_rate) const { return total_force_rate; }
  [[nodiscard]] T root_radius(T x) const { return T(1.189207115002721) * x; }  // 2^{1/4}
  [[nodiscard]] T energy(T x) const {
    const T square = x * x, fourth = square * square;
    return stiffness * curvature / 3 * fourth * fourth * fourth;
  }
  [[nodiscard]] T coordinate(T overlap) const {
    using std::sqrt;
    return sqrt(sqrt(overlap * radius));
  }
  [[nodiscard]] T touch() const { return T(0); }
  [[nodiscard]] T bottom() const { return T(0); }
  [[nodiscard]] T separation() const { return T(0); }

  template <class Value>
  [[nodiscard]] static Coated from(const Coated<double>&, Value value) {
    using Source = Coated<double>;
    return {value(&Source::curvature), value(&Source::stiffness), value(&Source::dashpot), value(&Source::radius)};
  }
};

}  // namespace scalebreak

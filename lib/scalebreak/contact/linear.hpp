#pragma once

#include <cmath>

#include <scalebreak/contact/normal_terms.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// Linear spring and dashpot: F = k δ + η δ̇ (Washino et al. 2024, eqs 5 and 8).
///
/// A normal law is a set of pure functions of its *regular coordinate* x (see Coordinate), in which force,
/// overlap and damping are smooth: the overlap itself here, the square root of the contact radius for
/// Hertz and JKR. Force is positive in repulsion and holds no damping.
template <class T>
struct Linear {
  T stiffness;  ///< k [N/m]
  T dashpot;    ///< η = 2 β √(m* k) [N s/m]

  static constexpr NormalTraits traits{.name = "linear", .coordinate = Coordinate::overlap, .constant_spring = true};

  [[nodiscard]] static Linear make(const NormalPairOf<T>& pair, AdhesionRange) {
    using std::sqrt;
    return {pair.spring_constant, 2 * pair.damping_ratio * sqrt(pair.mass * pair.spring_constant)};
  }

  /// What the reduced variables of the pair are measured by (see reduced.hpp): √(m*/k) and the impact speed, so that the reduced speed is 1.
  [[nodiscard]] static ReducedScales<T> scales(const NormalPairOf<T>& pair, T speed) {
    using std::sqrt;
    const T time = sqrt(pair.mass / pair.spring_constant);
    return {speed * time, speed * time, time, pair.spring_constant * speed * time};
  }
  /// The pair whose scales at speed 1 are 1.
  [[nodiscard]] static NormalPairOf<T> reduced_pair(T beta) {
    return {.mass = 1, .radius = 1, .young = 1, .surface_energy = 0, .spring_constant = 1, .damping_ratio = beta};
  }

  [[nodiscard]] T overlap(T x) const { return x; }
  [[nodiscard]] T overlap_slope(T) const { return T(1); }
  [[nodiscard]] T force(T x) const { return stiffness * x; }
  [[nodiscard]] T force_slope(T) const { return stiffness; }
  [[nodiscard]] T damping(T) const { return dashpot; }
  [[nodiscard]] T damping_slope(T) const { return T(0); }
  /// F_N of friction, from the normal force with its dashpot: its magnitude (Washino et al. 2024, section 2.2.1).
  [[nodiscard]] T load(T, T total_force) const { return total_force; }
  [[nodiscard]] T load_rate(T, T, T total_force_rate) const { return total_force_rate; }
  /// √a, which is linear in x; this contact has no radius.
  [[nodiscard]] T root_radius(T) const { return T(0); }
  /// Work done against the force from zero overlap to x [J].
  [[nodiscard]] T energy(T x) const { return stiffness * x * x / 2; }
  [[nodiscard]] T coordinate(T overlap) const { return overlap; }
  [[nodiscard]] T touch() const { return T(0); }       ///< x at first contact
  [[nodiscard]] T bottom() const { return T(0); }      ///< x where its potential is least
  [[nodiscard]] T separation() const { return T(0); }  ///< x where the contact ends

  /// The same law of another scalar, its numbers given by `value`, a function of a pointer to member.
  template <class Value>
  [[nodiscard]] static Linear from(const Linear<double>&, Value value) {
    return {value(&Linear<double>::stiffness), value(&Linear<double>::dashpot)};
  }
};

}  // namespace scalebreak

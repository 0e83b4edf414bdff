#pragma once

#include <cmath>

namespace scalebreak {

/// Linear spring and dashpot: F = k δ + η δ̇ (Washino et al. 2024, eqs 5 and 8).
///
/// A normal law is a set of pure functions of its *regular coordinate* x, in which force, overlap and
/// damping are smooth: the overlap itself here, the square root of the contact radius for Hertz and
/// JKR. Force is positive in repulsion and holds no damping.
template <class T>
struct Linear {
  T stiffness;  ///< k [N/m]
  T dashpot;    ///< η = 2 β √(m* k) [N s/m]

  [[nodiscard]] static Linear make(T spring_constant, T mass, T beta) {
    using std::sqrt;
    return {spring_constant, 2 * beta * sqrt(mass * spring_constant)};
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
  /// √a; this contact has no radius.
  [[nodiscard]] T root_radius(T) const { return T(0); }
  /// Work done against the force from zero overlap to x [J].
  [[nodiscard]] T energy(T x) const { return stiffness * x * x / 2; }
  [[nodiscard]] T coordinate(T overlap) const { return overlap; }
  [[nodiscard]] T touch() const { return T(0); }       ///< x at first contact
  [[nodiscard]] T separation() const { return T(0); }  ///< x where the contact ends

  /// The same law of another scalar, its numbers given by `value`, a function of a pointer to member.
  template <class Value>
  [[nodiscard]] static Linear from(const Linear<double>&, Value value) {
    return {value(&Linear<double>::stiffness), value(&Linear<double>::dashpot)};
  }
};

}  // namespace scalebreak

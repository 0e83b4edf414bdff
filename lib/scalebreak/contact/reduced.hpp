#pragma once

#include <cmath>
#include <numbers>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/contact/hertz.hpp>
#include <scalebreak/contact/jkr.hpp>
#include <scalebreak/contact/linear.hpp>
#include <scalebreak/material/pair.hpp>

// The reduced variables: the one place where a pair's size, stiffness, mass and surface energy leave
// the problem. With a_0 = (9πγR*²/E*)^{1/3}, δ_0 = a_0²/R*, F_po = 3πγR*, τ = √(m*δ_0/F_po), â = a/a_0,
// every JKR pair obeys one equation:
//
//     δ̂ = â² − (2/3)√â,   δ̂″ + D δ̂′ + 4(â³ − â^{3/2}) = 0,   D = 2√5 β √â  or  2√5 β δ̂^{1/4}
//
// so that a collision depends on v̂ = vτ/δ_0 and β alone. Hertz and linear contacts have no length of
// their own; they are measured by the impact speed, and depend on β alone.

namespace scalebreak {

/// What one unit of each reduced quantity is, SI.
template <class T>
struct ReducedScales {
  T coordinate;  ///< of √a [m^{1/2}], or of the overlap [m] for a linear contact
  T overlap;     ///< [m]
  T time;        ///< [s]
  T force;       ///< [N]

  [[nodiscard]] T speed() const { return overlap / time; }
};

/// a_0, δ_0, τ, F_po of a JKR pair. `surface_energy` (one surface) must be positive.
template <class T>
[[nodiscard]] ReducedScales<T> jkr_scales(T radius, T young, T surface_energy, T mass) {
  using std::cbrt, std::sqrt;
  const T pi_gamma = std::numbers::pi_v<T> * surface_energy;
  const T contact_radius = cbrt(9 * pi_gamma * radius * radius / young);
  const T overlap = contact_radius * contact_radius / radius;
  const T pull_off_force = 3 * pi_gamma * radius;
  return {sqrt(contact_radius), overlap, sqrt(mass * overlap / pull_off_force), pull_off_force};
}

/// Overlap (m*v²/(E*√R*))^{2/5} of a Hertz pair that meets at `speed`; its reduced speed is 1.
template <class T>
[[nodiscard]] ReducedScales<T> hertz_scales(T radius, T young, T mass, T speed) {
  using std::pow, std::sqrt;
  const T overlap = pow(mass * speed * speed / (young * sqrt(radius)), T(2) / 5);
  return {sqrt(sqrt(radius * overlap)), overlap, overlap / speed, mass * speed * speed / overlap};
}

/// √(m*/k) and the speed measure a linear pair; its reduced speed is 1.
template <class T>
[[nodiscard]] ReducedScales<T> linear_scales(T spring_constant, T mass, T speed) {
  using std::sqrt;
  const T time = sqrt(mass / spring_constant);
  return {speed * time, speed * time, time, spring_constant * speed * time};
}

/// A collision in reduced variables, with what turns the answer back into SI.
struct ReducedCollision {
  double speed;          ///< v̂; 1 without adhesion
  double damping_ratio;  ///< β
  ReducedScales<double> scales;
};

/// `speed` in m/s, positive. The kind must suit the pair: JKR needs surface_energy > 0.
[[nodiscard]] inline ReducedCollision reduce(const ContactKind& kind, const NormalPair& pair, double speed) {
  switch (kind.normal) {
    case NormalModel::linear: return {1.0, pair.damping_ratio, linear_scales(pair.spring_constant, pair.mass, speed)};
    case NormalModel::hertz: return {1.0, pair.damping_ratio, hertz_scales(pair.radius, pair.young, pair.mass, speed)};
    case NormalModel::jkr: break;
  }
  const auto scales = jkr_scales(pair.radius, pair.young, pair.surface_energy, pair.mass);
  return {speed / scales.speed(), pair.damping_ratio, scales};
}

/// The laws with reduced numbers: unit mass, and R* = 1, E* = 3, γ = 1/(3π) for JKR, so that a_0 = δ_0 = F_po = τ = 1.
template <class T>
[[nodiscard]] Linear<T> reduced_linear(T beta) {
  return Linear<T>::make(1, 1, beta);
}
template <class T>
[[nodiscard]] Hertz<T> reduced_hertz(T beta) {
  return Hertz<T>::make(1, 1, 1, beta);
}
template <class T, DampingOn damping_on>
[[nodiscard]] Jkr<T, damping_on> reduced_jkr(T beta, AdhesionRange range) {
  return Jkr<T, damping_on>::make(1, 3, 1 / (3 * std::numbers::pi_v<T>), 1, beta, range);
}

/// The surface energy of the pair R* = E* = m* = 1 that, hit at speed 1, has reduced speed v̂: the same
/// collision in the units of its impact, in which nothing is large when v̂ is.
template <class T>
[[nodiscard]] T surface_energy_at_unit_impact(T reduced_speed) {
  using std::pow;
  return pow(3 / (reduced_speed * reduced_speed), T(3) / 5) / (9 * std::numbers::pi_v<T>);
}

}  // namespace scalebreak

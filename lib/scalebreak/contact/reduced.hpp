#pragma once

#include <scalebreak/contact/normal_law.hpp>

// The reduced variables: the one place where a pair's size, stiffness, mass and surface energy leave
// the problem. With a_0 = (9πγR*²/E*)^{1/3}, δ_0 = a_0²/R*, F_po = 3πγR*, τ = √(m*δ_0/F_po), â = a/a_0,
// every JKR pair obeys one equation:
//
//     δ̂ = â² − (2/3)√â,   δ̂″ + D δ̂′ + 4(â³ − â^{3/2}) = 0,   D = 2√5 β √â  or  2√5 β δ̂^{1/4}
//
// so that a collision depends on v̂ = vτ/δ_0 and β alone. Hertz and linear contacts have no length of
// their own; they are measured by the impact speed, and depend on β alone.

namespace scalebreak {

/// A collision in reduced variables, with what turns the answer back into SI.
struct ReducedCollision {
  double speed;          ///< v̂; 1 without adhesion
  double damping_ratio;  ///< β
  ReducedScales<double> scales;
};

/// `speed` in m/s, positive. The kind must suit the pair: an adhesive law needs surface_energy > 0.
[[nodiscard]] inline ReducedCollision reduce(const ContactKind& kind, const NormalPair& pair, double speed) {
  const auto scales = visit_form(kind, [&]<template <class> class Law>(LawForm<Law>) { return Law<double>::scales(pair, speed); });
  return {kind.adhesive() ? speed / scales.speed() : 1.0, pair.damping_ratio, scales};
}

/// The pair of a kind with reduced numbers: its scales are all 1.
[[nodiscard]] inline NormalPair reduced_pair(const ContactKind& kind, double damping_ratio) {
  return visit_form(kind, [&]<template <class> class Law>(LawForm<Law>) { return Law<double>::reduced_pair(damping_ratio); });
}

/// A law with reduced numbers.
template <template <class> class Law, class T>
[[nodiscard]] Law<T> reduced_law(T damping_ratio, AdhesionRange range = AdhesionRange::touch) {
  return Law<T>::make(Law<T>::reduced_pair(damping_ratio), range);
}

/// How far apart the surfaces are when a contact of this kind ends.
[[nodiscard]] inline double reduced_end_gap(const ContactKind& kind) {
  return visit_form(kind, [&]<template <class> class Law>(LawForm<Law>) {
    const auto law = reduced_law<Law>(0.0, kind.range);
    return -law.overlap(law.separation());
  });
}

}  // namespace scalebreak

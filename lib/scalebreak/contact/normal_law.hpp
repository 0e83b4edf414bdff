#pragma once

#include <type_traits>
#include <variant>

#include <scalebreak/contact/hertz.hpp>
#include <scalebreak/contact/jkr.hpp>
#include <scalebreak/contact/linear.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// Any normal law, chosen at run time.
using NormalLaw = std::variant<Linear<double>, Hertz<double>, Jkr<double, DampingOn::contact_radius>, Jkr<double, DampingOn::overlap>>;

/// The normal law of a pair, SI. The kind must suit the pair: JKR needs surface_energy > 0.
[[nodiscard]] inline NormalLaw normal_law(const ContactKind& kind, const NormalPair& pair) {
  switch (kind.normal) {
    case NormalModel::linear: return Linear<double>::make(pair.spring_constant, pair.mass, pair.damping_ratio);
    case NormalModel::hertz: return Hertz<double>::make(pair.radius, pair.young, pair.mass, pair.damping_ratio);
    case NormalModel::jkr: break;
  }
  if (kind.damping_on == DampingOn::contact_radius) {
    return Jkr<double>::make(pair.radius, pair.young, pair.surface_energy, pair.mass, pair.damping_ratio, kind.range);
  }
  return Jkr<double, DampingOn::overlap>::make(pair.radius, pair.young, pair.surface_energy, pair.mass, pair.damping_ratio, kind.range);
}

}  // namespace scalebreak

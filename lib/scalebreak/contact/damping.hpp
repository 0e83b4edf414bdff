#pragma once

#include <cmath>
#include <numbers>

namespace scalebreak {

/// β = |ln e| / √(ln² e + π²), the damping ratio that gives a linear or Hertz contact the restitution
/// e in (0, 1] (Washino et al. 2024, eq. 17, with the sign taken out).
template <class T>
[[nodiscard]] T damping_ratio(T restitution) {
  using std::log, std::sqrt;
  const T ln = log(restitution);
  return -ln / sqrt(ln * ln + std::numbers::pi_v<T> * std::numbers::pi_v<T>);
}

/// e = exp(−πβ/√(1−β²)), the inverse of damping_ratio, for β in [0, 1).
template <class T>
[[nodiscard]] T restitution_of_damping_ratio(T beta) {
  using std::exp, std::sqrt;
  return exp(-std::numbers::pi_v<T> * beta / sqrt(1 - beta * beta));
}

}  // namespace scalebreak

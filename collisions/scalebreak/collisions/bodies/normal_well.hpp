#pragma once

namespace scalebreak {

/// Potential of a normal law less the work of a constant pull [J], zero at first touch; x is the law's coordinate.
template <class Law>
[[nodiscard]] double well_energy(const Law& law, double x, double pull) {
  return law.energy(x) - pull * law.overlap(x);
}

/// Where that potential is least: at first touch if nothing attracts there.
template <class Law>
[[nodiscard]] double well_bottom(const Law& law, double pull) {
  double low = law.touch();
  if (law.force(low) >= pull) return low;
  double high = low > 0 ? 2 * low : 1e-12;
  while (law.force(high) < pull) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (law.force(middle) < pull ? low : high) = middle;
  }
  return high;
}

}  // namespace scalebreak

#pragma once

#include <cmath>
#include <numbers>

#include <scalebreak/base/random.hpp>

namespace scalebreak {

// The standard leaves its own distributions to the compiler: these are the same on every platform, to the rounding of log and cos.

/// Even in [0, 1), a multiple of 2⁻⁵³.
[[nodiscard]] inline double uniform(std::mt19937_64& stream) { return static_cast<double>(stream() >> 11) * 0x1p-53; }

/// Gaussian of mean 0 and standard deviation 1 (Box & Muller 1958; the second of each pair is not used).
[[nodiscard]] inline double normal(std::mt19937_64& stream) {
  const double radius = std::sqrt(-2 * std::log(1 - uniform(stream)));
  return radius * std::cos(2 * std::numbers::pi * uniform(stream));
}

}  // namespace scalebreak

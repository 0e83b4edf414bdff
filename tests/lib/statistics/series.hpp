#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace scalebreak {

/// A series of mean 0 and variance 1 with the autocorrelation ρᵏ.
inline std::vector<double> autoregressive(std::size_t count, double correlation, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> series = {normal(random)};
  while (series.size() < count) series.push_back(correlation * series.back() + std::sqrt(1 - correlation * correlation) * normal(random));
  return series;
}

}  // namespace scalebreak

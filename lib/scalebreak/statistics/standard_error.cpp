#include <scalebreak/statistics/standard_error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace scalebreak {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double autocovariance(const std::vector<double>& x, std::size_t lag) {
  return std::inner_product(x.begin() + static_cast<std::ptrdiff_t>(lag), x.end(), x.begin(), 0.0) / static_cast<double>(x.size() - lag);
}

}  // namespace

double standard_error_of_sum(const std::vector<double>& residuals) {
  const std::size_t blocks = residuals.size();
  const auto count = static_cast<double>(blocks);
  if (count < independent_stretches_needed) return nothing;
  const double variance = autocovariance(residuals, 0);
  if (variance == 0) return 0;

  // τ_int = ½ + Σ ρ(t); the window is the first W with exp(−W/τ) < τ/√(W n), where τ follows from τ_int.
  double correlation_time = 0.5;
  std::size_t window = 1;
  for (; window < blocks / 2; ++window) {
    correlation_time += autocovariance(residuals, window) / variance;
    const auto reach = static_cast<double>(window);
    if (correlation_time <= 0.5) break;
    const double decay = 1.5 / std::log((2 * correlation_time + 1) / (2 * correlation_time - 1));
    if (std::exp(-reach / decay) < decay / std::sqrt(reach * count)) break;
  }
  const double lost_to_the_mean = 1 + (2 * static_cast<double>(window) + 1) / count;
  correlation_time *= lost_to_the_mean;
  if (correlation_time <= 0 || count / std::max(1.0, 2 * correlation_time) < independent_stretches_needed) return nothing;
  return std::sqrt(2 * correlation_time * variance * count);
}

Measured ratio_of_sums(const std::vector<double>& numerators, const std::vector<double>& denominators) {
  const double numerator = std::reduce(numerators.begin(), numerators.end());
  const double denominator = std::reduce(denominators.begin(), denominators.end());
  if (denominator == 0) return {nothing, nothing};
  const double value = numerator / denominator;
  if (std::all_of(numerators.begin(), numerators.end(), [](double x) { return x == 0; })) return {value, nothing};
  std::vector<double> residuals(numerators.size());
  for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] = numerators[i] - value * denominators[i];
  return {value, standard_error_of_sum(residuals) / std::abs(denominator)};
}

}  // namespace scalebreak

#include <scalebreak/statistics/pooled_mean.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace scalebreak {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t enough_runs = 4;  ///< whose scatter is relied on alone
constexpr double alike_unless = 0.01;   ///< how seldom runs that are alike are taken for runs that are not

/// Of the mean of n values with this variance, as large as it must be for a normal value to be within 1.96 of it in 95 % of all cases.
double scatter_error(double variance, double n) {
  const boost::math::students_t few(n - 1);
  return std::sqrt(variance / n) * boost::math::quantile(few, 0.975) / 1.96;
}

}  // namespace

bool from_scatter_alone(std::size_t runs) { return runs >= enough_runs; }

double scatter_factor(std::size_t runs) {
  const auto n = static_cast<double>(runs);
  return from_scatter_alone(runs) ? scatter_error(n, n) : 1.0;
}

Measured pooled_mean(const std::vector<Measured>& runs) {
  std::vector<Measured> known;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(known), [](const Measured& run) { return std::isfinite(run.value); });
  if (known.empty()) return {nothing, nothing};
  if (known.size() == 1) return known.front();
  const auto n = static_cast<double>(known.size());
  double sum = 0, squares = 0, own = 0;
  for (const Measured& run : known) sum += run.value, own += run.error * run.error;
  const double mean = sum / n;
  for (const Measured& run : known) squares += (run.value - mean) * (run.value - mean);
  const double among = squares / (n - 1), within = own / n;
  const double own_freedom = n * (independent_stretches_needed - 1);
  if (from_scatter_alone(known.size()) || !(within > 0)) return {mean, scatter_error(among, n)};
  const boost::math::fisher_f alike(n - 1, own_freedom);
  if (among / within > boost::math::quantile(complement(alike, alike_unless))) return {mean, scatter_error(among, n)};
  return {mean, std::sqrt(((n - 1) * among + own_freedom * within) / (n - 1 + own_freedom) / n)};
}

}  // namespace scalebreak

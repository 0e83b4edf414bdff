#include <scalebreak/ensembles/tradeoff/convergence.hpp>

#include <cmath>
#include <limits>

#include <gsl/gsl_fit.h>

namespace scalebreak {

ConvergenceOrder convergence_order(const std::vector<double>& sizes, const std::vector<double>& errors) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  if (sizes.size() < 3) return {nothing, nothing};
  std::vector<double> x, y;
  for (const double size : sizes) x.push_back(std::log(size));
  for (const double error : errors) y.push_back(std::log(error));
  double offset, slope, offset_variance, covariance, slope_variance, squares;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &offset, &slope, &offset_variance, &covariance, &slope_variance, &squares);
  return {slope, std::sqrt(slope_variance)};
}

}  // namespace scalebreak

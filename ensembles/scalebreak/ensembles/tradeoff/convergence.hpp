#pragma once

#include <vector>

namespace scalebreak {

/// An exponent and its standard error.
struct ConvergenceOrder {
  double order = 0, error = 0;
};

/// p of error ∝ size^p, by least squares of the logarithms; its error from their scatter. Both NaN with fewer than three points. Sizes
/// and errors above 0, one error a size.
[[nodiscard]] ConvergenceOrder convergence_order(const std::vector<double>& sizes, const std::vector<double>& errors);

}  // namespace scalebreak

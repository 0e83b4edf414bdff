#pragma once

#include <vector>

namespace scalebreak {

/// A mean and its standard error; the error is NaN where the run is too short to tell.
struct Measured {
  double value;
  double error;
};

/// As many independent stretches must a run hold, at least, for its error to be given.
inline constexpr double independent_stretches_needed = 32;

/// The standard error of Σ residuals over successive blocks of one run, residuals adding up to about zero.
///
/// Blocks may still be correlated: the variance is that of the blocks times twice their integrated correlation time, summed up to
/// the window that makes truncation and noise equal (U. Wolff, Comput. Phys. Commun. 156 (2004) 143, with S = 1.5).
/// NaN with fewer than 32 blocks, or where that time leaves fewer than 32 independent stretches. Slow drift looks like a long
/// correlation, so it gives NaN too.
[[nodiscard]] double standard_error_of_sum(const std::vector<double>& residuals);

/// Σ numerators / Σ denominators over the blocks of a run, and its error to first order. NaN where the denominators add up to zero;
/// a numerator that never left zero gives the value 0 and no error, because nothing has happened that could tell it.
[[nodiscard]] Measured ratio_of_sums(const std::vector<double>& numerators, const std::vector<double>& denominators);

}  // namespace scalebreak

#pragma once

#include <cstddef>
#include <vector>

#include <scalebreak/statistics/standard_error.hpp>

namespace scalebreak {

/// The mean of runs that differ by their random numbers alone, and its standard error.
///
/// From four runs on it is their scatter, made larger as Student's t is wider than a normal distribution, so that two errors hold what they
/// should though the scatter of few runs is not well known: 1.6 times for four runs, 1.2 for eight. Of two or three runs that would be too
/// much (6.5 and 2.2 times); there each run's own error, of at least `independent_stretches_needed` stretches, is pooled with the scatter, each with its
/// degrees of freedom, unless the runs scatter more than their own errors allow (F test, 1 %) or one has none. A run's own error misses what
/// changes as slowly as the run is long. Runs without a value are left out; NaN where there is nothing to tell.
[[nodiscard]] Measured pooled_mean(const std::vector<Measured>& runs);

/// Is the error of a mean over so many runs from their scatter alone?
[[nodiscard]] bool from_scatter_alone(std::size_t runs);
/// How much larger than the scatter says the error then is, as Student's t is wider; else 1.
[[nodiscard]] double scatter_factor(std::size_t runs);

}  // namespace scalebreak

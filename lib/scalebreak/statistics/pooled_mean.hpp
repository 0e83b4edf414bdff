#pragma once

#include <vector>

#include <scalebreak/statistics/standard_error.hpp>

namespace scalebreak {

/// The mean of runs that differ by their random numbers alone, and its standard error.
///
/// Two things tell how much a run scatters: the runs among themselves, and each run's own error, of at least `independent_stretches_needed`
/// stretches. Where every run has one, both are pooled, each with its degrees of freedom; few runs then have an error that can be relied
/// on. Unless the runs scatter more than their own errors allow (F test, 1 %), as runs do that are not alike: then, and where a run
/// has no error of its own, only their scatter counts. Runs without a value are left out; NaN where there is nothing to tell.
[[nodiscard]] Measured pooled_mean(const std::vector<Measured>& runs);

}  // namespace scalebreak

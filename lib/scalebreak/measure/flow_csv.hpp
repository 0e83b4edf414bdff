#pragma once

#include <string>
#include <vector>

#include <scalebreak/measure/flow_result.hpp>
#include <scalebreak/measure/sample.hpp>
#include <scalebreak/output/csv.hpp>

namespace scalebreak {

/// The slabs of the gap, a row each: height, then every column and its error; empty where there is nothing to tell.
[[nodiscard]] Csv profile_csv(const FlowProfile& profile);

/// Headers of a table of samples.
[[nodiscard]] std::vector<std::string> series_header();

/// A sample as a row: what its state alone says. Its temperature is about its own profile; between walls, where that is fitted to this one
/// state, it is raised by N / (N − fitted parameters) for what the fit takes away, and empty with too few spheres.
[[nodiscard]] std::vector<CsvCell> series_row(const Sample& sample, int slabs = 20);

}  // namespace scalebreak

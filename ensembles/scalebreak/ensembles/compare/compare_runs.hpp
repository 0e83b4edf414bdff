#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/ensembles/compare/finished_run.hpp>
#include <scalebreak/measure/comparison.hpp>

namespace scalebreak {

/// Two finished runs, the first of them the one that all others are compared with.
struct RunComparison {
  std::size_t second = 0;  ///< number of the other one
  std::vector<std::string> inputs;
  std::vector<Comparison> quantities;
};

/// Each of the others with the first.
[[nodiscard]] std::vector<RunComparison> compare_runs(const std::vector<FinishedRun>& runs);

[[nodiscard]] nlohmann::json comparison_json(const std::vector<FinishedRun>& runs, const std::vector<RunComparison>& comparisons);

/// Writes comparison.csv, the profiles of all runs with plots where all have them, and index.html. Gives the names of plots that could
/// not be drawn.
[[nodiscard]] std::vector<std::string> write_comparison(const std::vector<FinishedRun>& runs, const std::vector<RunComparison>& comparisons,
                                                        const std::filesystem::path& out);

}  // namespace scalebreak

#pragma once

#include <filesystem>
#include <functional>

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/ensembles/breakdown/study_result.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

struct StudyOptions {
  std::filesystem::path out;  ///< runs are kept in its folder cells; empty: nowhere
  int threads = 1;            ///< runs at a time, each of them serial
  TableStore tables;
  std::function<bool()> stop = {};            ///< true: no more is run
  std::function<void(double)> progress = {};  ///< share that is done, by the expected cost of the runs
};

/// Runs all cells of a grid, run.replicas times each, and more where study.target_error wants it (up to study.most_replicas, and until
/// study.budget_seconds of wall time are spent). Runs that `out` has are taken from there. How many runs a cell needs follows from its own alone, so that,
/// without a budget, results are the same bits for any number of threads, and however often the study was interrupted.
[[nodiscard]] StudyResult run_study(const Input& input, StudyGrid grid, const StudyOptions& options);

/// Expected wall time of the first runs of all cells on one core [s]: a guess.
[[nodiscard]] double expected_seconds(const StudyGrid& grid, const Input& input);

}  // namespace scalebreak

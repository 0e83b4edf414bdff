#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/breakdown/cell_replica.hpp>
#include <scalebreak/ensembles/breakdown/study_grid.hpp>
#include <scalebreak/measure/comparison.hpp>

namespace scalebreak {

/// What the runs of a cell came to together.
struct CellResult {
  std::size_t cell = 0;      ///< of the grid
  std::size_t replicas = 0;  ///< runs that came to their end
  std::string failure;       ///< of the first run that did not; empty: all did
  std::vector<Quantity> quantities;
  double particles = 0, measured_time = 0;  ///< of a run, mean
  double steps = 0, events = 0;             ///< of a run, mean
  double wall_seconds = 0;                  ///< of a run, mean
  double processor_seconds = 0;             ///< of a run, mean
  RunWork work;                             ///< of a run, mean; NaN: not counted
  double contact_time = 0;
  std::optional<double> patch_fraction;
  std::string version;  ///< of the program; where its runs are of several, all of them
  /// Of each quantity from what the law claims of the original's, in the same order; `first` is that claim. Empty for an original by the
  /// first engine, and where one of the two has nothing.
  std::vector<Comparison> deviations;

  [[nodiscard]] bool failed() const { return replicas == 0; }
  [[nodiscard]] const Quantity* quantity(const std::string& name) const;
  [[nodiscard]] const Comparison* deviation(const std::string& name) const;
};

/// Means over the runs of a cell, in the order of their numbers.
[[nodiscard]] CellResult cell_result(std::size_t cell, const std::vector<CellReplica>& replicas);

/// The largest relative standard error of what a cell is to be known by: temperature, collision rate, pressure, and, where they are, rotational energy
/// and shear stress. Infinite where one of them is not known.
[[nodiscard]] double relative_error(const CellResult& result);

struct StudyResult {
  StudyGrid grid;
  std::vector<CellResult> cells;  ///< in the order of the grid
  bool complete = true;           ///< false: it was interrupted, and cells are missing or have fewer runs than they are to have

  [[nodiscard]] const CellResult& original_of(std::size_t cell) const { return cells[grid.original_of(cell)]; }
};

/// Fills in the deviations of all cells.
void compare_with_originals(StudyResult& study);

}  // namespace scalebreak

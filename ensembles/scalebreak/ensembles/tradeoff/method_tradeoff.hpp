#pragma once

#include <string>
#include <vector>

#include <scalebreak/ensembles/breakdown/run_study.hpp>
#include <scalebreak/ensembles/tradeoff/method_grid.hpp>

namespace scalebreak {

/// So many standard errors tell the largest of five deviations from 0: by chance one of them is beyond in 5 % of cases.
inline constexpr double told_beyond = 2.6;
/// What a way came to: how far off, at which cost.
struct WayPoint {
  FlowWay way;
  CellResult result;    ///< of its runs; empty where it was refused
  std::string failure;  ///< a sentence: why there is no answer; empty: there is one
  bool in_reference = false;
  std::vector<Comparison> deviations;  ///< of what is judged, from the reference, or for a part of it from the other parts
  std::string worst;                   ///< quantity that is off most, of those that are told from 0 if there are any
  double error = 0, error_error = 0;   ///< its relative deviation, without sign, and the standard error of that; NaN: none
  bool told = false;                   ///< from 0
  double judged = 0;                   ///< error that fronts are made of: see judged_error; NaN: none
  double statistical_error = 0;        ///< relative, of all runs together, see relative_error
  /// Of a run's statistics, that is of one run of as many spheres as the original has: contact forces evaluated and collisions looked up while it
  /// measures; processor time, with start and warm-up [s]. NaN: not known.
  double work = 0, seconds = 0;
  bool on_work_front = false, on_time_front = false;
};

/// Error against cost of all ways to a flow's answer.
struct MethodTradeoff {
  std::vector<WayPoint> points;
  std::vector<std::string> quantities;  ///< that are compared: judged_quantities; of a bed its volume fraction, coordination and pressure
  double resolution = 0;                ///< errors below it are not told apart, relative
  int skipped = 0;
  bool complete = true;  ///< false: it was interrupted
};

/// Runs the ways of an input's [study] as the cells of a study, by the same files, threads and errors. The reference is the mean, weighted
/// by their errors, of the hybrid and of soft spheres at the smallest step, both of the original. Throws what `method_grid` and `run_study` throw.
[[nodiscard]] MethodTradeoff method_tradeoff(const Input& input, const StudyOptions& options);

/// Points, errors, costs and fronts of results, in the order of the grid's cells.
[[nodiscard]] MethodTradeoff method_tradeoff(const MethodGrid& grid, const std::vector<CellResult>& results);

/// What a reader is to know, a sentence each: the reference, failures, the fronts, and how the hybrid stands beside scaled soft spheres.
[[nodiscard]] std::vector<std::string> sentences(const MethodTradeoff& study);

}  // namespace scalebreak

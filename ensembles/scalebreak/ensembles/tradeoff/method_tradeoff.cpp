#include <scalebreak/ensembles/tradeoff/method_tradeoff.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>
#include <scalebreak/ensembles/tradeoff/front.hpp>

namespace scalebreak {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
/// Relative to a value that is not known to this share, a deviation says nothing: a shear stress without shear.
constexpr double well_known = 0.1;
/// What is known better than this is a number of the scene, as the volume fraction of a closed cell, and no result.
constexpr double given = 1e-9;

/// Nothing collides, moves or is sheared in a bed at rest.
std::vector<std::string> of_beds() { return {"bed_volume_fraction", "coordination", "pressure"}; }

/// The mean of independent values, weighted by their errors. One without an error counts where it is alone.
Measured weighted_mean(const std::vector<Measured>& values) {
  if (values.size() == 1) return values.front();
  double sum = 0, weights = 0;
  for (const Measured& value : values) {
    const double weight = 1 / (value.error * value.error);
    if (std::isfinite(weight)) sum += weight * value.value, weights += weight;
  }
  return weights > 0 ? Measured{sum / weights, 1 / std::sqrt(weights)} : values.front();
}

/// Quantities of the reference's parts together, without one of them.
std::vector<Quantity> reference_of(const MethodTradeoff& study, const WayPoint* without) {
  std::vector<Quantity> reference;
  for (const std::string& name : study.quantities) {
    std::vector<Measured> values;
    for (const WayPoint& point : study.points) {
      const Quantity* quantity = point.in_reference && &point != without ? point.result.quantity(name) : nullptr;
      if (quantity) values.push_back(quantity->measured);
    }
    if (!values.empty()) reference.push_back({name, study_quantity(name).unit, weighted_mean(values)});
  }
  return reference;
}

void choose_reference(std::vector<WayPoint>& points) {
  WayPoint* finest = nullptr;
  for (WayPoint& point : points) {
    if (!point.failure.empty() || !point.way.original()) continue;
    if (point.way.engine == "hybrid") point.in_reference = true;
    if (point.way.engine == "dem" && (!finest || point.way.step_fraction < finest->way.step_fraction)) finest = &point;
  }
  if (finest) finest->in_reference = true;
  const bool there = std::any_of(points.begin(), points.end(), [](const WayPoint& point) { return point.in_reference; });
  if (there) return;
  for (WayPoint& point : points) point.in_reference = point.failure.empty() && point.way.original();  // "event" alone
}

void compare_with(WayPoint& point, const std::vector<Quantity>& reference) {
  const double size = size_factor(*find_scaling_law(point.way.law), point.way.factor);
  for (const Quantity& first : reference) {
    const Quantity* quantity = point.result.quantity(first.name);
    if (!quantity) continue;
    const double claim = std::pow(size, study_quantity(first.name).size_power);
    point.deviations.push_back(compare({first.name, first.unit, {claim * first.measured.value, claim * first.measured.error}}, *quantity));
    const Comparison& c = point.deviations.back();
    const double off = std::abs(c.relative.value);
    if (!(c.first.error <= well_known * std::abs(c.first.value)) || !std::isfinite(c.relative.error)) continue;
    if (c.relative.error < given) continue;
    const bool told = off > told_beyond * c.relative.error;  // one that is told counts before a larger one that is not
    if (!point.worst.empty() && (told == point.told ? off < point.error : point.told)) continue;
    point.error = off, point.error_error = c.relative.error, point.worst = c.name, point.told = told;
  }
}

/// Median of the errors that a deviation must exceed to be told.
double typical_resolution(const std::vector<WayPoint>& points) {
  std::vector<double> errors;
  for (const WayPoint& point : points) {
    if (std::isfinite(point.error_error)) errors.push_back(told_beyond * point.error_error);
  }
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

/// An error that is not told from 0 counts as what is told typically: a small one by chance is no merit. Of a way that is known much worse than
/// that it counts as what would be told of it.
double judged_error(const WayPoint& point, double resolution) {
  constexpr double alike = 1.5;  // a part of the reference is compared with less of it than other ways are
  if (point.told) return std::max(resolution, point.error);
  const double own = told_beyond * point.error_error;
  return own > alike * resolution ? own : resolution;
}

std::vector<bool> front_of(const std::vector<WayPoint>& points, double WayPoint::*cost) {
  std::vector<std::size_t> candidates;
  std::vector<double> costs, errors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].*cost) || !std::isfinite(points[i].judged)) continue;
    candidates.push_back(i), costs.push_back(points[i].*cost), errors.push_back(points[i].judged);
  }
  const std::vector<bool> front = on_front(costs, errors);
  std::vector<bool> all(points.size(), false);
  for (std::size_t k = 0; k < candidates.size(); ++k) all[candidates[k]] = front[k];
  return all;
}

/// Means over spheres scatter as one over the root of their number and of the strain, of which every run has the same.
void put_cost(WayPoint& point, double spheres) {
  point.statistical_error = relative_error(point.result);
  const double runs = spheres / point.result.particles;
  point.work = runs * point.result.work.counted(), point.seconds = runs * point.result.processor_seconds;
}

/// How many spheres a run of the original has.
double spheres_of(const std::vector<WayPoint>& points) {
  const auto original = std::find_if(points.begin(), points.end(), [](const WayPoint& point) { return point.in_reference; });
  return original == points.end() ? nothing : original->result.particles;
}

}  // namespace

MethodTradeoff method_tradeoff(const MethodGrid& grid, const std::vector<CellResult>& results) {
  MethodTradeoff study{.points = {}, .quantities = grid.bed ? of_beds() : judged_quantities(), .resolution = 0, .skipped = grid.skipped};
  for (const FlowWay& way : grid.ways) {
    WayPoint point{.way = way, .result = way.cell ? results[*way.cell] : CellResult{}, .failure = way.refusal};
    if (way.cell && point.result.failed())
      point.failure = point.result.failure.empty() ? "it was not run to its end" : point.result.failure;
    point.error_error = point.judged = point.statistical_error = point.work = point.seconds = nothing;
    study.points.push_back(std::move(point));
  }
  choose_reference(study.points);
  for (WayPoint& point : study.points) {
    if (point.failure.empty()) {
      put_cost(point, spheres_of(study.points));
      compare_with(point, reference_of(study, point.in_reference ? &point : nullptr));
    }
    if (point.worst.empty()) point.error = nothing;
  }
  study.resolution = typical_resolution(study.points);
  for (WayPoint& point : study.points) {
    if (!point.worst.empty()) point.judged = judged_error(point, study.resolution);
  }
  const auto by_work = front_of(study.points, &WayPoint::work), by_time = front_of(study.points, &WayPoint::seconds);
  for (std::size_t i = 0; i < study.points.size(); ++i)
    study.points[i].on_work_front = by_work[i], study.points[i].on_time_front = by_time[i];
  return study;
}

MethodTradeoff method_tradeoff(const Input& input, const StudyOptions& options) {
  const MethodGrid grid = method_grid(input);
  const StudyResult results = run_study(input, grid.grid, options);
  MethodTradeoff study = method_tradeoff(grid, results.cells);
  study.complete = results.complete;
  return study;
}

}  // namespace scalebreak

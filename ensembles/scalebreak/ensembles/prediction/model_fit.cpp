#include <scalebreak/ensembles/prediction/model_fit.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <gsl/gsl_multifit.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/base/random.hpp>
#include <scalebreak/ensembles/prediction/cooling_prediction.hpp>

namespace scalebreak {
namespace {

using Vector = std::unique_ptr<gsl_vector, void (*)(gsl_vector*)>;
using Matrix = std::unique_ptr<gsl_matrix, void (*)(gsl_matrix*)>;
Vector vector_of(std::size_t n) { return {gsl_vector_alloc(n), gsl_vector_free}; }
Matrix matrix_of(std::size_t rows, std::size_t columns) { return {gsl_matrix_alloc(rows, columns), gsl_matrix_free}; }

/// A row as the fit sees it.
struct Point {
  Terms terms;
  double size, logarithm, variance;  ///< what the size alone makes, what was measured, and its variance
};

std::vector<Point> points_of(const std::string& quantity, const std::vector<TrainingRow>& rows) {
  std::vector<Point> points;
  for (const TrainingRow& row : rows) {
    if (row.quantity != quantity) continue;
    const double error = row.deviation.error / (1 + row.deviation.value);
    points.push_back({terms_of(row.original, row.scaled), size_term(size_excess(quantity), row.scaled), std::log1p(row.deviation.value),
                      error * error + error_floor * error_floor});
  }
  return points;
}

double modelled(const Point& point, const QuantityModel& model) {
  double sum = point.size;
  for (std::size_t i = 0; i < term_count; ++i) sum += model.coefficients[i] * point.terms[i];
  return sum;
}

/// What scatter of 1 would make of a point's variance: each part of the logarithm is off by so much of itself, so that parts that cancel stay uncertain.
double parts_squared(const Point& point, const QuantityModel& model) {
  double sum = point.size * point.size;
  for (std::size_t i = 0; i < term_count; ++i) sum += std::pow(model.coefficients[i] * point.terms[i], 2);
  return sum;
}

double squares(const std::vector<Point>& points, const QuantityModel& model, double scatter) {
  double sum = 0;
  for (const Point& point : points) {
    const double value = modelled(point, model);
    sum += std::pow(point.logarithm - value, 2) / (point.variance + scatter * scatter * parts_squared(point, model));
  }
  return sum;
}

/// The scatter at which χ² is what it should be; 0 where errors alone explain it.
double scatter_of(const std::vector<Point>& points, const QuantityModel& model, double freedom) {
  constexpr double most = 10;
  if (squares(points, model, 0) <= freedom) return 0;
  double low = 0, high = most;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (squares(points, model, middle) > freedom ? low : high) = middle;
  }
  return high;
}

/// Least squares at the scatter and the prediction of `model`, whose coefficients and covariance are replaced.
void solve(const std::vector<Point>& points, const std::vector<std::size_t>& fitted, QuantityModel& model) {
  const std::size_t n = points.size(), k = fitted.size();
  const Matrix x = matrix_of(n, k), covariance = matrix_of(k, k);
  const Vector y = vector_of(n), w = vector_of(n), c = vector_of(k);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < k; ++j) gsl_matrix_set(x.get(), i, j, points[i].terms[fitted[j]]);
    gsl_vector_set(y.get(), i, points[i].logarithm - points[i].size);
    gsl_vector_set(w.get(), i, 1 / (points[i].variance + model.scatter * model.scatter * parts_squared(points[i], model)));
  }
  const std::unique_ptr<gsl_multifit_linear_workspace, void (*)(gsl_multifit_linear_workspace*)> space(gsl_multifit_linear_alloc(n, k),
                                                                                                       gsl_multifit_linear_free);
  double chi_squared = 0;
  const int status = gsl_multifit_wlinear(x.get(), w.get(), y.get(), c.get(), covariance.get(), &chi_squared, space.get());
  if (status != 0) throw WorkError(fmt::format("the fit of {} failed: {}", model.quantity, gsl_strerror(status)));
  for (std::size_t i = 0; i < k; ++i) {
    model.coefficients[fitted[i]] = gsl_vector_get(c.get(), i);
    for (std::size_t j = 0; j < k; ++j) model.covariance[fitted[i]][fitted[j]] = gsl_matrix_get(covariance.get(), i, j);
  }
}

std::set<std::string> names_of(const std::vector<TrainingRow>& rows, std::string TrainingRow::*member) {
  std::set<std::string> names;
  for (const TrainingRow& row : rows) names.insert(row.*member);
  return names;
}

}  // namespace

bool held_back(std::uint64_t seed, std::uint64_t key) {
  std::uint64_t state = seed;
  state = split_mix(state) ^ key;
  return split_mix(state) >> 63 != 0;
}

QuantityModel fit_quantity(const std::string& quantity, const std::vector<TrainingRow>& rows) {
  constexpr int rounds = 20;
  constexpr double least_term = 1e-6;
  const std::vector<Point> points = points_of(quantity, rows);
  QuantityModel model{.quantity = quantity};
  std::vector<std::size_t> fitted;
  for (std::size_t i = 0; i < term_count; ++i) {
    model.fitted[i] = std::any_of(points.begin(), points.end(), [&](const Point& p) { return std::abs(p.terms[i]) > least_term; });
    if (model.fitted[i]) fitted.push_back(i);
  }
  if (points.size() <= fitted.size())
    throw WorkError(fmt::format("{} cells are too few to fit {} coefficients of {}", points.size(), fitted.size(), quantity));
  if (fitted.empty()) return model;
  for (int round = 0; round < rounds; ++round) {
    solve(points, fitted, model);
    model.scatter = scatter_of(points, model, static_cast<double>(points.size() - fitted.size()));
  }
  return model;
}

bool is_off(const Measured& deviation) {
  const double size = std::abs(deviation.value);
  return size > off_beyond && size > off_errors * deviation.error;
}

bool well_predicted(const Measured& predicted, const Measured& measured) {
  const double ratio = predicted.value / measured.value;
  return ratio >= 1 / good_factor && ratio <= good_factor;
}

Validation validate(const std::vector<QuantityModel>& models, const std::string& quantity, const std::vector<TrainingRow>& rows) {
  Validation result;
  for (const TrainingRow& row : rows) {
    if (row.quantity != quantity) continue;
    const Measured expected = predicted(models, quantity, row.original, row.scaled).deviation;
    const double miss = expected.value - row.deviation.value;
    const double variance = expected.error * expected.error + row.deviation.error * row.deviation.error + error_floor * error_floor;
    ++result.rows, result.rms += miss * miss, result.rms_over_error += miss * miss / variance;
    if (!is_off(row.deviation)) continue;
    const std::size_t good = well_predicted(expected, row.deviation) ? 1 : 0;
    ++result.off, result.within_factor += good;
    if (row.scaled.size == 1) ++result.softened_off, result.softened_within_factor += good;
  }
  const double n = std::max(1.0, static_cast<double>(result.rows));
  result.rms = std::sqrt(result.rms / n), result.rms_over_error = std::sqrt(result.rms_over_error / n);
  return result;
}

Validation together(const std::map<std::string, Validation>& validation) {
  Validation all;
  for (const auto& [name, v] : validation) {
    all.rows += v.rows, all.off += v.off, all.within_factor += v.within_factor;
    all.softened_off += v.softened_off, all.softened_within_factor += v.softened_within_factor;
    all.rms += v.rms * v.rms * static_cast<double>(v.rows);
    all.rms_over_error += v.rms_over_error * v.rms_over_error * static_cast<double>(v.rows);
  }
  const auto n = std::max(1.0, static_cast<double>(all.rows));
  all.rms = std::sqrt(all.rms / n), all.rms_over_error = std::sqrt(all.rms_over_error / n);
  return all;
}

std::map<std::string, Validation> test_on(const DeviationModel& model, const TrainingRows& unseen) {
  std::vector<TrainingRow> rows;
  std::copy_if(unseen.rows.begin(), unseen.rows.end(), std::back_inserter(rows),
               [](const TrainingRow& row) { return beyond_model(row.original, row.scaled) <= 0; });
  std::map<std::string, Validation> test;
  for (const QuantityModel& quantity : model.quantities) test[quantity.quantity] = validate(model.quantities, quantity.quantity, rows);
  return test;
}

std::map<std::string, double> named_groups(const ScaleGroups& g) {
  return {{"contact_time_x_collision_rate", g.busy},
          {"jamming_share", g.jamming_share},
          {"size", g.size},
          {"torque_lack", g.torque_lack},
          {"sticking_over_impact_speed", 1 / g.impact_over_sticking},
          {"collisional_share", g.collisional_share},
          {"overlap", g.overlap},
          {"inertial_number", g.inertial_number},
          {"bond", g.bond},
          {"length_ratio", g.length_ratio}};
}

DeviationModel fit_model(const TrainingRows& training, std::uint64_t seed) {
  DeviationModel model{.seed = seed};
  std::vector<TrainingRow> fit, test;
  for (const TrainingRow& row : training.rows) {
    if (beyond_model(row.original, row.scaled) > 0) continue;
    const bool back = held_back(seed, row.key) || row.original.regime == FlowRegime::cooling;
    (back ? test : fit).push_back(row);
  }
  for (const std::string& quantity : predicted_quantities()) model.quantities.push_back(fit_quantity(quantity, fit));
  for (const std::string& quantity : predicted_quantities()) model.validation[quantity] = validate(model.quantities, quantity, test);
  for (const TrainingRow& row : fit) {
    for (const auto& [name, value] : named_groups(row.scaled)) {
      const auto [at, first] = model.ranges.try_emplace(name, GroupRange{value, value});
      at->second = {std::min(at->second.least, value), std::max(at->second.largest, value)};
    }
  }
  std::set<std::uint64_t> off;
  for (const TrainingRow& row : test) {
    if (is_off(row.deviation)) off.insert(row.key);
  }
  model.rows_fitted = fit.size(), model.rows_held_back = test.size(), model.cells_off = off.size();
  for (const std::string& name : names_of(training.rows, &TrainingRow::study)) model.studies.push_back(name);
  for (const std::string& name : names_of(training.rows, &TrainingRow::version)) model.versions.push_back(name);
  return model;
}

}  // namespace scalebreak

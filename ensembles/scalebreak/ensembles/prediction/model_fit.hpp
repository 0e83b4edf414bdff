#pragma once

#include <map>
#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/deviation_model.hpp>
#include <scalebreak/ensembles/prediction/training_rows.hpp>

namespace scalebreak {

/// Is a cell held back from the fit, to test it? About half of them are: a function of a seed and the cell's key, so that no order of rows and no other
/// study changes it.
[[nodiscard]] bool held_back(std::uint64_t seed, std::uint64_t key);

/// What every row counts with beside its own error, in ln(value / claim): no model is better than that.
inline constexpr double error_floor = 0.005;

/// The coefficients of one quantity from the rows of it, by linear least squares (GSL). A row's weight is one over the square of its error,
/// `error_floor` and the model's own scatter times its prediction, that one such that χ² is the number of rows less that of coefficients.
/// A term that all rows leave at 0 is not fitted. Throws WorkError where there are fewer rows than coefficients and one.
[[nodiscard]] QuantityModel fit_quantity(const std::string& quantity, const std::vector<TrainingRow>& rows);

/// How a model does on rows that it was not fitted to.
struct Validation {
  std::size_t rows = 0;
  double rms = 0;                 ///< of predicted less measured deviation
  double rms_over_error = 0;      ///< the same, each over its errors, predicted and measured
  std::size_t off = 0;            ///< rows off by more than 3 % and two standard errors
  std::size_t within_factor = 0;  ///< of those, predicted within a factor 1.5
  std::size_t softened_off = 0;   ///< the same of spheres that keep their size, where nothing is known without a fit
  std::size_t softened_within_factor = 0;
};
inline constexpr double off_beyond = 0.03, off_errors = 2, good_factor = 1.5;
[[nodiscard]] bool is_off(const Measured& deviation);
[[nodiscard]] bool well_predicted(const Measured& predicted, const Measured& measured);
/// The rows of `quantity`, by the models of all quantities.
[[nodiscard]] Validation validate(const std::vector<QuantityModel>& models, const std::string& quantity,
                                  const std::vector<TrainingRow>& rows);
/// Of all quantities together.
[[nodiscard]] Validation together(const std::map<std::string, Validation>& validation);

/// A group and the least and largest value that the fit has seen.
struct GroupRange {
  double least = 0, largest = 0;
};

/// The models of all judged quantities, and what they come from.
struct DeviationModel {
  std::vector<QuantityModel> quantities;
  std::map<std::string, GroupRange> ranges;      ///< by the name of the group, of scaled flows
  std::map<std::string, Validation> validation;  ///< by quantity, on the rows held back
  std::uint64_t seed = 1;
  std::size_t rows_fitted = 0, rows_held_back = 0, cells_off = 0;  ///< cells held back with a quantity that is off
  std::vector<std::string> studies, versions;
};

/// The groups that ranges are kept of, by name.
[[nodiscard]] std::map<std::string, double> named_groups(const ScaleGroups& groups);

/// The model on studies that it was not fitted to, by quantity; rows beyond it (beyond_model) are left out.
[[nodiscard]] std::map<std::string, Validation> test_on(const DeviationModel& model, const TrainingRows& unseen);

/// Fits the rows that are not held back, without those beyond the model (beyond_model), and tests on the others. Rows of gases that cool, which need no fit
/// (cooling_prediction.hpp), are all of the test. Throws WorkError.
[[nodiscard]] DeviationModel fit_model(const TrainingRows& training, std::uint64_t seed);

}  // namespace scalebreak

#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/prediction/prediction_file.hpp>

namespace scalebreak::tests {
namespace {

/// Rows that follow a model with these coefficients, their errors drawn.
std::vector<TrainingRow> synthetic(const QuantityModel& truth, double error, std::size_t cells) {
  std::mt19937_64 stream(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<TrainingRow> rows;
  for (std::size_t i = 0; i < cells; ++i) {
    TrainingRow row{.study = "synthetic", .law = "rps", .point = "", .key = 0x9e3779b97f4a7c15 * (i + 1), .quantity = truth.quantity};
    row.original = {.busy = 0.01, .jamming_share = 0.5 * uniform(stream), .impact_over_sticking = 1000, .collisional_share = 1};
    row.scaled = row.original;
    row.scaled.busy = std::pow(10, -1.5 + 1.5 * uniform(stream));
    row.scaled.size = 1 + 2 * uniform(stream), row.scaled.torque_lack = i % 2 == 0 ? 1 : 0;
    row.scaled.impact_over_sticking = 1 / (0.002 + 0.096 * uniform(stream));
    const double exact = predict(truth, row.original, row.scaled).deviation.value;
    row.deviation = {(1 + exact) * std::exp(error * normal(stream)) - 1, (1 + exact) * error};
    rows.push_back(row);
  }
  return rows;
}

TEST(ModelFit, FindsTheCoefficientsThatRowsWereMadeWith) {
  const QuantityModel truth{.quantity = "temperature", .coefficients = {-0.6, 1.1, -0.2, 0.35}};
  const QuantityModel model = fit_quantity("temperature", synthetic(truth, 0.02, 400));
  for (std::size_t i = 0; i < term_count; ++i) {
    const double error = std::sqrt(model.covariance[i][i]);
    EXPECT_TRUE(model.fitted[i]);
    EXPECT_LT(error, 0.05);
    EXPECT_LT(std::abs(model.coefficients[i] - truth.coefficients[i]), 4 * error) << deviation_terms[i].name;
  }
  EXPECT_LT(model.scatter, 0.05);
}

TEST(ModelFit, KnowsTheSizeTermWithoutAFit) {
  const QuantityModel plain{.quantity = "temperature"};
  ScaleGroups original, large;
  large.size = 3, large.collisional_share = original.collisional_share = 1;
  original.impact_over_sticking = large.impact_over_sticking = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(predict(plain, original, large).deviation.value, 8, 1e-12);  // l² − 1
  EXPECT_NEAR(predict({.quantity = "collision_rate"}, original, large).deviation.value, 2, 1e-12);
  large.collisional_share = 0;  // quasi-static: the claim holds
  EXPECT_NEAR(predict(plain, original, large).deviation.value, 0, 1e-12);
}

TEST(ModelFit, LeavesOutWhatNoRowShows) {
  const QuantityModel truth{.quantity = "pressure", .coefficients = {-0.6, 1.1, 0, 0}};
  std::vector<TrainingRow> rows = synthetic(truth, 0.01, 60);
  for (TrainingRow& row : rows) row.scaled.torque_lack = 0, row.scaled.impact_over_sticking = row.original.impact_over_sticking;
  const QuantityModel model = fit_quantity("pressure", rows);
  EXPECT_EQ(model.fitted, (std::array<bool, term_count>{true, true, false, false}));
  EXPECT_EQ(model.coefficients[3], 0);
  rows.resize(2);
  EXPECT_THROW((void)fit_quantity("pressure", rows), WorkError);
}

TEST(ModelFit, SaysHowFarItIsOff) {
  // Logarithms that are a fifth off what the one term says, far beyond their errors and the floor.
  const QuantityModel truth{.quantity = "temperature", .coefficients = {-6, 0, 0, 0}};
  std::vector<TrainingRow> rows = synthetic(truth, 0.01, 1000);
  std::mt19937_64 stream(8);
  std::normal_distribution<double> normal(1, 0.2);
  for (TrainingRow& row : rows) {
    row.scaled.size = 1, row.scaled.impact_over_sticking = row.original.impact_over_sticking, row.scaled.jamming_share = 0;
    const double exact = predict(truth, row.original, row.scaled).deviation.value;
    row.deviation.value = std::expm1(normal(stream) * std::log1p(exact));
    row.deviation.error = 0.001 * (1 + row.deviation.value);
  }
  const QuantityModel model = fit_quantity("temperature", rows);
  EXPECT_NEAR(model.scatter, 0.2, 0.02);
  EXPECT_NEAR(model.coefficients[0], -6, 4 * std::sqrt(model.covariance[0][0]));
  const Prediction prediction = predict(model, rows[0].original, rows[0].scaled);
  EXPECT_GT(prediction.deviation.error, 0.9 * 0.2 * std::abs(std::log1p(prediction.deviation.value)) * (1 + prediction.deviation.value));
}

TEST(ModelFit, SplitsByTheKeyAlone) {
  int back = 0;
  for (std::uint64_t key = 0; key < 4000; ++key) {
    EXPECT_EQ(held_back(1, key), held_back(1, key));
    back += held_back(1, key) ? 1 : 0;
  }
  EXPECT_NEAR(back, 2000, 5 * std::sqrt(1000.0));
  TrainingRows training;
  for (const char* name : {"temperature", "rotational_energy", "collision_rate", "pressure", "stress_xz"}) {
    const auto rows = synthetic({.quantity = name, .coefficients = {-0.5, 1, 0.1, 0.2}}, 0.02, 100);
    training.rows.insert(training.rows.end(), rows.begin(), rows.end());
  }
  const DeviationModel model = fit_model(training, 1);
  std::reverse(training.rows.begin(), training.rows.end());
  const DeviationModel reversed = fit_model(training, 1);
  for (std::size_t q = 0; q < model.quantities.size(); ++q) {
    for (std::size_t i = 0; i < term_count; ++i)
      EXPECT_NEAR(model.quantities[q].coefficients[i], reversed.quantities[q].coefficients[i], 1e-9);
  }
  EXPECT_EQ(model.rows_fitted + model.rows_held_back, training.rows.size());
  EXPECT_GT(model.cells_off, 20u);
  for (const auto& [name, v] : model.validation) {
    EXPECT_GT(v.off, 20u);
    EXPECT_GT(static_cast<double>(v.within_factor), 0.9 * static_cast<double>(v.off)) << name;
  }

  const DeviationModel back_again = model_from_json(nlohmann::json::parse(model_json(model).dump()), "model");
  EXPECT_EQ(model_json(back_again), model_json(model));
  EXPECT_THROW((void)model_from_json(nlohmann::json::parse("{}"), "model"), InputError);
}

TEST(ModelFit, IsNotFittedToGasesThatCool) {
  TrainingRows training;
  for (const std::string& name : predicted_quantities()) {
    auto rows = synthetic({.quantity = name, .coefficients = {-0.5, 1, 0.1, 0.2}}, 0.02, 60);
    training.rows.insert(training.rows.end(), rows.begin(), rows.end());
  }
  const DeviationModel model = fit_model(training, 1);
  TrainingRow gas = training.rows.front();
  gas.original.regime = gas.scaled.regime = FlowRegime::cooling,
  gas.original.gas = gas.scaled.gas = {.temperature = 1, .collision_rate = 1};
  gas.deviation = {5, 0.01};
  for (std::uint64_t key = 0; key < 20; ++key) gas.key = key, training.rows.push_back(gas);
  const DeviationModel with_gas = fit_model(training, 1);
  EXPECT_EQ(with_gas.rows_fitted, model.rows_fitted);
  EXPECT_EQ(with_gas.rows_held_back, model.rows_held_back + 20);
  EXPECT_EQ(with_gas.quantities[0].coefficients, model.quantities[0].coefficients);
}

TEST(ModelFit, IsTestedOnWhatItHasNotSeen) {
  DeviationModel model;
  model.quantities = {QuantityModel{.quantity = "temperature", .coefficients = {-0.6, 0, 0, 0}}};
  TrainingRows unseen;
  unseen.rows = synthetic({.quantity = "temperature", .coefficients = {-0.6, 0, 0, 0}}, 0.001, 50);
  for (TrainingRow& row : unseen.rows) row.scaled.size = 1, row.scaled.torque_lack = 0;
  TrainingRow deep = unseen.rows.front();
  deep.scaled.overlap = 0.2, unseen.rows.push_back(deep);  // beyond the model: left out
  for (TrainingRow& row : unseen.rows) row.deviation = {predict(model.quantities[0], row.original, row.scaled).deviation.value, 0.001};
  auto test = test_on(model, unseen);
  EXPECT_EQ(test["temperature"].rows, 50u);
  EXPECT_GT(test["temperature"].off, 20u);
  EXPECT_EQ(test["temperature"].within_factor, test["temperature"].off);
  for (TrainingRow& row : unseen.rows) row.deviation.value *= 1.6;
  test = test_on(model, unseen);
  EXPECT_EQ(test["temperature"].within_factor, 0u);
  test["pressure"] = test["temperature"];
  EXPECT_EQ(together(test).off, 2 * test["temperature"].off);
  EXPECT_NEAR(together(test).rms, test["temperature"].rms, 1e-12);
}

}  // namespace
}  // namespace scalebreak::tests

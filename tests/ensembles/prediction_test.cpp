#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/ensembles/breakdown/study_files.hpp>
#include <scalebreak/ensembles/breakdown/study_grid.hpp>
#include <scalebreak/ensembles/engine/event_engine.hpp>
#include <scalebreak/ensembles/prediction/flow_knowledge.hpp>
#include <scalebreak/ensembles/prediction/granular_theory.hpp>
#include <scalebreak/ensembles/prediction/prediction_file.hpp>
#include <scalebreak/scene/input_file.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

using std::numbers::pi;

const std::string undamped = R"(
[material]
restitution = 1
surface_energy = 0
[contact]
normal = "hertz"
tangential = "mindlin"
[particles]
count = 200
radius = 0.5e-3
volume_fraction = 0.3
[cell]
kind = "shear"
shear_rate = 100
)";

const std::string cohesive = R"(
[contact]
normal = "jkr"
tangential = "mindlin"
[particles]
count = 200
[cell]
kind = "shear"
shear_rate = 400
)";

Input with(const std::string& scene, const std::string& law, double factor) {
  Input input = resolved(scene);
  input.scaling_law = law, input.scaling_factor = factor;
  return input;
}

TEST(GranularTheory, MeetsEnskogFarFromJamming) {
  const double phi = 0.3, d = 1e-3, temperature = 4e-4, jamming = 0.6;
  const double free = contact_value(phi, jamming) * (1 - jamming_share(phi, jamming));
  EXPECT_NEAR(free, (1 - phi / 2) / std::pow(1 - phi, 3), 1e-12);
  const double crowd = 6 * phi / (pi * d);  // Σd²/V
  EXPECT_NEAR(collisions_of_sphere(phi, free, temperature, d) / enskog_rate(crowd, phi, std::sqrt(3 * temperature)), 1, 1e-12);
}

TEST(GranularTheory, ImpactSpeedIsTheMeanOverMaxwellsCollisions) {
  const double temperature = 2.5;  // of approach speeds v along the line of centres, collisions have v exp(−v²/4T)
  double sum = 0, weight = 0;
  for (double v = 0.0005; v < 40; v += 0.001) {
    const double w = v * std::exp(-v * v / (4 * temperature));
    sum += w * v, weight += w;
  }
  EXPECT_NEAR(mean_impact_speed(temperature) / (sum / weight), 1, 1e-6);
}

TEST(GranularTheory, ShearBalancesWorkAndDissipation) {
  // A dilute gas that is nearly elastic: η = (5√π/96) ρ d √T (Chapman & Enskog), dissipation (12/√π) ρφ²χ(1 − e²)T^{3/2}/d.
  const double phi = 1e-5, e = 0.999;
  const double dilute = 5 * pi / (96 * 12 * phi * phi * (1 - e * e));
  EXPECT_NEAR(shear_temperature_number(phi, 1, e) / dilute, 1, 3e-3);
  // Dense: nothing but collisions, a number of e alone.
  const double j = (1 + e) / 2 + pi / 4 * (1 + e) * (1 + e) * (3 * e - 1) / (24 - 6 * (1 - e) * (1 - e) - 5 * (1 - e * e));
  EXPECT_NEAR(shear_temperature_number(0.6, 1e6, e) / (2 * j / (15 * (1 - e * e))), 1, 1e-4);
}

TEST(GranularTheory, KnowsFriction) {
  EXPECT_EQ(effective_restitution(0.8, 0), 0.8);
  EXPECT_NEAR(effective_restitution(0.81, 0.3), 0.81 - 0.45 * std::exp(-0.9), 1e-12);
  EXPECT_EQ(effective_restitution(0.1, 0.3), 0);
  EXPECT_NEAR(jamming_fraction(0.3), 0.596, 1e-12);
  EXPECT_NEAR(jamming_fraction(0.2), 0.6045, 1e-12);
  EXPECT_NEAR(jamming_fraction(5), 0.581, 1e-12);
}

TEST(ScaleGroups, HaveTheContactTimeOfHertz) {
  const ScaleGroups groups = scale_groups(resolved(undamped));
  const Input input = resolved(undamped);
  const NormalPair pair = sphere_pair(input.material, 0.5e-3, input.material, 0.5e-3);
  // δ_max = (15/16)^{2/5} (m* v²/(E* √R*))^{2/5}, t_c = 2.9432752 δ_max / v.
  const double v = groups.impact_speed;
  const double depth = std::pow(15.0 / 16 * pair.mass * v * v / (pair.young * std::sqrt(pair.radius)), 0.4);
  EXPECT_NEAR(groups.contact_time / (2.9432752 * depth / v), 1, 1e-5);
  EXPECT_NEAR(groups.overlap / (depth / pair.radius), 1, 1e-5);
  EXPECT_EQ(groups.busy, groups.contact_time * groups.collision_rate);
  EXPECT_TRUE(std::isinf(groups.impact_over_sticking));
  EXPECT_EQ(groups.collisional_share, 1);
  EXPECT_EQ(groups.bond, 0);
}

TEST(ScaleGroups, SofteningStretchesTheContactTime) {
  const ScaleGroups original = scale_groups(resolved(undamped)), soft = scale_groups(with(undamped, "rps", 1e-3));
  EXPECT_NEAR(soft.busy / original.busy, std::pow(1e-3, -0.4), 1e-4);
  EXPECT_EQ(soft.collision_rate, original.collision_rate);
}

TEST(ScaleGroups, EnlargedSpheresMoveFasterInShear) {
  const ScaleGroups original = scale_groups(resolved(undamped)), large = scale_groups(with(undamped, "sup", 2));
  EXPECT_NEAR(large.impact_speed / original.impact_speed, 2, 1e-9);
  EXPECT_NEAR(large.collision_rate / original.collision_rate, 1, 1e-9);
  EXPECT_NEAR(large.contact_time / original.contact_time, 2 * std::pow(2, -0.2), 1e-4);  // t_c ∝ l v^{−1/5}
  EXPECT_EQ(large.size, 2);
  EXPECT_EQ(large.torque_lack, 1);  // force × l², torque × l² where l³ would keep it
  EXPECT_EQ(scale_groups(with(undamped, "torque_cubed", 2)).torque_lack, 0);
}

TEST(ScaleGroups, OnlyRpsKeepsTheStickingSpeed) {
  const ScaleGroups original = scale_groups(resolved(cohesive));
  ASSERT_GT(original.impact_over_sticking, 1);
  EXPECT_NEAR(scale_groups(with(cohesive, "rps", 1e-2)).impact_over_sticking / original.impact_over_sticking, 1, 1e-4);
  EXPECT_NEAR(scale_groups(with(cohesive, "none", 1e-2)).impact_over_sticking / original.impact_over_sticking, std::pow(1e-2, 1.0 / 3),
              1e-3);
  // Pull-off force over pressure × d²: kept by softening alone, lowered by RPS with γ.
  EXPECT_NEAR(scale_groups(with(cohesive, "none", 1e-2)).bond / original.bond, 1, 1e-9);
  EXPECT_NEAR(scale_groups(with(cohesive, "rps", 1e-2)).bond / original.bond, std::pow(1e-2, 0.4), 1e-9);
}

TEST(ScaleGroups, ImposedPressureSetsTheInertialNumber) {
  Input input = resolved(undamped);
  input.cell.pressure = 1e6;
  const ScaleGroups groups = scale_groups(input);
  EXPECT_NEAR(groups.inertial_number, 100 * 1e-3 * std::sqrt(input.material.density / 1e6), 1e-12);
  EXPECT_LT(groups.collisional_share, 0.01);  // what collisions carry of such a pressure
}

const std::string cooling = R"(
[material]
restitution = 0.9
surface_energy = 0
[contact]
normal = "hertz"
[particles]
count = 200
radius = 0.5e-3
volume_fraction = 0.1
speed = 0.1
[cell]
kind = "cooling"
[run]
warmup_duration = 0.03
duration = 0.02
)";

TEST(ScaleGroups, GasCoolsByHaffsLaw) {
  const ScaleGroups original = scale_groups(resolved(cooling)), large = scale_groups(with(cooling, "none", 2));
  EXPECT_EQ(original.regime, FlowRegime::cooling);
  EXPECT_NEAR(original.cooled, (1 - 0.81) / 6 * original.collision_rate * 0.05, 1e-12);
  EXPECT_NEAR(large.cooled, original.cooled / 2, 1e-12);  // twice as large spheres meet half as often
  // Temperatures at the end over each other: ((1 + s)/(1 + s/2))², and a rate that is claimed to be half.
  const double s = original.cooled, faster = (1 + s) / (1 + s / 2);
  EXPECT_NEAR(std::exp(speed_growth(large)), faster, 1e-12);
  EXPECT_NEAR(predict({.quantity = "temperature"}, original, large).deviation.value, faster * faster - 1, 1e-12);
  EXPECT_NEAR(predict({.quantity = "collision_rate"}, original, large).deviation.value, faster - 1, 1e-12);
  EXPECT_EQ(speed_growth(scale_groups(with(cooling, "rps", 1e-2))), 0);
  Input sticky = resolved(cooling);
  sticky.contact.normal = NormalModel::jkr, sticky.material.surface_energy = 0.02;
  const ScaleGroups long_after = scale_groups(sticky);
  sticky.run.warmup_duration = 0, sticky.run.duration = 1e-9;
  EXPECT_NEAR(long_after.impact_over_sticking / scale_groups(sticky).impact_over_sticking, 1 / (1 + s), 1e-6);
}

Input pressed(const std::string& law, double factor, double surface_energy) {
  Input input = with(cohesive, law, factor);
  input.material.young = 1e8, input.material.surface_energy = surface_energy;
  input.cell.kind = CellKind::confined_shear, input.cell.pressure = 1000, input.cell.shear_rate = 6.32;
  return input;
}

TEST(ScaleGroups, LoadPressesSpheresTogether) {
  const ScaleGroups original = scale_groups(pressed("none", 1, 0.1)), large = scale_groups(pressed("sup", 2, 0.1)),
                    soft = scale_groups(pressed("rps", 0.1, 0.1));
  EXPECT_EQ(original.regime, FlowRegime::pressed);
  // Hertz: F = 4/3 E* √R* δ^{3/2} with F = P d² and d = 4 R*.
  const double young = 1e8 / (2 * (1 - 0.25 * 0.25)), force = 1000 * 1e-6, radius = 0.25e-3;
  EXPECT_NEAR(original.pressed_overlap, std::pow(0.75 * force / (young * std::sqrt(radius)), 2.0 / 3) / radius,
              1e-6 * original.pressed_overlap);
  EXPECT_NEAR(large.pressed_overlap / original.pressed_overlap, 1, 1e-9);  // forces grow as l², as the load
  EXPECT_NEAR(soft.pressed_overlap / original.pressed_overlap, std::pow(10, 2.0 / 3), 1e-6);
}

TEST(FlowKnowledge, UnderPressureSupKeepsWhatCohesionIsHeldAgainst) {
  const DeviationModel none;
  const ScaleGroups original = scale_groups(pressed("none", 1, 0.1));
  const FlowKnowledge knowledge{.model = none, .regime = FlowRegime::pressed, .slope = {{0.12, 0.02}, 0.24}};
  const auto stress = [&](const char* law, double factor) {
    return knowledge.expected(original, scale_groups(pressed(law, factor, 0.1))).front();
  };
  ASSERT_EQ(stress("sup", 2).quantity, "stress_xz");
  // SUP changes the inertial number alone; bond's pull-off force grows as l³, so over pressure × d² as l; RPS lowers it.
  const double inertia = stress("sup", 2).deviation.value;
  EXPECT_GT(inertia, 0);
  EXPECT_LT(inertia, 0.05);
  EXPECT_NEAR(std::log1p(stress("bond", 2).deviation.value) - std::log1p(inertia), 0.12 * std::log(2), 1e-6);
  EXPECT_NEAR(std::log1p(stress("none", 2).deviation.value) - std::log1p(inertia), -0.12 * std::log(2) * original.bond / 0.24, 1e-3);
  EXPECT_EQ(stress("bond", 2).mechanism, "adhesion");
  EXPECT_LT(stress("rps", 0.1).deviation.value, 0);
  EXPECT_THAT(kept_groups(original, scale_groups(pressed("sup", 2, 0.1))),
              testing::AllOf(testing::StartsWith("keeps pull-off force over pressure × d², overlap under the load"),
                             testing::HasSubstr("inertial number × 2")));
  EXPECT_THAT(kept_groups(original, scale_groups(pressed("bond", 2, 0.1))), testing::HasSubstr("pull-off force over pressure × d² × 2"));
}

TEST(FlowKnowledge, FindsTheSlopeOfCohesion) {
  TrainingRows rows;
  for (const double ratio : {0.5, 2.0, 3.0}) {
    TrainingRow row{.quantity = "stress_xz", .deviation = {std::pow(ratio, 0.15) - 1, 0.01}};
    row.original.bond = 0.3, row.scaled.bond = 0.3 * ratio, row.original.inertial_number = row.scaled.inertial_number = 0.01;
    rows.rows.push_back(row);
  }
  const CohesionSlope slope = cohesion_slope(rows);
  EXPECT_NEAR(slope.slope.value, 0.15, 1e-12);
  EXPECT_NEAR(slope.slope.error, 0, 1e-9);
  EXPECT_NEAR(slope.at, 0.3, 1e-12);
  EXPECT_THROW((void)cohesion_slope({}), WorkError);
}

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

TEST(TrainingRows, ForecastsAStudyBeforeItRuns) {
  const Input input = resolved(undamped + "[study]\nlaws = [\"rps\"]\nfactors = [0.01, 0.001]\nvolume_fractions = [0.2, 0.3]\n");
  const TrainingRows forecast = forecast_rows(input, "coming");
  ASSERT_EQ(forecast.rows.size(), 4 * predicted_quantities().size());
  const TrainingRow& row = forecast.rows.front();
  EXPECT_TRUE(std::isnan(row.deviation.value));
  EXPECT_EQ(row.law, "rps");
  EXPECT_NEAR(row.scaled.busy / row.original.busy, std::pow(0.01, -0.4), 1e-4);
}

TEST(TrainingRows, ReadsAStudysFolder) {
  const TemporaryFolder folder;
  const Input input = resolved(undamped + "[study]\nlaws = [\"rps\"]\nfactors = [0.01]\nvolume_fractions = [0.2, 0.3]\n");
  put_file(folder / "input.toml", write_input(input));
  const std::string header =
      "law,factor [-],engine,volume_fraction [-],parameter_value [SI],quantity,deviation [-],deviation_error [-],version\n";
  put_file(folder / "study.csv", header +
                                     "none,1,dem,0.20000000000000001,,temperature,,,1\n"
                                     "rps,0.01,dem,0.20000000000000001,,temperature,0.25,0.125,1\n"
                                     "rps,0.01,dem,0.20000000000000001,,coordination,0.25,0.125,1\n"
                                     "rps,0.01,dem,0.29999999999999999,,pressure,-0.5,,1\n");
  TrainingRows training;
  add_study(training, folder.path());
  ASSERT_EQ(training.rows.size(), 1u);
  EXPECT_EQ(training.without_error, 1);
  const TrainingRow& row = training.rows.front();
  EXPECT_EQ(row.deviation.value, 0.25);
  EXPECT_EQ(row.deviation.error, 0.125);
  EXPECT_NEAR(row.scaled.busy / row.original.busy, std::pow(0.01, -0.4), 1e-4);

  put_file(folder / "study.csv", header + "rps,0.02,dem,0.2,,temperature,0.25,0.125,1\n");
  EXPECT_THAT([&] { add_study(training, folder.path()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("study.csv, line 2: rps at 0.02 is no cell of the study")));
  const TemporaryFolder empty;
  EXPECT_THAT([&] { add_study(training, empty.path()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("holds no finished study")));
}

}  // namespace
}  // namespace scalebreak::tests

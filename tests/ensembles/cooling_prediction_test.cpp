#include <cmath>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/prediction/cooling_prediction.hpp>

#include <ensembles/prediction_scenes.hpp>

namespace scalebreak::tests {
namespace {

constexpr double rate = -0.4, temperature = -0.2, pressure = -0.5;

/// Contact time alone, and terms of shear that a gas that cools does not ask for.
std::vector<QuantityModel> models() {
  return {{.quantity = "temperature", .coefficients = {temperature, 7, 7, 7}},
          {.quantity = "rotational_energy", .coefficients = {temperature, 7, 7, 7}},
          {.quantity = "collision_rate", .coefficients = {rate, 7, 7, 7}},
          {.quantity = "pressure", .coefficients = {pressure, 7, 7, 7}}};
}

Prediction of(const std::string& quantity, const Input& original, const Input& scaled) {
  return predicted(models(), quantity, scale_groups(original), scale_groups(scaled));
}

TEST(CoolingPrediction, LargerSmoothSpheresCoolByHaffsLaw) {
  const Input original = resolved(cooling), large = with(cooling, "none", 2);
  const ScaleGroups groups = scale_groups(original);
  const double loss = (1 - 0.81) / 6 * groups.collision_rate, begin = loss * 0.03, end = loss * 0.05;
  const double warmer = (1 + begin) * (1 + end) / ((1 + begin / 2) * (1 + end / 2));
  const double more = std::log((1 + end / 2) / (1 + begin / 2)) / std::log((1 + end) / (1 + begin));  // of ∫dt/(1 + rt)
  const double slack = 0.02;                                                                          // contacts last, a little
  EXPECT_NEAR(std::log1p(of("temperature", original, large).deviation.value) / std::log(warmer), 1, slack);
  EXPECT_NEAR(of("pressure", original, large).size, std::log(warmer), slack * std::log(warmer));
  EXPECT_NEAR(of("collision_rate", original, large).size, std::log(2 * more), slack * std::log(2 * more));
  EXPECT_EQ(of("rotational_energy", original, large).deviation.value, 0);  // nothing spins
}

TEST(CoolingPrediction, ContactsThatLastLeaveItHotter) {
  const Input original = resolved(cooling, {"particles.volume_fraction=0.4"});
  Input soft = original;
  soft.scaling_law = "rps", soft.scaling_factor = 1e-4;
  const Prediction t = of("temperature", original, soft), p = of("pressure", original, soft);
  EXPECT_EQ(t.size, 0);
  EXPECT_GT(t.deviation.value, 0.01);
  EXPECT_GT(t.deviation.error, 0.3 * t.deviation.value);
  const CooledGas before = cool(scale_groups(original).gas, rate - temperature / 2),
                  after = cool(scale_groups(soft).gas, rate - temperature / 2);
  EXPECT_NEAR(std::log1p(t.deviation.value), std::log(after.mean.translational / before.mean.translational), 1e-9);
  EXPECT_NEAR(std::log1p(p.deviation.value) - std::log1p(t.deviation.value),
              (pressure - temperature) * std::log((1 + after.busy) / (1 + before.busy)), 1e-9);
}

TEST(CoolingPrediction, TorqueThatFallsShortSpinsLess) {
  const std::vector<std::string> rough = {"contact.tangential=\"mindlin\"", "material.sliding_friction=0.3"};
  const Input original = resolved(cooling, rough);
  Input sup = original, torque = original;
  sup.scaling_law = "sup", torque.scaling_law = "torque_cubed", sup.scaling_factor = torque.scaling_factor = 2;
  EXPECT_LT(of("rotational_energy", original, sup).deviation.value, of("rotational_energy", original, torque).deviation.value - 0.3);
  const Prediction lack = of("rotational_energy", original, sup);
  EXPECT_EQ(of("rotational_energy", original, torque).parts[2], 0);
  // Surfaces that slide from rest get the same impulses, which make a spin half as fast.
  Input early = original;
  early.material.sliding_friction = 0.01;
  early.run.warmup_duration = 0, early.run.duration = 1e-4;
  Input early_sup = sup;
  early_sup.run = early.run, early_sup.material = early.material;
  EXPECT_NEAR(std::exp(of("rotational_energy", early, early_sup).parts[2]), 0.25, 0.005);
  EXPECT_LT(std::exp(lack.parts[2]), 0.6);
}

TEST(CoolingPrediction, AdhesionIsHeldToWhatTheOriginalSticks) {
  const std::vector<std::string> sticky = {"contact.normal=\"jkr\"", "material.surface_energy=0.02", "run.duration=3"};
  const Input original = resolved(cooling, sticky);
  Input rps = original, none = original;
  rps.scaling_law = "rps", rps.scaling_factor = none.scaling_factor = 1e-2;
  const ScaleGroups groups = scale_groups(original);
  ASSERT_GT(1 / groups.impact_over_sticking, lumps_beyond);
  EXPECT_LT(beyond_model(groups, scale_groups(rps)), 0);
  EXPECT_GT(beyond_model(groups, scale_groups(none)), 0);
  const Prediction colder = of("temperature", original, none);
  EXPECT_LT(colder.parts[3], -0.03);
  EXPECT_GT(colder.deviation.error, std::abs(colder.deviation.value));  // theory of single impacts, where lumps begin
  EXPECT_NEAR(of("temperature", original, rps).parts[3], 0, 1e-3);
}

TEST(CoolingPrediction, NeedsTheModelsOfShear) {
  const ScaleGroups groups = scale_groups(resolved(cooling));
  EXPECT_THROW((void)predicted({}, "temperature", groups, groups), WorkError);
}

}  // namespace
}  // namespace scalebreak::tests

#include <cmath>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/prediction/flow_knowledge.hpp>

#include <ensembles/prediction_scenes.hpp>

namespace scalebreak::tests {
namespace {

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

}  // namespace
}  // namespace scalebreak::tests

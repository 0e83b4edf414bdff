#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <scalebreak/ensembles/stability/elastic_scene.hpp>
#include <scalebreak/ensembles/stability/rolling_left.hpp>
#include <scalebreak/ensembles/stability/stability_files.hpp>
#include <scalebreak/ensembles/stability/stability_study.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

/// A flow that is stable up to this fraction.
LargestStep up_to(double fraction) {
  return largest_step([](double tried) { return StepTrial{.fraction = tried}; },
                      [&](const StepTrial& trial) { return trial.fraction <= fraction; });
}

TEST(LargestStep, IsBracketedToTwoPercent) {
  for (const double fraction : {0.0031, 0.2499, 0.25, 0.37, 3.9}) {
    const LargestStep step = up_to(fraction);
    ASSERT_TRUE(step.found()) << fraction;
    EXPECT_LE(step.stable->fraction, fraction);
    EXPECT_GT(step.unstable->fraction, fraction);
    EXPECT_LE(step.unstable->fraction / step.stable->fraction, 1.02);
    EXPECT_NEAR(step.fraction() / fraction, 1, 0.02);
    EXPECT_NEAR(step.half_width() / fraction, 0.01, 0.01);
    EXPECT_LE(step.tried.size(), 16u);
  }
}

TEST(LargestStep, SaysWhereThereIsNone) {
  const LargestStep always = up_to(100), never = up_to(0);
  EXPECT_TRUE(always.stable && !always.unstable && !always.found());
  EXPECT_EQ(always.stable->fraction, 4);
  EXPECT_TRUE(never.unstable && !never.stable && !never.found());
  EXPECT_EQ(never.unstable->fraction, 1e-3);
}

const std::string small_box = R"(
[material]
young = 1e7
[contact]
tangential = "mindlin"
[particles]
count = 60
volume_fraction = 0.3
speed = 0.02
[cell]
kind = "shear"
gravity = [0, 0, 0]
[run]
replicas = 2
[study]
laws = ["rps", "sup"]
factors = [0.01, 2]
)";

TEST(ElasticScene, HasNothingThatTakesOrGivesEnergy) {
  const Input scene = elastic_scene(resolved(small_box, {"material.surface_energy=0.02", "contact.rolling=epsd2"}));
  EXPECT_EQ(scene.material.restitution, 1);
  EXPECT_EQ(scene.wall.material.restitution, 1);
  EXPECT_EQ(scene.material.surface_energy, 0);
  EXPECT_EQ(scene.contact.normal, NormalModel::hertz);
  EXPECT_FALSE(scene.surface.spins());
  EXPECT_EQ(scene.cell.shear_rate, 0);
  EXPECT_EQ(scene.particles.count, 60u);
}

TEST(StabilityStudy, HasARecordOfEveryPairOfLawAndFactorThatGoesTogetherOnAnyNumberOfThreads) {
  const Input input = resolved(small_box, {"study.integrators=[\"verlet\", \"synchronized\"]"});
  const StabilityStudy study = run_stability(input, 1);
  EXPECT_EQ(study.spheres, 60u);
  EXPECT_EQ(study.skipped, 2);  // rps at 2, sup at 0.01
  std::vector<std::string> names;
  for (const StabilityRecord& r : study.records) names.push_back(fmt::format("{} {:g} {}", r.law, r.factor, r.integrator));
  EXPECT_EQ(names, (std::vector<std::string>{"none 1 verlet", "rps 0.01 verlet", "sup 2 verlet", "none 1 synchronized",
                                             "rps 0.01 synchronized", "sup 2 synchronized"}));
  for (const StabilityRecord& record : study.records) {
    EXPECT_EQ(record.without_bracket(), 0u);
    EXPECT_LE(record.value_below(), input.study_energy_growth);
    EXPECT_GT(record.value_above(), input.study_energy_growth);
    EXPECT_EQ(record.failure(), "energy_growth exceeds its limit");
    // Without forces that depend on velocities the two integrators are one.
    EXPECT_EQ(record.step().value, study.records[static_cast<std::size_t>(&record - study.records.data()) % 3].step().value);
  }
  EXPECT_EQ(stability_csv(run_stability(input, 2)), stability_csv(study));
}

TEST(StabilityStudy, SaysHowAFlowFailsThatDoesNotReachTheCriterion) {
  // Fast and soft: a sphere crosses a tenth of a radius in a step before energy grows.
  const StabilityStudy study = run_stability(resolved(small_box, {"particles.speed=1", "study.laws=[\"rps\"]", "study.factors=[0.01]"}), 1);
  const StabilityRecord& soft = study.records.back();
  EXPECT_EQ(soft.without_bracket(), 0u);
  EXPECT_TRUE(soft.failure().starts_with("the run became unstable at t = ")) << soft.failure();
  EXPECT_TRUE(std::isnan(soft.value_above()));
  EXPECT_LT(soft.value_below(), 1e-3);
}

TEST(StabilityStudy, IsRefusedWithoutMotion) {
  EXPECT_EQ(message_of<InputError>([] { (void)run_stability(resolved(small_box, {"particles.speed=0"}), 1); }),
            "particles.speed: found 0, and a step is tried on collisions; allowed: above 0");
}

/// Two spheres, one of which spins, that stick and by a rolling law come to turn as one.
Input sticking_pair(const std::string& rolling) {
  return resolved(R"(
[material]
name = "glass"
rolling_friction = 0.1
[contact]
normal = "jkr"
tangential = "mindlin"
[run]
duration = 2e-3
[[body]]
position = [0, 0, 0.5e-3]
velocity = [0, 0, -0.001]
spin = [0, 20, 0]
radius = 0.5e-3
[[body]]
position = [0, 0, -0.5e-3]
radius = 0.5e-3
)",
                  {"contact.rolling=" + rolling});
}

/// A torque that changes its sign with the spin cannot stop it by steps: what is left is of the order of what a step's torque takes. What a spring leaves
/// is its own swinging.
TEST(RollingLeft, FallsWithTheStepUnderCdtAndNotUnderASpring) {
  const CollisionScene rigid = collision_scene(sticking_pair("cdt")), sprung = collision_scene(sticking_pair("epsd"));
  const double coarse = rolling_left(rigid, Integrator::synchronized, 0.4, 4),
               fine = rolling_left(rigid, Integrator::synchronized, 0.05, 4);
  EXPECT_GT(fine, 1e-5);
  EXPECT_LT(coarse, 1e-2);
  EXPECT_GT(coarse / fine, 2);
  EXPECT_LT(coarse / fine, 32);
  const double swinging = rolling_left(sprung, Integrator::synchronized, 0.4, 4);
  EXPECT_NEAR(rolling_left(sprung, Integrator::synchronized, 0.1, 4) / swinging, 1, 0.05);
}

TEST(RollingLeft, IsAskedForWhereRollingEnds) {
  EXPECT_TRUE(comes_to_rest(collision_scene(sticking_pair("cdt")), 1e-3));
  EXPECT_FALSE(comes_to_rest(collision_scene(sticking_pair("none")), 1e-3));
  EXPECT_FALSE(comes_to_rest(collision_scene(sticking_pair("epsd")), 1e-3));  // its spring still swings
}

}  // namespace
}  // namespace scalebreak::tests

#include <cmath>

#include <gmock/gmock.h>

#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/ensembles/engine/step_choice.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

const std::string undamped = R"(
[material]
restitution = 1
[contact]
normal = "hertz"
[particles]
count = 200
speed = 0.1
[cell]
kind = "cooling"
)";

TEST(StepChoice, IsTheFractionOfRayleighsStepWhereThatIsWithinTheBounds) {
  const Input input = resolved(undamped);
  const StepChoice choice = choose_step(input, {.smallest = {0.5e-3, 0}, .speed = 0.1});
  EXPECT_EQ(choice.limit, "step_fraction");
  EXPECT_EQ(choice.step, 0.15 * rayleigh_step(dem_setup(input, 0, 1), 0.5e-3));
  EXPECT_EQ(choice.warning, "");
}

TEST(StepChoice, KnowsTheContactTimeOfHertz) {
  const Input input = resolved(undamped);
  const double speed = 0.1, radius = 0.5e-3;
  const NormalPair pair = sphere_pair(input.material, radius, input.material, radius);
  // Reference: δ_max = (15/16)^{2/5} (m* v²/(E* √R*))^{2/5}, t_c = 2.9432752 δ_max / v.
  const double deepest = std::pow(15.0 / 16 * pair.mass * speed * speed / (pair.young * std::sqrt(pair.radius)), 0.4);
  EXPECT_NEAR(choose_step(input, {.smallest = {radius, 0}, .speed = speed}).contact_time, 2.9432752 * deepest / speed, 1e-5 * 1e-5);
}

TEST(StepChoice, TakesTheBoundWhereTheFractionExceedsItAndSaysSo) {
  const Input input = resolved(undamped, {"run.step_fraction=0.9"});
  const StepChoice choice = choose_step(input, {.smallest = {0.5e-3, 0}, .speed = 0.1});
  EXPECT_EQ(choice.limit, "contact time");
  EXPECT_EQ(choice.step, choice.bound_step);
  EXPECT_LT(choice.step, choice.asked);
  EXPECT_NEAR(choice.step, choice.contact_time / 30, 1e-6 * choice.step);
  EXPECT_THAT(choice.warning, testing::MatchesRegex("run.step_fraction = 0.9 of the Rayleigh time is a step of [0-9.e-]+ s, beyond the bound "
                                                    "of the contact time, [0-9.e-]+ s, which is taken instead"));
}

TEST(StepChoice, LooksAtTheFastestCollisionThatOccurs) {
  System start;
  start.cell.size = {0.01, 0.01, 0.1};
  start.radius = {0.4e-3, 0.5e-3};
  start.material = {0, 1};
  start.position.resize(2);
  const Input sheared = resolved("[cell]\nkind = \"shear\"\nshear_rate = 400\n");
  EXPECT_EQ(step_scene(sheared, start, 0.1).speed, 400 * 2 * 0.5e-3);
  EXPECT_EQ(step_scene(sheared, start, 3).speed, 3);
  const Input walls = resolved("[cell]\nkind = \"couette\"\nwall_speed = 20\n");
  EXPECT_DOUBLE_EQ(step_scene(walls, start, 0.1).speed, 2 * 20 / 0.1 * 2 * 0.5e-3);
  const Input falling = resolved("[cell]\nkind = \"box\"\ngravity = [0, 0, -9.81]\n");
  EXPECT_DOUBLE_EQ(step_scene(falling, start, 0.1).speed, std::sqrt(2 * 9.81 * 0.1));
  EXPECT_EQ(step_scene(falling, start, 0.1).smallest, (std::array{0.4e-3, 0.5e-3}));
}

TEST(StepChoice, APairThatSticksIsLookedAtAboveItsStickingSpeed) {
  const Input sticky = resolved("[cell]\nkind = \"cooling\"\n[particles]\nspeed = 1e-4\n");
  const StepChoice choice = choose_step(sticky, {.smallest = {0.5e-3, 0}, .speed = 1e-4});
  EXPECT_GT(choice.contact_time, 0);
}

}  // namespace
}  // namespace scalebreak::tests

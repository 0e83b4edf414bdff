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

MeetingSpeed at(double speed) { return {"speed at the start", speed}; }

TEST(StepChoice, IsTheFractionOfRayleighsStepWhereThatIsWithinTheBounds) {
  const Input input = resolved(undamped);
  const StepChoice choice = choose_step(input, {.smallest = {0.5e-3, 0}, .meeting = at(0.1)}, nullptr);
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
  EXPECT_NEAR(choose_step(input, {.smallest = {radius, 0}, .meeting = at(speed)}, nullptr).contact.time, 2.9432752 * deepest / speed,
              1e-5 * 1e-5);
}

TEST(StepChoice, TakesTheBoundWhereTheFractionExceedsItAndSaysSo) {
  const Input input = resolved(undamped, {"run.step_fraction=0.9"});
  const StepChoice choice = choose_step(input, {.smallest = {0.5e-3, 0}, .meeting = at(0.1)}, nullptr);
  EXPECT_EQ(choice.limit, "contact time");
  EXPECT_EQ(choice.step, choice.bound_step);
  EXPECT_LT(choice.step, choice.asked);
  EXPECT_NEAR(choice.step, choice.contact.time / 30, 1e-6 * choice.step);
  EXPECT_THAT(choice.warning,
              testing::MatchesRegex("run.step_fraction = 0.9 of the Rayleigh time is a step of [0-9.e-]+ s, beyond the bound "
                                    "of the contact time, [0-9.e-]+ s, which is taken instead"));
}

TEST(StepChoice, LooksAtTheFastestCollisionThatOccurs) {
  System start;
  start.cell.size = {0.01, 0.01, 0.1};
  start.radius = {0.4e-3, 0.5e-3};
  start.material = {0, 1};
  start.position.resize(2);
  const Input sheared = resolved("[cell]\nkind = \"shear\"\nshear_rate = 400\n");
  EXPECT_EQ(step_scene(sheared, start, 0.1).meeting.speed, 400 * 2 * 0.5e-3);
  EXPECT_EQ(step_scene(sheared, start, 0.1).meeting.of, "shear rate x diameter");
  EXPECT_EQ(step_scene(sheared, start, 3).meeting.speed, 3);
  EXPECT_EQ(step_scene(sheared, start, 3).meeting.of, "speed at the start");
  const Input walls = resolved("[cell]\nkind = \"couette\"\nwall_speed = 20\n");
  EXPECT_EQ(step_scene(walls, start, 0.1).meeting.speed, 20);
  EXPECT_EQ(step_scene(walls, start, 0.1).meeting.of, "wall speed");
  EXPECT_TRUE(step_scene(walls, start, 0.1).walls);
  EXPECT_FALSE(step_scene(sheared, start, 0.1).walls);
  const Input falling = resolved("[cell]\nkind = \"box\"\ngravity = [0, 0, -9.81]\n");
  EXPECT_DOUBLE_EQ(step_scene(falling, start, 0.1).meeting.speed, std::sqrt(2 * 9.81 * 0.1));
  EXPECT_EQ(step_scene(falling, start, 0.1).meeting.of, "fall through the cell");
  EXPECT_EQ(step_scene(falling, start, 0.1).smallest, (std::array{0.4e-3, 0.5e-3}));
}

TEST(StepChoice, APairThatSticksIsLookedAtAboveItsStickingSpeed) {
  const Input sticky = resolved("[cell]\nkind = \"cooling\"\n[particles]\nspeed = 1e-4\n");
  const StepChoice choice = choose_step(sticky, {.smallest = {0.5e-3, 0}, .meeting = at(1e-4)}, nullptr);
  EXPECT_GT(choice.contact.time, 0);
}

/// By table and by the exact collision, of the same scene.
std::pair<ShortestContact, ShortestContact> both_ways(const Input& input, const StepScene& scene, const TableStore& store) {
  return {choose_step(input, scene, &store).contact, choose_step(input, scene, nullptr).contact};
}

TEST(ShortestContact, OfATableIsThatOfTheExactCollision) {
  const TemporaryFolder folder;
  const TableStore store{.folder = folder.path(), .threads = 1};
  for (const char* material : {"restitution = 0.6\n", "restitution = 0.9\nsurface_energy = 0\n"}) {
    const std::string tolerance = "\n[numerics]\ntable_tolerance = 1e-3\n";
    const Input input = resolved(std::string("[material]\n") + material + "[cell]\nkind = \"cooling\"\n" + tolerance);
    for (const double speed : {1e-2, 0.3, 5.0}) {
      const auto [tabulated, exact] = both_ways(input, {.smallest = {0.5e-3, 0}, .meeting = at(speed)}, store);
      EXPECT_TRUE(tabulated.tabulated);
      EXPECT_EQ(tabulated.resolved, "");
      EXPECT_EQ(exact.resolved, "no tables are used");
      EXPECT_GT(exact.time, 0);
      EXPECT_NEAR(tabulated.time / exact.time, 1, 1e-3) << material << speed;
      EXPECT_NE(tabulated.time, exact.time);  // it did come from the table
    }
  }
}

TEST(ShortestContact, OfADirectForceLawIsResolvedExactlyAndSaysSo) {
  const TemporaryFolder folder;
  const TableStore store{.folder = folder.path(), .threads = 1};
  const Input input = resolved(undamped, {"scaling.law=sup", "scaling.factor=2"});
  const auto [contact, exact] = both_ways(input, {.smallest = {1e-3, 0}, .meeting = at(0.1)}, store);
  EXPECT_FALSE(contact.tabulated);
  EXPECT_EQ(contact.resolved, "the direct-force law sup has no table");
  EXPECT_EQ(contact.time, exact.time);
  const Input original = resolved(undamped);
  const double once = choose_step(original, {.smallest = {0.5e-3, 0}, .meeting = at(0.1)}, nullptr).contact.time;
  EXPECT_NEAR(contact.time / once, 2, 1e-5);  // SUP: times grow as the size does
}

TEST(ShortestContact, IsThatOfWhoeverMeetsTheShortest) {
  // A rigid wall is stiffer than a sphere: with twice the mass, radius and modulus, (2² / (2² 2))^{1/5} of the time.
  const std::string rigid = "[material]\nrestitution = 1\n[wall]\nrigid = true\n[contact]\nnormal = \"hertz\"\n[cell]\nkind = \"box\"\n";
  const StepScene spheres{.smallest = {0.5e-3, 0}, .meeting = at(0.1)}, walled{.smallest = {0.5e-3, 0}, .meeting = at(0.1), .walls = true};
  const ShortestContact free = choose_step(resolved(rigid), spheres, nullptr).contact;
  const ShortestContact wall = choose_step(resolved(rigid), walled, nullptr).contact;
  EXPECT_EQ(free.of, "[material] with [material]");
  EXPECT_EQ(wall.of, "[material] with [wall]");
  EXPECT_NEAR(wall.time / free.time, std::pow(0.5, 0.2), 1e-5);
}

}  // namespace
}  // namespace scalebreak::tests

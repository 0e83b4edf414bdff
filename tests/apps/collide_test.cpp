#include <fmt/format.h>
#include <gmock/gmock.h>

#include <apps/collide.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(Collide, RunsAsItStands) {
  const ProgramRun result = run({"collide"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, HasSubstr("modelled: jkr, full, contact_radius"));
  EXPECT_THAT(result.out, HasSubstr("restitution"));
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(Collide, JsonIsOneObjectWithTheDocumentedKeys) {
  const ProgramRun result = run({"collide", "--json"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  const json j = result.json();
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["stuck"], false);
  EXPECT_TRUE(j["restitution_tangential"].is_null() && j["restitution_surface"].is_null()) << "there is no tangential speed to divide by";
  for (const char* key : {"velocity1", "velocity2", "spin1", "spin2"}) EXPECT_EQ(j[key].size(), 3u) << key;
  EXPECT_GT(j["steps"].get<int>(), 0);
  EXPECT_EQ(j["modelled"], "jkr, full, contact_radius");
}

TEST_F(Collide, TwoSpheresKeepMomentumAndLoseEnergyByTheRestitution) {
  const json j = collide({});
  const double e = j["restitution_normal"], v1 = j["velocity1"][2], v2 = j["velocity2"][2], m = mass(0.5e-3);
  EXPECT_GT(e, 0.7);
  EXPECT_LT(e, 0.81) << "adhesion takes its part";
  EXPECT_NEAR(v1 + v2, -0.1, 1e-15);
  EXPECT_NEAR(v1 - v2, 0.1 * e, 1e-15);
  EXPECT_NEAR(j["energy_before"].get<double>() / (m * 0.01 / 2), 1, 1e-12);
  EXPECT_NEAR(j["energy_after"].get<double>() / (m * (v1 * v1 + v2 * v2) / 2), 1, 1e-12);
}

TEST_F(Collide, APairBelowItsStickingSpeedSticks) {
  const json j = collide({"impact.normal_speed=1e-4"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["stuck"], true);
  EXPECT_EQ(j["restitution_normal"], 0);
  EXPECT_TRUE(j["contact_time"].is_null());
  EXPECT_GT(j["sticking_speed"].get<double>(), 1e-4);
  EXPECT_NEAR(j["velocity1"][2].get<double>(), -0.5e-4, 1e-18);
  EXPECT_EQ(j["velocity1"], j["velocity2"]) << "the common motion";
  EXPECT_NEAR(j["energy_after"].get<double>() / j["energy_before"].get<double>(), 0.5, 1e-12);
}

TEST_F(Collide, TheStickingSpeedDividesWhatSticksFromWhatDoesNot) {
  const double speed = collide({})["sticking_speed"];
  EXPECT_EQ(collide({fmt::format("impact.normal_speed={}", speed * (1 - 1e-6))})["stuck"], true);
  EXPECT_EQ(collide({fmt::format("impact.normal_speed={}", speed * (1 + 1e-6))})["stuck"], false);
}

TEST_F(Collide, WithoutAdhesionThereIsNoStickingSpeed) {
  const json hertz = collide({"contact.normal=hertz"});
  EXPECT_TRUE(hertz["sticking_speed"].is_null());
  EXPECT_EQ(hertz["modelled"], "hertz, touch, overlap");
  EXPECT_NEAR(hertz["restitution_normal"].get<double>(), 0.81, 1e-7);
  EXPECT_EQ(collide({"material.surface_energy=0"})["modelled"], "hertz, touch, overlap") << "JKR without surface energy is Hertz";
  EXPECT_NEAR(collide({"contact.normal=linear"})["restitution_normal"].get<double>(), 0.81, 1e-7);
}

TEST_F(Collide, WhereNothingCanStickTheStickingSpeedIsZero) {
  const json j = collide({"contact.adhesion_range=touch", "material.restitution=1"});
  EXPECT_EQ(j["sticking_speed"], 0);
  EXPECT_NEAR(j["restitution_normal"].get<double>(), 1, 1e-7);
}

TEST_F(Collide, ASphereComesBackFromAWallThatDoesNotMove) {
  const json j = collide({"pair.partner=wall", "pair.radius=[1e-3]", "wall.restitution=0.5", "contact.normal=hertz"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_NEAR(j["restitution_normal"].get<double>(), 0.5, 1e-7);
  EXPECT_NEAR(j["velocity1"][2].get<double>(), 0.05, 1e-8);
  EXPECT_EQ(j["velocity2"], (json{0.0, 0.0, 0.0}));
  EXPECT_NEAR(j["energy_before"].get<double>() / (mass(1e-3) * 0.01 / 2), 1, 1e-12);
}

TEST_F(Collide, AScalingLawIsApplied) {
  const json original = collide({});
  const json softer = collide({"scaling.law=rps", "scaling.factor=0.01"});
  const json larger = collide({"scaling.law=sup", "scaling.factor=4"});
  EXPECT_NEAR(softer["restitution_normal"].get<double>(), original["restitution_normal"].get<double>(), 1e-7);
  EXPECT_NEAR(larger["restitution_normal"].get<double>(), original["restitution_normal"].get<double>(), 1e-7);
  EXPECT_NEAR(larger["contact_time"].get<double>() / original["contact_time"].get<double>(), 4, 1e-6);
  EXPECT_NEAR(larger["energy_before"].get<double>() / original["energy_before"].get<double>(), 64, 1e-9);
}

TEST_F(Collide, AnObliquePairGivesAllThreeRestitutions) {
  const json j = collide({"impact.tangential_speed=0.15", "impact.spin1=[0,20,0]", "contact.tangential=mindlin", "contact.rolling=ar"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["modelled"], "jkr, full, contact_radius; mindlin on contact_radius, rolling ar, torque arm radius");
  const json v1 = j["velocity1"], v2 = j["velocity2"];
  const double along = v1[0].get<double>() - v2[0].get<double>(), turning = j["spin1"][1].get<double>() + j["spin2"][1].get<double>();
  EXPECT_NEAR(j["restitution_tangential"].get<double>(), along / 0.15, 1e-13);
  EXPECT_NEAR(j["restitution_surface"].get<double>(), -(along - 0.5e-3 * turning) / (0.15 - 0.5e-3 * 20), 1e-12);
  EXPECT_GT(j["contact_time"].get<double>(), 1e-6);
  EXPECT_EQ(j["contacts"], 1);
  EXPECT_GT(j["energy_account"]["after"]["friction"].get<double>(), 0);
  expect_balanced(j, 1e-7);
  for (const std::size_t k : {0, 1, 2}) EXPECT_NEAR(j["momentum_after"][k].get<double>(), j["momentum_before"][k].get<double>(), 1e-20);
}

TEST_F(Collide, ADivisorOfZeroGivesNull) {
  const json spun = collide({"impact.spin1=[0,20,0]", "contact.tangential=mindlin"});
  EXPECT_TRUE(spun["restitution_tangential"].is_null());
  EXPECT_TRUE(spun["restitution_surface"].is_number());
  const json matched =
      collide({"impact.spin1=[0,100,0]", "impact.spin2=[0,100,0]", "impact.tangential_speed=0.1", "contact.tangential=mindlin"});
  EXPECT_TRUE(matched["restitution_surface"].is_null()) << "the surfaces move together";
  EXPECT_TRUE(matched["restitution_tangential"].is_number());
}

TEST_F(Collide, AnObliquePairThatSticksTurnsAsOne) {
  const json j = collide({"impact.normal_speed=1e-4", "impact.tangential_speed=2e-4", "contact.tangential=mindlin"});
  EXPECT_EQ(j["stuck"], true);
  for (const char* key : {"restitution_normal", "restitution_tangential", "restitution_surface"}) EXPECT_EQ(j[key], 0) << key;
  EXPECT_TRUE(j["contact_time"].is_null());
  EXPECT_EQ(j["spin1"], j["spin2"]);
  EXPECT_GT(j["spin1"][1].get<double>(), 0);
  EXPECT_EQ(j["resting"], true);
  expect_balanced(j, 1e-6);
}

TEST_F(Collide, ASphereOnAWallWithFrictionTakesSpinFromIt) {
  const json j = collide({"pair.partner=wall", "pair.radius=[1e-3]", "impact.tangential_speed=0.3", "contact.tangential=mindlin",
                          "contact.normal=hertz", "wall.sliding_friction=0.05"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["velocity2"], (json{0.0, 0.0, 0.0}));
  const double lost = 0.3 - j["velocity1"][0].get<double>();
  EXPECT_NEAR(j["spin1"][1].get<double>() / (2.5 * lost / 1e-3), 1, 1e-9) << "one impulse gives both";
  EXPECT_GT(lost / (0.05 * 0.1 * 1.81), 0.99);
  expect_balanced(j, 1e-7);
}

TEST_F(Collide, ALiquidHasNoStickingSpeedOfTheSolids) {
  const json j = collide({"contact.attraction=capillary+viscous", "impact.normal_speed=0.5"});
  EXPECT_TRUE(j["sticking_speed"].is_null());
  EXPECT_EQ(j["ruptures"], 1);
  EXPECT_GT(j["energy_account"]["after"]["liquid"].get<double>(), 0);
  EXPECT_GT(j["time"].get<double>(), 10 * j["contact_time"].get<double>()) << "the bridge outlives the contact";
  expect_balanced(j, 1e-7);
}

TEST_F(Collide, RemarksSayWhatHasNoEffectAndWhatIsTooDeep) {
  const ProgramRun idle = run({"collide", "--json", "--set", "impact.spin1=[0,0,5]"});
  EXPECT_EQ(idle.status, 0);
  EXPECT_EQ(idle.err, "scalebreak: spins are given, but no law acts on them: they stay as they are\n");
  EXPECT_EQ(idle.json()["spin1"], (json{0.0, 0.0, 5.0}));
  const ProgramRun deep = run({"collide", "--json", "--set", "material.young=1e6", "--set", "impact.normal_speed=1", "--set",
                               "impact.tangential_speed=1", "--set", "contact.tangential=mindlin"});
  EXPECT_EQ(deep.status, 0);
  EXPECT_EQ(deep.err, "scalebreak: the largest overlap exceeds a tenth of R*, more than the contact laws are meant for\n");
}

}  // namespace
}  // namespace scalebreak::tests

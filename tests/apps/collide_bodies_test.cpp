#include <cmath>

#include <gmock/gmock.h>

#include <apps/collide.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::IsEmpty;

namespace fs = std::filesystem;

TEST_F(Collide, TwoBodiesFlyMeetAndPart) {
  const ProgramRun result = run({"collide", scene("bodies.toml", two_bodies), "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  for (const char* key : {"bodies", "contacts", "energy_before", "energy_after"}) EXPECT_TRUE(j.contains(key)) << key;
  for (const char* key : {"velocity1", "spin2"}) EXPECT_FALSE(j.contains(key)) << key;
  EXPECT_EQ(j["contacts"], 1);
  ASSERT_EQ(j["bodies"].size(), 2u);
  for (const json& body : j["bodies"]) EXPECT_EQ(keys_of(body), (std::set<std::string>{"position", "velocity", "spin"}));
  const double v1 = j["bodies"][0]["velocity"][2], v2 = j["bodies"][1]["velocity"][2];
  EXPECT_NEAR(v1 - v2, 0.5 * 0.75, 1e-7);
  EXPECT_NEAR(v1 + 8 * v2, -0.5 + 8 * 0.25, 1e-12);
  const double z1 = j["bodies"][0]["position"][2], z2 = j["bodies"][1]["position"][2];
  EXPECT_NEAR(z1 - z2, 3e-3, 1e-12) << "left at the end of the contact";
  const double flight = (0.01 - 0.003) / 0.75, time = flight + j["contact_time"].get<double>();
  EXPECT_NEAR((z1 + 8 * z2) / 9, 0.01 / 9 + time * 1.5 / 9, 1e-12) << "the centre of mass goes on";
}

TEST_F(Collide, ThreeBodiesAreFollowedThroughAllTheirContacts) {
  const ProgramRun result = run({"collide", scene("bodies.toml", three_bodies), "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  for (const char* key : {"stuck", "restitution_normal", "sticking_speed", "contact_time", "velocity1"})
    EXPECT_FALSE(j.contains(key)) << key;
  ASSERT_EQ(j["bodies"].size(), 3u);
  EXPECT_EQ(j["contacts"], 2);
  EXPECT_EQ(j["open_contacts"], 0);
  EXPECT_GT(j["bodies"][2]["velocity"][0].get<double>(), 0.2) << "the last takes the blow";
  expect_balanced(j, 1e-7);
  for (const std::size_t k : {0, 1, 2})
    EXPECT_NEAR(j["momentum_after"][k].get<double>(), j["momentum_before"][k].get<double>(), 1e-12 * mass(1e-3) * 0.5);
}

TEST_F(Collide, ALawThatIsExactScalesAWholeSceneOfBodies) {
  const std::string file = scene("bodies.toml", three_bodies);
  const json original = run({"collide", file, "--json"}).json();
  const json larger = run({"collide", file, "--json", "--set", "scaling.law=torque_cubed", "--set", "scaling.factor=3"}).json();
  ASSERT_EQ(larger["bodies"].size(), 3u);
  EXPECT_NEAR(larger["time"].get<double>() / original["time"].get<double>(), 3, 1e-6);
  EXPECT_NEAR(larger["energy_before"].get<double>() / original["energy_before"].get<double>(), 27, 1e-9);
  // Equal masses: the centre of mass is the mean of the positions.
  const std::vector<double> centre = {-0.3e-3, 0.5e-3 / 3, 0.1e-3}, drift = {0.5 / 3, 0, 0};
  const double time = original["time"];
  for (const std::size_t b : {0, 1, 2}) {
    for (const std::size_t k : {0, 1, 2}) {
      const double at = original["bodies"][b]["position"][k].get<double>() - centre[k] - time * drift[k];
      const double scaled = larger["bodies"][b]["position"][k].get<double>() - centre[k] - 3 * time * drift[k];
      EXPECT_NEAR(scaled, 3 * at, 1e-9) << b << ' ' << k;
    }
    for (const std::size_t k : {0, 1, 2}) {
      EXPECT_NEAR(larger["bodies"][b]["velocity"][k].get<double>(), original["bodies"][b]["velocity"][k].get<double>(), 1e-7);
      EXPECT_NEAR(3 * larger["bodies"][b]["spin"][k].get<double>(), original["bodies"][b]["spin"][k].get<double>(), 1e-4);
    }
  }
  // A torque that grows with the square of the size alone does not.
  const json sup = run({"collide", file, "--json", "--set", "scaling.law=sup", "--set", "scaling.factor=3"}).json();
  EXPECT_GT(std::abs(3 * sup["bodies"][1]["spin"][1].get<double>() - original["bodies"][1]["spin"][1].get<double>()), 1);
}

TEST_F(Collide, BodiesThatNeverComeToAnEndNeedADuration) {
  // Undamped and without friction: it slides round and round the other, and swings in its adhesion for ever.
  const std::string file = scene("bound.toml", R"([material]
restitution = 1
[[body]]
position = [0, 0, 1e-3]
velocity = [1e-2, 0, -1e-4]
radius = 0.5e-3
[[body]]
position = [0, 0, 0]
radius = 0.5e-3
fixed = true
)");
  const ProgramRun endless = run({"collide", file, "--json", "--out", out});
  EXPECT_EQ(endless.status, 1);
  EXPECT_THAT(endless.out, IsEmpty());
  EXPECT_EQ(
      endless.err,
      "scalebreak: the motion has not ended after 50000 events of its contacts; give its [[body]] scene a run.duration (a [pair] can be written as one)\n");
  EXPECT_FALSE(fs::exists(out));
  const ProgramRun ended = run({"collide", file, "--json", "--set", "run.duration=1e-3"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.json()["open_contacts"], 1);
  EXPECT_EQ(ended.json()["resting"], false);
  EXPECT_NEAR(ended.json()["time"].get<double>(), 1e-3, 1e-12);
}

}  // namespace
}  // namespace scalebreak::tests

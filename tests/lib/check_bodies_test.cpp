#include <scalebreak/scene/check_bodies.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <lib/resolving.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using tests::resolved;
using tests::sentence_for;

/// Two bodies, the second at rest in the origin, of 1 mm radius both.
std::string two_bodies(const std::string& position, const std::string& velocity) {
  return fmt::format("[[body]]\nposition = {}\nvelocity = {}\nradius = 1e-3\n[[body]]\nposition = [0, 0, 0]\nradius = 1e-3\n", position,
                     velocity);
}

TEST(CheckBodies, CannotStandBesideAPair) {
  const std::string bodies = two_bodies("[0, 0, 0.01]", "[0, 0, -1]");
  EXPECT_EQ(sentence_for(bodies + "[pair]\nradius = [1e-3, 1e-3]\n"),
            "scene.toml, line 9: pair.radius cannot stand beside [[body]]: the bodies say where they are and how they move");
  EXPECT_EQ(sentence_for(bodies, {"impact.normal_speed=1"}),
            "--set impact.normal_speed=1: impact.normal_speed cannot stand beside [[body]]: the bodies say where they are and how they "
            "move");
}

TEST(CheckBodies, NeedPositionAndRadius) {
  const std::string needed = " is missing; every [[body]] needs position and radius";
  EXPECT_EQ(sentence_for("[[body]]\nposition = [0, 0, 1]\n[[body]]\nposition = [0, 0, 0]\nradius = 1e-3\n"), "body.1.radius" + needed);
  EXPECT_EQ(sentence_for("[[body]]\nposition = [0, 0, 1]\nradius = 1e-3\n[[body]]\nradius = 1e-3\n"), "body.2.position" + needed);
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 0.01]", "[0, 0, -1]") + "[[body]]\nfixed = true\n"), "body.3.position" + needed);
}

TEST(CheckBodies, AreAtLeastTwo) {
  EXPECT_EQ(sentence_for("[[body]]\nposition = [0, 0, 1]\nradius = 1e-3\n"),
            "scene.toml, line 2: body.1.position: found 1 body; allowed: 2 to 50 [[body]] tables, or none");
}

TEST(CheckBodies, EmptyTablesAreNotPassedOver) {
  EXPECT_THAT(sentence_for("[[body]]\n[[body]]\n"), HasSubstr("body.1"));
  EXPECT_THAT(sentence_for("[[body]]\n[[body]]\nposition = [0, 0, 1]\nradius = 1e-3\n"), HasSubstr("body.1"));
  EXPECT_THAT(sentence_for(two_bodies("[0, 0, 0.01]", "[0, 0, -1]") + "[[body]]\n"), HasSubstr("body.3"));
}

TEST(CheckBodies, MayNotOverlapAtTheStart) {
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 1.5e-3]", "[0, 0, -1]")),
            "scene.toml, line 6: body.1 and body.2 overlap by 0.0005 m at the start (distance 0.0015 m, radii 0.001 m and 0.001 m); "
            "allowed: at most 1e-09 of the radius");
  EXPECT_THAT(sentence_for(two_bodies("[0, 0, 0]", "[0, 0, -1]")), HasSubstr("overlap by 0.002 m at the start (distance 0 m"));
}

TEST(CheckBodies, CountAsTouchingUpToABillionthOfTheRadius) {
  EXPECT_EQ(resolved(two_bodies("[0, 0, 1.9999999991e-3]", "[0, 0, -1]")).bodies.size(), 2u);
  EXPECT_EQ(resolved(two_bodies("[0, 0, 2e-3]", "[0, 0, -1]")).bodies.size(), 2u);
  EXPECT_THAT(sentence_for(two_bodies("[0, 0, 1.9999999989e-3]", "[0, 0, -1]")), HasSubstr("overlap"));
}

TEST(CheckBodies, OfManyNoTwoMayOverlap) {
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 0.01]", "[0, 0, -1]") + "[[body]]\nposition = [0, 0, 0.0115]\nradius = 1e-3\nfixed = true\n"),
            "scene.toml, line 9: body.1 and body.3 overlap by 0.0005 m at the start (distance 0.0015 m, radii 0.001 m and 0.001 m); "
            "allowed: at most 1e-09 of the radius");
}

TEST(CheckBodies, TwoOfThemMeet) {
  const std::string never =
      "scene.toml, line 3: the bodies never meet: no two of them touch or are on a collision course, found a least "
      "distance of ";
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 0.01]", "[0, 0, 1]")), never + "0.008 m between the surfaces of body.1 and body.2; allowed: 0");
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 0.01]", "[0, 0, 0]")), never + "0.008 m between the surfaces of body.1 and body.2; allowed: 0");
  EXPECT_EQ(sentence_for(two_bodies("[0, 0.003, 0.01]", "[0, 0, -1]")),
            never + "0.001 m between the surfaces of body.1 and body.2; allowed: 0");
  EXPECT_EQ(resolved(two_bodies("[0, 0.0019, 0.01]", "[0, 0, -1]")).bodies.size(), 2u) << "an oblique course";
  EXPECT_EQ(resolved(two_bodies("[0, 0, 2e-3]", "[0, 0, 1]")).bodies.size(), 2u) << "they touch";
  EXPECT_EQ(resolved(two_bodies("[0, 0, 2e-3]", "[0, 0, 0]")).bodies.size(), 2u);
}

TEST(CheckBodies, OneMeetingOfManyIsEnough) {
  const std::string apart = two_bodies("[0, 0, 0.01]", "[0, 0, 1]");
  EXPECT_EQ(resolved(apart + "[[body]]\nposition = [0, 0, 0.02]\nradius = 1e-3\n").bodies.size(), 3u);
  EXPECT_EQ(
      sentence_for(apart + "[[body]]\nposition = [0, 0, -0.005]\nradius = 1e-3\n"),
      "scene.toml, line 3: the bodies never meet: no two of them touch or are on a collision course, found a least distance of 0.003 m "
      "between the surfaces of body.2 and body.3; allowed: 0");
}

TEST(CheckBodies, FixedOnesDoNotMeetEachOther) {
  const std::string bodies = two_bodies("[0, 0, 0.01]", "[0, 0, -1]");
  EXPECT_EQ(sentence_for(bodies, {"body.1.fixed=true", "body.2.fixed=true"}),
            "scene.toml, line 3: the bodies never meet: all of them have fixed = true; allowed: at least one with fixed = false");
  EXPECT_EQ(resolved(bodies, {"body.1.fixed=true"}).bodies.size(), 2u) << "a fixed one may move";
  const std::string bystander = "[[body]]\nposition = [0.1, 0, 0]\nradius = 1e-3\n";
  EXPECT_EQ(sentence_for(bodies + bystander, {"body.1.fixed=true", "body.2.fixed=true"}),
            "scene.toml, line 3: the bodies never meet: no two of them touch or are on a collision course, found a least distance of "
            "0.098 m between the surfaces of body.1 and body.3; allowed: 0");
}

TEST(CheckBodies, SpinWithoutAnyLawThatTurnsThem) {
  EXPECT_EQ(resolved(two_bodies("[0, 0, 0.01]", "[0, 0, -1]"), {"body.1.spin=[0, 0, 5]"}).bodies[0].spin.z(), 5);
}

TEST(CheckBodies, MayBeFollowedForATime) {
  EXPECT_EQ(resolved(two_bodies("[0, 0, 0.01]", "[0, 0, -1]"), {"run.duration=0.25"}).run.duration, 0.25);
}

}  // namespace
}  // namespace scalebreak

#include <scalebreak/scene/check_input.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <lib/resolving.hpp>

namespace scalebreak {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::resolved;
using tests::sentence_for;

/// Two bodies, the second at rest in the origin, of 1 mm radius both.
std::string two_bodies(const std::string& position, const std::string& velocity) {
  return fmt::format("[[body]]\nposition = {}\nvelocity = {}\nradius = 1e-3\n[[body]]\nposition = [0, 0, 0]\nradius = 1e-3\n", position,
                     velocity);
}

TEST(CheckContact, AdhesionRangeNeedsAdhesion) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"hertz\"\nadhesion_range = \"full\"\n"),
            "scene.toml, line 3: contact.adhesion_range = \"full\" needs adhesion, and contact.normal = \"hertz\" has none; allowed: "
            "\"touch\", or normal = \"jkr\"");
  EXPECT_EQ(sentence_for("[contact]\nadhesion_range = \"pull_off\"\n", {"contact.normal=hertz"}),
            "scene.toml, line 2: contact.adhesion_range = \"pull_off\" needs adhesion, and contact.normal = \"hertz\" has none; allowed: "
            "\"touch\", or normal = \"jkr\"");
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"linear\"\n", {"contact.adhesion_range=pull_off"}),
            "--set contact.adhesion_range=pull_off: contact.adhesion_range = \"pull_off\" needs adhesion, and contact.normal = \"linear\" "
            "has none; allowed: \"touch\", or normal = \"jkr\"");
}

TEST(CheckContact, ALinearContactHasNoContactRadius) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"linear\"\ndamping_on = \"contact_radius\"\n"),
            "scene.toml, line 3: contact.damping_on = \"contact_radius\" needs a contact radius, and contact.normal = \"linear\" has none; "
            "allowed: \"overlap\", or normal = \"hertz\" or \"jkr\"");
}

TEST(CheckContact, RangeAndDashpotFollowTheNormalLaw) {
  const ContactKind hertz{NormalModel::hertz, AdhesionRange::touch, DampingOn::overlap};
  EXPECT_EQ(resolved("[contact]\nnormal = \"hertz\"\n").contact, hertz);
  EXPECT_EQ(resolved("[contact]\nnormal = \"hertz\"\nadhesion_range = \"touch\"\ndamping_on = \"contact_radius\"\n").contact, hertz);
  EXPECT_EQ(resolved("[contact]\nnormal = \"linear\"\ndamping_on = \"overlap\"\n").contact,
            (ContactKind{NormalModel::linear, AdhesionRange::touch, DampingOn::overlap}));
  EXPECT_EQ(resolved("[contact]\nadhesion_range = \"touch\"\n").contact,
            (ContactKind{NormalModel::jkr, AdhesionRange::touch, DampingOn::contact_radius}));
}

TEST(CheckPair, RadiiMatchThePartner) {
  EXPECT_EQ(sentence_for("[pair]\nradius = [1e-3, 1e-3]\npartner = \"wall\"\n"),
            "scene.toml, line 2: pair.radius holds two radii for pair.partner = \"wall\"; allowed: one, [r1]");
  EXPECT_EQ(sentence_for("[pair]\nradius = [1e-3]\n"),
            "scene.toml, line 2: pair.radius holds one radius for pair.partner = \"sphere\"; allowed: two, [r1, r2]");
  EXPECT_THAT(resolved("[pair]\npartner = \"wall\"\n").radius, ElementsAre(0.5e-3));
  EXPECT_THAT(resolved("[pair]\npartner = \"wall\"\nradius = [2e-3]\n").radius, ElementsAre(2e-3));
  EXPECT_FALSE(resolved("[pair]\npartner = \"sphere\"\n").against_wall);
}

TEST(CheckBodies, CannotStandBesideAPair) {
  const std::string bodies = two_bodies("[0, 0, 0.01]", "[0, 0, -1]");
  EXPECT_EQ(sentence_for(bodies + "[pair]\nradius = [1e-3, 1e-3]\n"),
            "scene.toml, line 9: pair.radius cannot stand beside [[body]]: the bodies say where they are and how they move");
  EXPECT_EQ(sentence_for(bodies, {"impact.normal_speed=1"}),
            "--set impact.normal_speed=1: impact.normal_speed cannot stand beside [[body]]: the bodies say where they are and how they "
            "move");
}

TEST(CheckBodies, NeedPositionAndRadiusOfBoth) {
  const std::string needed = " is missing; two [[body]] tables are needed, each with position and radius";
  EXPECT_EQ(sentence_for("[[body]]\nposition = [0, 0, 1]\n[[body]]\nposition = [0, 0, 0]\nradius = 1e-3\n"), "body.1.radius" + needed);
  EXPECT_EQ(sentence_for("[[body]]\nposition = [0, 0, 1]\nradius = 1e-3\n[[body]]\nradius = 1e-3\n"), "body.2.position" + needed);
  EXPECT_EQ(sentence_for("[[body]]\nposition = [0, 0, 1]\nradius = 1e-3\n"), "body.2.position" + needed);
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

TEST(CheckBodies, MustApproachEachOther) {
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 0.01]", "[0, 0, 1]")),
            "scene.toml, line 6: body.1 and body.2 do not approach each other, found a closing speed of -1 m/s; allowed: above 0");
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 0.01]", "[0, 0, 0]")),
            "scene.toml, line 6: body.1 and body.2 do not approach each other, found a closing speed of 0 m/s; allowed: above 0");
}

TEST(CheckBodies, MustMeetHeadOn) {
  EXPECT_EQ(sentence_for(two_bodies("[0, 0, 0.01]", "[0.25, 0, -1]")),
            "scene.toml, line 6: body.1 and body.2 do not meet head-on, and contact.tangential = \"none\" resolves head-on collisions "
            "only; found 0.25 m/s across the line of centres; allowed: 1e-06 of the closing speed");
  EXPECT_EQ(resolved(two_bodies("[0.006, 0, 0.008]", "[-0.6, 0, -0.8]")).bodies.size(), 2u);
  EXPECT_EQ(resolved(two_bodies("[0, 0, 0.01]", "[0.9e-6, 0, -1]")).bodies.size(), 2u);
  EXPECT_THAT(sentence_for(two_bodies("[0, 0, 0.01]", "[1.1e-6, 0, -1]")), HasSubstr("do not meet head-on"));
}

TEST(CheckScaling, AFactorOnTheWrongSideOfOneIsRefused) {
  EXPECT_EQ(sentence_for("[scaling]\nlaw = \"rps\"\nfactor = 2\n"),
            "scene.toml, line 3: scaling.law = \"rps\" reduces the stiffness, its scaling.factor lies in (0, 1], found 2");
  EXPECT_EQ(sentence_for("[scaling]\nlaw = \"sup\"\n", {"scaling.factor=0.5"}),
            "--set scaling.factor=0.5: scaling.law = \"sup\" enlarges the particles, its scaling.factor is at least 1, found 0.5");
}

TEST(CheckScaling, AFactorOfOneSuitsEveryLawAndNoneTakesBothSides) {
  for (const char* law :
       {"none", "rps", "sup", "overlap_kept", "force_cubed", "torque_cubed", "sakai", "chen_elliott", "bond", "cohesion", "thakur"}) {
    EXPECT_EQ(resolved(fmt::format("[scaling]\nlaw = \"{}\"\n", law)).scaling_law, law);
  }
  EXPECT_EQ(resolved("[scaling]\nfactor = 0.1\n").scaling_factor, 0.1);
  EXPECT_EQ(resolved("[scaling]\nfactor = 4\n").scaling_factor, 4);
}

TEST(CheckScaling, ALawNeedsSomethingToScale) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"hertz\"\n[scaling]\nlaw = \"bond\"\n"),
            "scene.toml, line 4: scaling.law = \"bond\" scales the surface energy alone, which contact.normal = \"hertz\" does not use; "
            "use \"jkr\"");
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"linear\"\n[scaling]\nlaw = \"cohesion\"\n"),
            "scene.toml, line 4: scaling.law = \"cohesion\" scales the surface energy alone, which contact.normal = \"linear\" does not "
            "use; use \"jkr\"");
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"linear\"\n[scaling]\nlaw = \"chen_elliott\"\n"),
            "scene.toml, line 4: scaling.law = \"chen_elliott\" scales Young's modulus, which contact.normal = \"linear\" does not use; "
            "use \"hertz\" or \"jkr\"");
  EXPECT_EQ(resolved("[contact]\nnormal = \"hertz\"\n[scaling]\nlaw = \"chen_elliott\"\n").scaling_law, "chen_elliott");
}

TEST(CheckScaling, ALawThatDoesNotSuitTheContactIsBlamedOnTheLawNotOnItsFactor) {
  const std::string sentence = sentence_for("[contact]\nnormal = \"hertz\"\n[scaling]\nlaw = \"bond\"\nfactor = 2\n");
  EXPECT_THAT(sentence, testing::StartsWith("scene.toml, line 4: scaling.law = \"bond\" scales"));
}

TEST(CheckStudy, EveryLawNeedsAFactorThatSuitsIt) {
  EXPECT_EQ(sentence_for("[study]\nlaws = [\"sup\", \"rps\"]\nfactors = [2, 4]\n"),
            "scene.toml, line 2: study.laws holds \"rps\", which no factor of study.factors suits: scaling.law = \"rps\" reduces the "
            "stiffness, its scaling.factor lies in (0, 1], found 4");
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"hertz\"\n[study]\nlaws = [\"cohesion\"]\n"),
            "scene.toml, line 4: study.laws holds \"cohesion\", which no factor of study.factors suits: scaling.law = \"cohesion\" scales "
            "the surface energy alone, which contact.normal = \"hertz\" does not use; use \"jkr\"");
  EXPECT_THAT(resolved("[study]\nlaws = [\"sup\", \"rps\"]\nfactors = [0.5, 4]\n").study_laws, ElementsAre("sup", "rps"));
}

}  // namespace
}  // namespace scalebreak

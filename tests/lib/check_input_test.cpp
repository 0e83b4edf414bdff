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

TEST(CheckPair, RadiiMatchThePartner) {
  EXPECT_EQ(sentence_for("[pair]\nradius = [1e-3, 1e-3]\npartner = \"wall\"\n"),
            "scene.toml, line 2: pair.radius holds two radii for pair.partner = \"wall\"; allowed: one, [r1]");
  EXPECT_EQ(sentence_for("[pair]\nradius = [1e-3]\n"),
            "scene.toml, line 2: pair.radius holds one radius for pair.partner = \"sphere\"; allowed: two, [r1, r2]");
  EXPECT_THAT(resolved("[pair]\npartner = \"wall\"\n").radius, ElementsAre(0.5e-3));
  EXPECT_THAT(resolved("[pair]\npartner = \"wall\"\nradius = [2e-3]\n").radius, ElementsAre(2e-3));
  EXPECT_FALSE(resolved("[pair]\npartner = \"sphere\"\n").against_wall);
}

TEST(CheckPair, EndsByItself) {
  EXPECT_EQ(sentence_for("[run]\nduration = 1\n"),
            "scene.toml, line 2: run.duration cannot stand without [[body]], [particles] or [cell]: a pair of [pair] ends by itself");
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

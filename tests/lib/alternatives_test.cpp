#include <scalebreak/scene/alternatives.hpp>

#include <gtest/gtest.h>

#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>

namespace scalebreak {
namespace {

using tests::resolved;
using tests::sentence_for;

TEST(Alternatives, ExcludeEachOtherInOneSection) {
  EXPECT_EQ(
      sentence_for("[material]\nliquid_volume = 1e-12\nliquid_fraction = 0.01\n"),
      "scene.toml, line 3: material.liquid_fraction and material.liquid_volume exclude each other, found 0.01 and 1e-12; allowed: one of "
      "the two, or material.liquid_fraction = 0");
  EXPECT_EQ(sentence_for("[wall]\nseparation_min_ratio = 0.01\n", {"wall.separation_min=1e-7"}),
            "--set wall.separation_min=1e-7: wall.separation_min and wall.separation_min_ratio exclude each other, found 1e-07 and 0.01; "
            "allowed: one of the two, or wall.separation_min = 0");
}

TEST(Alternatives, OfValueZeroExcludeNothing) {
  EXPECT_EQ(resolved("[material]\nliquid_volume = 1e-12\nliquid_fraction = 0\n").material.liquid_volume, 1e-12);
  EXPECT_EQ(resolved("[material]\nliquid_volume = 0\nliquid_fraction = 0.01\n").material.liquid_fraction, 0.01);
  EXPECT_EQ(resolved("[material]\nseparation_min = 0\nseparation_min_ratio = 0.01\n").material.separation_min_ratio, 0.01);
}

TEST(Alternatives, GivenCountMoreThanInherited) {
  const Input volume = resolved("[material]\nliquid_fraction = 0.01\n[second]\nliquid_volume = 1e-12\n[wall]\nyoung = 1e9\n");
  EXPECT_EQ(volume.second.liquid_volume, 1e-12);
  EXPECT_EQ(volume.second.liquid_fraction, 0);
  EXPECT_EQ(volume.wall.material.liquid_fraction, 0.01);
  EXPECT_EQ(resolved("[material]\nliquid_volume = 1e-12\n[second]\nliquid_fraction = 0.01\n").second.liquid_fraction, 0.01);
  const Input ratio = resolved("[material]\nseparation_min = 1e-7\n[second]\nseparation_min_ratio = 0.01\n");
  EXPECT_EQ(ratio.second.separation_min, 0);
  EXPECT_EQ(ratio.second.separation_min_ratio, 0.01);
}

TEST(Alternatives, ThatDoNotCountAreAtTheirDefault) {
  EXPECT_TRUE(resolved("[material]\nliquid_volume = 1e-12\n[second]\nliquid_fraction = 0.01\n").second ==
              resolved("[second]\nliquid_fraction = 0.01\n").second);
}

TEST(Alternatives, BesideANamedMaterialCountMore) {
  const tests::TemporaryFolder folder;
  const tests::EnvironmentVariable data("SCALEBREAK_DATA", folder.path().c_str());
  tests::put_file(folder / "materials/mud.toml", "liquid_fraction = 0.02\nseparation_min = 1e-7\n");
  tests::put_file(folder / "materials/odd.toml", "liquid_fraction = 0.02\nliquid_volume = 1e-12\n");
  const Input input = resolved("[material]\nliquid_volume = 1e-12\nname = \"mud\"\n");
  EXPECT_EQ(input.material.liquid_volume, 1e-12);
  EXPECT_EQ(input.material.liquid_fraction, 0);
  EXPECT_EQ(input.material.separation_min, 1e-7);
  EXPECT_EQ(
      sentence_for("[second]\nname = \"odd\"\n"),
      (folder / "materials/odd.toml").string() +
          ", line 2: second.liquid_fraction and second.liquid_volume exclude each other, found 0.02 and 1e-12; allowed: one of the two, "
          "or second.liquid_fraction = 0");
}

TEST(Alternatives, AreLeftOutOfAWrittenInputWhereTheyDoNotCount) {
  const std::string text = write_input(resolved("[material]\nliquid_fraction = 0.02\nseparation_min = 1e-7\n"));
  EXPECT_EQ(text.find("liquid_volume"), std::string::npos);
  EXPECT_EQ(text.find("separation_min_ratio"), std::string::npos);
  EXPECT_NE(write_input(Input{}).find("liquid_volume = 2.18e-12\nliquid_fraction = 0\n"), std::string::npos);
}

}  // namespace
}  // namespace scalebreak

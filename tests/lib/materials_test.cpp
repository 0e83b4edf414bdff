#include <scalebreak/scene/materials.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>

namespace scalebreak {
namespace {

using testing::StartsWith;
using tests::EnvironmentVariable;
using tests::resolved;
using tests::sentence_for;

/// A data folder of this test's own, with two materials.
struct Materials : testing::Test {
  tests::TemporaryFolder folder;
  EnvironmentVariable data{"SCALEBREAK_DATA", folder.path().c_str()};

  Materials() {
    put("cork", "[material]\nsource = \"a cork board\"\nname = \"cork\"\nyoung = 2e7\npoisson = 0\n");
    put("amber", "young = 3e9\n");
  }
  void put(const std::string& name, const std::string& text) const { tests::put_file(folder / "materials" / (name + ".toml"), text); }
};

TEST_F(Materials, ANamedOneGivesItsKeysAndLeavesTheOthersAtTheirDefaults) {
  const Input input = resolved("[material]\nname = \"cork\"\n");
  EXPECT_EQ(input.material, (Material{.young = 2e7, .poisson = 0}));
  EXPECT_EQ(input.second, input.material);
  EXPECT_EQ(input.wall.material, input.material);
}

TEST_F(Materials, WhatStandsBesideTheNameCountsMoreWhereverItStands) {
  const Material wanted{.young = 5e7, .poisson = 0};
  EXPECT_EQ(resolved("[material]\nname = \"cork\"\nyoung = 5e7\n").material, wanted);
  EXPECT_EQ(resolved("[material]\nyoung = 5e7\nname = \"cork\"\n").material, wanted);
  EXPECT_EQ(resolved("[material]\nyoung = 5e7\n", {"material.name=cork"}).material, wanted);
  EXPECT_EQ(resolved("[material]\nname = \"cork\"\n", {"material.young=5e7"}).material, wanted);
}

TEST_F(Materials, SecondAndWallMayBeNamedOnTheirOwn) {
  const Input input = resolved("[material]\nname = \"cork\"\n[second]\nname = \"amber\"\n[wall]\nname = \"amber\"\npoisson = 0.4\n");
  EXPECT_EQ(input.material, (Material{.young = 2e7, .poisson = 0}));
  EXPECT_EQ(input.second, (Material{.young = 3e9, .poisson = 0})) << "what amber leaves open comes from [material]";
  EXPECT_EQ(input.wall.material, (Material{.young = 3e9, .poisson = 0.4}));
}

TEST_F(Materials, AMissingOneIsRefusedWithThoseThatThereAre) {
  const std::string allowed = fmt::format("; allowed: a material of {}: \"amber\", \"cork\"", (folder / "materials").string());
  EXPECT_EQ(sentence_for("[material]\nname = \"steel\"\n"), "scene.toml, line 2: material.name: found \"steel\"" + allowed);
  EXPECT_EQ(sentence_for("", {"wall.name=../materials/cork"}),
            "--set wall.name=../materials/cork: wall.name: found \"../materials/cork\"" + allowed);
}

TEST_F(Materials, AFolderWithoutAnySaysSo) {
  const tests::TemporaryFolder empty;
  const EnvironmentVariable elsewhere("SCALEBREAK_DATA", empty.path().c_str());
  const std::string allowed = fmt::format("; allowed: a material of {}: none there", (empty / "materials").string());
  EXPECT_EQ(sentence_for("[material]\nname = \"cork\"\n"), "scene.toml, line 2: material.name: found \"cork\"" + allowed);
}

TEST_F(Materials, WhatIsWrongInAMaterialFileIsSaidWithThatFile) {
  put("bad", "[material]\nyoung = 2e7\ndensity = -1\n");
  put("odd", "[material]\nyoung = 2e7\ncolour = 3\n");
  put("broken", "[material]\nyoung = = 2\n");
  const auto place = [&](const char* name, int line) { return fmt::format("{}, line {}: ", (folder / "materials" / name).string(), line); };
  EXPECT_EQ(sentence_for("[second]\nname = \"bad\"\n"),
            place("bad.toml", 3) + "second.density: found -1; allowed: a number of at least 0.01 and at most 1e+06");
  EXPECT_THAT(sentence_for("[material]\nname = \"odd\"\n"), StartsWith(place("odd.toml", 3) + "material.colour: there is no such key"));
  EXPECT_THAT(sentence_for("[material]\nname = \"broken\"\n"), StartsWith(place("broken.toml", 2) + "this is not TOML: "));
}

TEST(DataFolder, IsTheSourceTreesUnlessToldOtherwise) {
  const EnvironmentVariable unset("SCALEBREAK_DATA", nullptr);
  EXPECT_EQ(data_folder(), std::filesystem::path(SCALEBREAK_SOURCE) / "data");
}

TEST(DataFolder, EveryMaterialThereResolvesInEveryRole) {
  const EnvironmentVariable unset("SCALEBREAK_DATA", nullptr);
  int materials = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "materials")) {
    ++materials;
    const std::string name = entry.path().stem().string();
    for (const char* role : {"material", "second", "wall"})
      EXPECT_NO_THROW((void)resolved(fmt::format("[{}]\nname = \"{}\"\n", role, name))) << name;
  }
  EXPECT_GE(materials, 4);
}

TEST(DataFolder, EverySceneThereResolves) {
  const EnvironmentVariable unset("SCALEBREAK_DATA", nullptr);
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "scenes")) {
    ++scenes;
    EXPECT_NO_THROW((void)resolve_input(read_toml_file(entry.path()))) << entry.path();
  }
  EXPECT_GE(scenes, 2);
}

TEST(DataFolder, GlassIsTheDefaultMaterial) {
  const EnvironmentVariable unset("SCALEBREAK_DATA", nullptr);
  EXPECT_TRUE(resolved("[material]\nname = \"glass\"\n") == Input{});
}

}  // namespace
}  // namespace scalebreak

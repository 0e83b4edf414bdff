#include <scalebreak/scene/flow_scene.hpp>

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using tests::resolved;

constexpr const char* shear = "[cell]\nkind = \"shear\"\n";

Flow flow(const std::string& toml, const std::vector<std::string>& settings = {}) { return scaled_flow(resolved(toml, settings)); }

double solids(const Flow& f) {
  double sum = 0;
  for (const double r : f.radius) sum += 4.0 / 3 * std::numbers::pi * r * r * r;
  return sum;
}

TEST(FlowScene, DefaultIsShearedGlass) {
  const Flow f = flow(shear);
  EXPECT_EQ(f.kind, CellKind::shear);
  ASSERT_EQ(f.radius.size(), 2000u);
  EXPECT_EQ(f.radius.front(), 0.5e-3);
  EXPECT_EQ(f.cell.shear_rate, 40);
  EXPECT_NEAR(f.volume_fraction, 0.3, 1e-14);
  EXPECT_NEAR(f.cell.size.x(), std::cbrt(2000 * std::numbers::pi / 6 * 1e-9 / 0.3), 1e-15);
  EXPECT_EQ(f.cell.size, Eigen::Vector3d::Constant(f.cell.size.x()));
  EXPECT_NEAR(f.mass[7] / (2500 * std::numbers::pi / 6 * 1e-9), 1, 1e-14);
}

TEST(FlowScene, TwoOfCountVolumeFractionAndSizeFixTheThird) {
  const Flow by_size = flow(shear, {"particles.count=900", "cell.size=[0.01,0.02,0.03]"});
  EXPECT_EQ(by_size.radius.size(), 900u);
  EXPECT_EQ(by_size.cell.size, Eigen::Vector3d(0.01, 0.02, 0.03));
  EXPECT_NEAR(by_size.volume_fraction, 900 * std::numbers::pi / 6 * 1e-9 / 6e-6, 1e-14);
  const Flow by_fraction = flow(shear, {"particles.volume_fraction=0.2", "cell.size=[0.01,0.02,0.03]"});
  EXPECT_EQ(by_fraction.radius.size(), 2292u);  // 0.2 · 6e-6/(π/6 · 1e-9) = 2291.8
  const Flow cube = flow(shear, {"particles.volume_fraction=0.2", "particles.count=500"});
  EXPECT_NEAR(cube.cell.volume(), 500 * std::numbers::pi / 6 * 1e-9 / 0.2, 1e-18);
  EXPECT_EQ(flow(shear, {"cell.size=[0.01,0.01,0.01]"}).radius.size(), 573u) << "at the default volume fraction";
}

TEST(FlowScene, ADrawnVolumeFractionIsTheOneAskedFor) {
  for (const char* size : {"gaussian", "lognormal"}) {
    const std::vector<std::string> sizes = {std::string("particles.size=") + size, "particles.size_spread=0.2"};
    const Flow cube = flow(shear, sizes);
    EXPECT_NEAR(solids(cube) / cube.cell.volume(), 0.3, 1e-14) << "the cell follows from what was drawn";
    auto with_cell = sizes;
    with_cell.emplace_back("cell.size=[0.02,0.02,0.02]");
    const Flow filled = flow(shear, with_cell);
    EXPECT_NEAR(filled.volume_fraction, 0.3, 1e-3);
    EXPECT_NEAR(filled.volume_fraction, solids(filled) / 8e-6, 1e-14);
  }
}

TEST(FlowScene, ALawThatEnlargesKeepsTheCountOrTheCell) {
  const std::vector<std::string> twice = {"scaling.law=sup", "scaling.factor=2", "particles.size=gaussian", "particles.size_spread=0.1"};
  const Flow original = flow(shear, {twice[2], twice[3]}), count = flow(shear, twice);
  ASSERT_EQ(count.radius.size(), original.radius.size());
  for (std::size_t i = 0; i < count.radius.size(); ++i) ASSERT_EQ(count.radius[i], 2 * original.radius[i]);
  EXPECT_EQ(count.cell.size, 2 * original.cell.size);
  EXPECT_NEAR(count.mass[3] / original.mass[3], 8, 1e-13);
  EXPECT_EQ(count.cell.shear_rate, 40);
  EXPECT_EQ(count.size_factor, 2);
  auto kept = twice;
  kept.emplace_back("scaling.keep=cell");
  const Flow cell = flow(shear, kept);
  EXPECT_EQ(cell.radius.size(), 250u);
  EXPECT_EQ(cell.cell.size, original.cell.size);
  EXPECT_EQ(cell.radius[0], 2 * original.radius[0]);
  EXPECT_NEAR(cell.volume_fraction, 0.3, 0.3 * 4 * 0.3 / std::sqrt(250)) << "250 volumes of a spread of 3 × 0.1";
  kept.emplace_back("cell.size=[0.02,0.02,0.02]");
  EXPECT_NEAR(flow(shear, kept).volume_fraction, 0.3, 3e-3) << "to half a sphere of 570";
}

TEST(FlowScene, WallsKeepTheCellByThemselvesAndPeriodicCellsTheCount) {
  const std::vector<std::string> twice = {"scaling.law=sup", "scaling.factor=2", "particles.count=4000"};
  EXPECT_EQ(flow("[cell]\nkind = \"couette\"\n", twice).radius.size(), 500u);
  EXPECT_EQ(flow("[cell]\nkind = \"box\"\n", twice).radius.size(), 500u);
  EXPECT_EQ(flow("[cell]\nkind = \"cooling\"\n", twice).radius.size(), 4000u);
}

TEST(FlowScene, ALawThatSoftensLeavesTheSceneAlone) {
  const Flow soft = flow(shear, {"scaling.law=rps", "scaling.factor=1e-4"}), original = flow(shear);
  EXPECT_EQ(soft.radius, original.radius);
  EXPECT_EQ(soft.cell, original.cell);
}

TEST(FlowScene, ReplicasAndSeedsDrawOtherSizesAndNothingElseDoes) {
  const std::vector<std::string> sizes = {"particles.size=gaussian", "particles.size_spread=0.1"};
  const Input input = resolved(shear, sizes);
  EXPECT_EQ(scaled_flow(input).radius, scaled_flow(input).radius);
  EXPECT_NE(scaled_flow(input, 1).radius, scaled_flow(input).radius);
  Input seeded = input;
  seeded.run.seed = 2;
  EXPECT_NE(scaled_flow(seeded).radius, scaled_flow(input).radius);
  Input hotter = input;
  hotter.particles.speed = 1, hotter.material.young = 1e8;
  EXPECT_EQ(scaled_flow(hotter).radius, scaled_flow(input).radius);
}

TEST(FlowScene, BidisperseTakeTheSecondDensity) {
  const Flow f = flow(
      "[cell]\nkind = \"cooling\"\n[second]\ndensity = 5000\n[particles]\nsize = \"bidisperse\"\nlarge_radius = 1e-3\n"
      "large_mass_fraction = 0.5\n");
  double mass[2] = {0, 0};
  for (std::size_t i = 0; i < f.radius.size(); ++i) mass[f.material[i]] += f.mass[i];
  EXPECT_NEAR(mass[1] / (mass[0] + mass[1]), 0.5, 2e-3);  // to half a large sphere of 118
  EXPECT_NEAR(f.mass.back() / sphere_mass(1e-3, 5000), 1, 1e-14);
}

TEST(FlowScene, GravitySpeedAndWallsReachTheFlow) {
  const Flow box = flow(
      "[cell]\nkind = \"box\"\nboundary = [\"periodic\", \"open\", \"wall\"]\nwall_speed = 0.1\nwall_no_slip = true\n"
      "gravity = [0, 0, -9.81]\n[particles]\nspeed = 0.2\n[scaling]\nlaw = \"sup\"\nfactor = 3\nkeep = \"count\"\n");
  EXPECT_EQ(box.cell.boundary, (std::array{Boundary::periodic, Boundary::open, Boundary::wall}));
  EXPECT_EQ(box.gravity, Eigen::Vector3d(0, 0, -9.81));
  EXPECT_EQ(box.speed, 0.2);
  EXPECT_EQ(box.cell.wall_speed, 0.1);
  EXPECT_TRUE(box.wall_no_slip);
}

TEST(FlowScene, TimesComeFromStrainOrDuration) {
  const auto times = [](const std::string& toml, const std::vector<std::string>& settings = {}) {
    const Input input = resolved(toml, settings);
    return run_times(input, scaled_flow(input).cell);
  };
  const RunTimes sheared = times(shear);
  EXPECT_NEAR(sheared.duration, 4.0 / 40, 1e-15);
  EXPECT_NEAR(sheared.warmup, 2.0 / 40, 1e-15);
  EXPECT_NEAR(sheared.interval, sheared.duration / 200, 1e-15);
  const RunTimes walls = times("[cell]\nkind = \"couette\"\nwall_speed = 2\nsize = [0.02, 0.01, 0.1]\n", {"particles.count=100"});
  EXPECT_NEAR(walls.duration, 4.0 / 40, 1e-15) << "W: 2 m/s on both sides of 0.1 m";
  const RunTimes given = times(shear, {"run.duration=0.5", "run.warmup_strain=0", "output.interval=0.01"});
  EXPECT_EQ(given.duration, 0.5);
  EXPECT_EQ(given.warmup, 0);
  EXPECT_EQ(given.interval, 0.01);
  EXPECT_EQ(times("[cell]\nkind = \"cooling\"\n").duration, 0.1);
  EXPECT_EQ(times("[cell]\nkind = \"cooling\"\n").warmup, 0);
}

TEST(FlowScene, AParticleFileSaysTheRestAndIsEnlarged) {
  const tests::TemporaryFolder folder;
  tests::put_file(folder / "start.xyz", "0\n");
  const Flow f = flow("[particles]\nfile = \"" + (folder / "start.xyz").string() + "\"\n", {"scaling.law=sup", "scaling.factor=2"});
  EXPECT_EQ(f.file, (folder / "start.xyz").string());
  EXPECT_EQ(f.size_factor, 2);
  EXPECT_TRUE(f.radius.empty());
}

/// JKR's full range stretches to |δ_S| = (27/16)^{1/3} (π²γ²R*/E*²)^{1/3}, a bridge to its rupture.
TEST(FlowScene, ReachIsThatOfTheScaledContacts) {
  const Input jkr = resolved(shear);
  const double young = 10e9 / (1 - 0.0625) / 2, stretch = std::cbrt(27.0 / 16 * std::pow(std::numbers::pi * 0.02 / young, 2) * 0.25e-3);
  EXPECT_NEAR(plan_flow(jkr).reach / stretch, 1, 1e-12);
  EXPECT_NEAR(plan_flow(resolved(shear, {"scaling.law=sup", "scaling.factor=2"})).reach / stretch, 2, 1e-12);
  EXPECT_NEAR(plan_flow(resolved(shear, {"scaling.law=sakai", "scaling.factor=2"})).reach / stretch, 1, 1e-12) << "overlaps are kept";
  EXPECT_NEAR(plan_flow(resolved(shear, {"scaling.law=rps", "scaling.factor=1e-5"})).reach / stretch, 100, 1e-9);
  EXPECT_EQ(plan_flow(resolved(shear, {"contact.normal=hertz"})).reach, 0);
  EXPECT_NEAR(plan_flow(resolved(shear, {"contact.attraction=capillary"})).reach / std::cbrt(2.18e-12), 1, 1e-12);
}

TEST(FlowScene, AnExceptionalSphereThatDoesNotFitIsRefused) {
  const Input input =
      resolved(shear, {"particles.size=lognormal", "particles.size_spread=0.8", "particles.count=20", "cell.size=[0.013,0.013,0.013]"});
  int refused = 0;  // of 20 spheres one is more than three σ above the mean in 2.7 % of the replicas
  std::string sentence;
  for (std::uint64_t replica = 0; replica < 3000; ++replica) {
    try {
      (void)scaled_flow(input, replica);
    } catch (const InputError& error) {
      sentence = error.what(), ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 3000);
  EXPECT_THAT(sentence, HasSubstr("cell.size: the largest sphere that was drawn has a radius of"));
}

}  // namespace
}  // namespace scalebreak

#include <scalebreak/scene/check_flow.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using tests::resolved;
using tests::sentence_for;

constexpr const char* shear = "[cell]\nkind = \"shear\"\n";

std::string cell(const char* kind, const std::string& more = "") { return fmt::format("[cell]\nkind = \"{}\"\n{}", kind, more); }
std::string particles(const std::string& more) { return "[particles]\n" + more; }

TEST(CheckFlow, BeginsWithParticlesOrCell) {
  EXPECT_FALSE(resolved("").flow);
  EXPECT_TRUE(resolved(shear).flow);
  EXPECT_TRUE(resolved(particles("count = 100\n")).flow);
  EXPECT_EQ(resolved(particles("count = 2000\n")), resolved(shear));
}

TEST(CheckFlow, IsNoPairAndNoFewBodies) {
  EXPECT_EQ(sentence_for(std::string(shear) + "[pair]\nradius = [1e-3, 1e-3]\n"),
            "scene.toml, line 4: pair.radius cannot stand beside [particles] or [cell]: a flow is no pair and no few bodies");
  EXPECT_EQ(
      sentence_for(shear, {"impact.normal_speed=1"}),
      "--set impact.normal_speed=1: impact.normal_speed cannot stand beside [particles] or [cell]: a flow is no pair and no few bodies");
  EXPECT_EQ(sentence_for(particles("count = 9\n[[body]]\nradius = 1e-3\n")),
            "scene.toml, line 4: body.1.radius cannot stand beside [particles] or [cell]: a flow is no pair and no few bodies");
}

TEST(CheckFlow, ItsKeysStandInAFlowOnly) {
  EXPECT_EQ(sentence_for("[output]\ninterval = 1\n"),
            "scene.toml, line 2: output.interval cannot stand without [particles] or [cell]: it is a key of flows");
  EXPECT_EQ(sentence_for("[scaling]\nlaw = \"sup\"\nfactor = 2\nkeep = \"cell\"\n"),
            "scene.toml, line 4: scaling.keep cannot stand without [particles] or [cell]: it is a key of flows");
  EXPECT_EQ(sentence_for("[run]\nseed = 3\n"),
            "scene.toml, line 2: run.seed cannot stand without [particles] or [cell]: it is a key of flows");
  const std::string bodies = "[[body]]\nposition = [0, 0, 0]\nradius = 1e-3\n[[body]]\nposition = [0, 0, 2e-3]\nradius = 1e-3\n";
  EXPECT_EQ(sentence_for(bodies, {"run.strain=1"}),
            "--set run.strain=1: run.strain cannot stand without [particles] or [cell]: it is a key of flows");
  EXPECT_EQ(resolved(bodies, {"run.duration=1"}).run.duration, 1);
}

TEST(CheckFlow, OfCountVolumeFractionAndSizeTwoAreGiven) {
  EXPECT_EQ(sentence_for("[particles]\ncount = 100\nvolume_fraction = 0.3\n[cell]\nsize = [0.01, 0.01, 0.01]\n"),
            "scene.toml, line 5: particles.count, particles.volume_fraction and cell.size are all given, and two of them fix the third; "
            "allowed: two of the three");
  EXPECT_EQ(sentence_for(shear, {"cell.size=[0.01,0.01,0.01]", "particles.count=100", "particles.volume_fraction=0.3"}),
            "--set particles.volume_fraction=0.3: particles.count, particles.volume_fraction and cell.size are all given, and two of them "
            "fix the third; allowed: two of the three");
  EXPECT_EQ(sentence_for(cell("shear", "size = [0.01, 0, 0.01]\n")),
            "scene.toml, line 3: cell.size: found [0.01, 0, 0.01]; allowed: three numbers above 0, or [0, 0, 0] for a cube that follows "
            "from count and volume_fraction");
  const Input input = resolved(shear, {"particles.count=100", "particles.volume_fraction=0", "cell.size=[0.01,0.01,0.01]"});
  EXPECT_EQ(input.particles.volume_fraction, 0) << "what is 0 is not given";
}

TEST(CheckFlow, ARandomFillingHasAnEnd) {
  EXPECT_EQ(sentence_for(particles("volume_fraction = 0.61\n")),
            "scene.toml, line 2: particles.volume_fraction: found 0.61; allowed: a number of at least 0 and at most 0.6");
  EXPECT_EQ(sentence_for(particles("count = 1200\n[cell]\nsize = [0.01, 0.01, 0.01]\n")),
            "scene.toml, line 4: particles.count = 1200 in this cell comes to a volume fraction of 0.628319, more than a random filling "
            "reaches; allowed: at most 0.6");
  EXPECT_EQ(resolved(particles("volume_fraction = 0.6\n")).particles.volume_fraction, 0.6);
  EXPECT_EQ(sentence_for(cell("box", "size = [100, 100, 100]\n")),
            "scene.toml, line 3: the flow comes to 5.73e+14 spheres; allowed: 2 to 1e+08");
  EXPECT_EQ(sentence_for(particles("count = 1\n")), "scene.toml, line 2: the flow comes to 1 spheres; allowed: 2 to 1e+08");
}

TEST(CheckFlow, APeriodicCellHoldsTwoDiametersAndTheReach) {
  EXPECT_EQ(sentence_for(cell("shear", "size = [0.01, 0.0019, 0.01]\n"), {"contact.normal=hertz"}),
            "scene.toml, line 3: the cell is 0.0019 m long along y, where it is periodic, which is less than two diameters of the largest "
            "sphere and the reach of a contact; allowed: at least 0.002 m");
  EXPECT_THAT(sentence_for(cell("shear", "size = [0.01, 0.01, 0.002]\n")), HasSubstr("0.002 m long along z, where it is periodic"))
      << "adhesion reaches further";
  EXPECT_EQ(sentence_for(cell("shear", "size = [0.01, 0.01, 0.002]\n"), {"contact.normal=hertz"}), "(it was accepted)");
  EXPECT_EQ(sentence_for(cell("couette", "size = [0.01, 0.01, 0.00099]\n")),
            "scene.toml, line 3: the cell is 0.00099 m long along z, between its walls, which is less than the diameter of the largest "
            "sphere; allowed: at least 0.001 m");
  EXPECT_THAT(sentence_for(cell("shear", "size = [0.01, 0.01, 0.01]\n[scaling]\nlaw = \"sup\"\nfactor = 6\nkeep = \"cell\"\n")),
              HasSubstr("the cell is 0.01 m long along x"))
      << "the scaled spheres count";
  EXPECT_EQ(sentence_for(cell("shear", "size = [0.01, 0.01, 0.01]\n[scaling]\nlaw = \"sup\"\nfactor = 6\n")), "(it was accepted)");
}

TEST(CheckFlow, SizesGoWithTheirDistribution) {
  EXPECT_EQ(sentence_for(particles("size_spread = 0.1\n")),
            "scene.toml, line 2: particles.size_spread = 0.1 needs a distribution, and particles.size = \"mono\"; allowed: 0, or size = "
            "\"gaussian\" or \"lognormal\"");
  EXPECT_EQ(sentence_for(particles("large_radius = 1e-3\nsize = \"gaussian\"\nsize_spread = 0.1\n")),
            "scene.toml, line 2: particles.large_radius = 0.001 needs two sizes, and particles.size = \"gaussian\"; allowed: 0, or size = "
            "\"bidisperse\"");
  EXPECT_EQ(sentence_for(particles("large_mass_fraction = 0.5\n")),
            "scene.toml, line 2: particles.large_mass_fraction = 0.5 needs two sizes, and particles.size = \"mono\"; allowed: 0, or size = "
            "\"bidisperse\"");
  EXPECT_EQ(sentence_for(particles("size = \"lognormal\"\n")),
            "scene.toml, line 2: particles.size = \"lognormal\" needs a size_spread, found 0; allowed: above 0, or size = \"mono\"");
  EXPECT_EQ(sentence_for(particles("size = \"gaussian\"\nsize_spread = 0.31\n")),
            "scene.toml, line 3: particles.size_spread = 0.31 is too wide for size = \"gaussian\", which would have radii near 0 or below; "
            "allowed: at most 0.3, or size = \"lognormal\"");
  EXPECT_EQ(sentence_for(particles("radius = nan\n")),
            "scene.toml, line 2: particles.radius: found nan; allowed: a number of at least 1e-09 and at most 100");
  EXPECT_EQ(sentence_for(particles("size_spread = nan\n")),
            "scene.toml, line 2: particles.size_spread: found nan; allowed: a number of at least 0 and at most 2");
  EXPECT_EQ(sentence_for(particles("count = 10.5\n")),
            "scene.toml, line 2: particles.count: found 10.5; allowed: a whole number of at least 0 and at most 1e+08");
}

TEST(CheckFlow, TwoSizesNeedBothKeys) {
  const std::string two = "size = \"bidisperse\"\n";
  EXPECT_EQ(sentence_for(particles(two + "large_radius = 1e-3\n")),
            "particles.large_mass_fraction is missing; particles.size = \"bidisperse\" needs large_radius and large_mass_fraction");
  EXPECT_EQ(sentence_for(particles(two + "large_mass_fraction = 0.5\n")),
            "particles.large_radius is missing; particles.size = \"bidisperse\" needs large_radius and large_mass_fraction");
  EXPECT_EQ(sentence_for(particles(two + "large_radius = 4e-4\nlarge_mass_fraction = 0.5\n")),
            "scene.toml, line 3: particles.large_radius: found 0.0004 beside particles.radius = 0.0005; allowed: a larger one");
  EXPECT_EQ(resolved(particles(two + "large_radius = 1e-3\nlarge_mass_fraction = 0.5\n[second]\nyoung = 1e9\n")).second.young, 1e9);
  EXPECT_EQ(sentence_for(std::string(shear) + "[second]\nyoung = 1e9\n"),
            "scene.toml, line 4: second.young cannot stand beside particles.size = \"mono\": [second] is the material of the large spheres "
            "of size = \"bidisperse\"");
}

TEST(CheckFlow, AParticleFileIsThereAndSaysTheRest) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder / "start.xyz").string();
  EXPECT_EQ(sentence_for(particles("file = \"" + path + "\"\n")),
            "scene.toml, line 2: particles.file: found \"" + path + "\", which is no file; allowed: a particle file");
  tests::put_file(folder / "start.xyz", "0\n");
  const std::string file = particles("file = \"" + path + "\"\n");
  EXPECT_EQ(resolved(file).particles.count, 0u);
  EXPECT_EQ(resolved(file).particles.volume_fraction, 0);
  for (const char* setting : {"particles.volume_fraction=0.3", "particles.size=gaussian", "particles.count=9", "cell.size=[1,1,1]"}) {
    const std::string key = std::string(setting).substr(0, std::string(setting).find('='));
    EXPECT_EQ(sentence_for(file, {setting}), fmt::format("--set {}: {} cannot stand beside particles.file: the file says how many spheres "
                                                         "there are, of what sizes, how they move and in what cell",
                                                         setting, key));
  }
  EXPECT_EQ(sentence_for(file, {"scaling.law=sup", "scaling.factor=2", "scaling.keep=cell"}),
            "--set scaling.keep=cell: scaling.keep = \"cell\" cannot stand beside particles.file: larger spheres of a file do not fit "
            "where they are; allowed: \"count\"");
  EXPECT_EQ(resolved(file, {"cell.kind=box", "scaling.law=sup", "scaling.factor=2"}).keep, Keep::count);
  EXPECT_EQ(sentence_for(particles("file = \"" + folder.path().string() + "\"\n")),
            "scene.toml, line 2: particles.file: found \"" + folder.path().string() + "\", which is no file; allowed: a particle file");
}

TEST(CheckFlow, KeepNeedsALawThatEnlarges) {
  const std::string keep = std::string(shear) + "[scaling]\nkeep = \"count\"\n";
  EXPECT_EQ(sentence_for(keep, {"scaling.law=rps", "scaling.factor=0.01"}),
            "scene.toml, line 4: scaling.keep = \"count\" needs a law that enlarges the spheres, and scaling.law = \"rps\" with "
            "scaling.factor = 0.01 makes them softer; allowed: no scaling.keep");
  EXPECT_THAT(sentence_for(keep, {"scaling.factor=0.01"}),
              HasSubstr("scaling.law = \"none\" with scaling.factor = 0.01 makes them softer"));
  EXPECT_EQ(resolved(keep, {"scaling.factor=2"}).keep, Keep::count);
}

TEST(CheckFlow, LiquidIsLookedAtBetweenItsSpheres) {
  EXPECT_THAT(sentence_for(std::string(shear) + "[material]\nsurface_energy = 0\n[contact]\nrolling = \"ar\"\n"),
              HasSubstr("the surface_energy between two spheres is 0"));
  EXPECT_THAT(sentence_for(particles("radius = 1e-4\n[contact]\nattraction = \"capillary\"\n")),
              HasSubstr("between two spheres ruptures at 0.000129664 m"));
  EXPECT_THAT(sentence_for(particles("size = \"bidisperse\"\nlarge_radius = 1e-3\nlarge_mass_fraction = 0.5\n[contact]\nattraction = "
                                     "\"viscous\"\n[second]\nliquid_volume = 0\n")),
              HasSubstr("its volume between two large spheres is 0"));
}

}  // namespace
}  // namespace scalebreak

#include <scalebreak/scene/check_cell.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <lib/resolving.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using tests::resolved;
using tests::sentence_for;

std::string cell(const char* kind, const std::string& more = "") { return fmt::format("[cell]\nkind = \"{}\"\n{}", kind, more); }

TEST(CheckCell, BoundariesDriveAndRunFollowFromTheKind) {
  using enum Boundary;
  const Input shear = resolved(cell("shear")), couette = resolved(cell("couette")), cooling = resolved(cell("cooling")),
              box = resolved(cell("box"));
  EXPECT_EQ(shear.cell.boundary, (std::array{periodic, periodic, periodic}));
  EXPECT_EQ(couette.cell.boundary, (std::array{periodic, periodic, wall}));
  EXPECT_EQ(cooling.cell.boundary, (std::array{periodic, periodic, periodic}));
  EXPECT_EQ(box.cell.boundary, (std::array{wall, wall, wall}));
  EXPECT_EQ(resolved(cell("box", "boundary = [\"open\", \"wall\", \"periodic\"]\n")).cell.boundary, (std::array{open, wall, periodic}));
  EXPECT_EQ(shear.cell.shear_rate, 40);
  EXPECT_EQ(couette.cell.shear_rate, 0);
  EXPECT_EQ(couette.cell.wall_speed, 0.3);
  EXPECT_EQ(shear.run.strain, 4);
  EXPECT_EQ(shear.run.warmup_strain, 2);
  EXPECT_EQ(couette.run.strain, 4);
  EXPECT_EQ(cooling.run.duration, 0.1);
  EXPECT_EQ(cooling.run.strain, 0);
  EXPECT_EQ(box.run.warmup_strain, 0);
}

TEST(CheckCell, ConfinedShearHasAPressureAndARate) {
  const Input input = resolved(cell("confined_shear", "pressure = 100\nshear_rate = 5\n"));
  EXPECT_EQ(input.cell.pressure, 100);
  EXPECT_EQ(input.cell.shear_rate, 5);
  EXPECT_EQ(input.run.strain, 4);
  EXPECT_EQ(sentence_for(cell("confined_shear", "shear_rate = 5\n")),
            "cell.pressure is missing; cell.kind = \"confined_shear\" needs pressure and shear_rate");
  EXPECT_EQ(sentence_for(cell("confined_shear", "pressure = 100\n")),
            "cell.shear_rate is missing; cell.kind = \"confined_shear\" needs pressure and shear_rate");
  EXPECT_EQ(sentence_for(cell("confined_shear", "pressure = 0\nshear_rate = 5\n")),
            "scene.toml, line 3: cell.pressure: found 0 beside cell.kind = \"confined_shear\"; allowed: above 0, or kind = \"shear\"");
  EXPECT_EQ(sentence_for(cell("confined_shear", "pressure = 100\nshear_rate = 0\n")),
            "scene.toml, line 4: cell.shear_rate: found 0 beside cell.kind = \"confined_shear\"; allowed: above 0");
  EXPECT_EQ(sentence_for(cell("confined_shear", "pressure = -1\nshear_rate = 5\n")),
            "scene.toml, line 3: cell.pressure: found -1; allowed: a number of at least 0 and at most 1e+12");
  EXPECT_EQ(sentence_for(cell("confined_shear", "pressure = 100\nshear_rate = 5\nboundary = [\"periodic\", \"periodic\", \"wall\"]\n")),
            "scene.toml, line 5: cell.boundary: found [\"periodic\", \"periodic\", \"wall\"] beside cell.kind = \"confined_shear\"; "
            "allowed: [\"periodic\", \"periodic\", \"periodic\"]");
  EXPECT_THAT(sentence_for(cell("confined_shear", "pressure = 100\nshear_rate = 5\ngravity = [0, 0, -9.81]\n")),
              HasSubstr("found -9.81 m/s2 along z, which is periodic"));
  EXPECT_THAT(sentence_for(cell("confined_shear", "pressure = 100\nshear_rate = 5\n[particles]\ncount = 8\nvolume_fraction = 0.1\n")),
              HasSubstr("once the pressure has brought it to a volume fraction of 0.64, which is less than two diameters"));
  EXPECT_EQ(sentence_for(cell("shear", "pressure = 100\n")),
            "scene.toml, line 3: cell.pressure = 100 needs cell.kind = \"confined_shear\", found \"shear\"; allowed: 0");
}

TEST(CheckCell, ShearAcrossImagesHasPeriodicFacesAllAround) {
  const std::string allowed = "; allowed: [\"periodic\", \"periodic\", \"periodic\"]";
  EXPECT_EQ(sentence_for(cell("shear", "boundary = [\"periodic\", \"periodic\", \"wall\"]\n")),
            "scene.toml, line 3: cell.boundary: found [\"periodic\", \"periodic\", \"wall\"] beside cell.kind = \"shear\"" + allowed);
  EXPECT_EQ(sentence_for(cell("shear", "boundary = [\"periodic\", \"open\", \"periodic\"]\n")),
            "scene.toml, line 3: cell.boundary: found [\"periodic\", \"open\", \"periodic\"] beside cell.kind = \"shear\"" + allowed);
  EXPECT_THAT(sentence_for(cell("cooling", "boundary = [\"wall\", \"periodic\", \"periodic\"]\n")), HasSubstr(allowed));
  EXPECT_EQ(sentence_for(cell("couette", "boundary = [\"periodic\", \"periodic\", \"periodic\"]\n")),
            "scene.toml, line 3: cell.boundary: found [\"periodic\", \"periodic\", \"periodic\"] beside cell.kind = \"couette\"; allowed: "
            "[\"periodic\", \"periodic\", \"wall\"] or [\"periodic\", \"wall\", \"wall\"]");
  EXPECT_EQ(
      sentence_for(cell("box", "boundary = [\"periodic\", \"wall\"]\n")),
      "scene.toml, line 3: cell.boundary: found [\"periodic\", \"wall\"]; allowed: an array of 3 of \"open\", \"periodic\", \"wall\"");
  EXPECT_THAT(sentence_for(cell("box", "boundary = [\"periodic\", \"wall\", \"glass\"]\n")),
              HasSubstr("found [\"periodic\", \"wall\", \"glass\"]"));
}

TEST(CheckCell, WhatDrivesAFlowSuitsIt) {
  EXPECT_EQ(
      sentence_for(cell("couette", "shear_rate = 40\n")),
      "scene.toml, line 3: cell.shear_rate = 40 needs cell.kind = \"shear\" or \"confined_shear\", found \"couette\"; allowed: 0, the walls move at "
      "cell.wall_speed");
  EXPECT_EQ(sentence_for(cell("cooling", "shear_rate = 40\n")),
            "scene.toml, line 3: cell.shear_rate = 40 needs cell.kind = \"shear\" or \"confined_shear\", found \"cooling\"; allowed: 0");
  EXPECT_EQ(sentence_for(cell("shear", "shear_rate = 0\n")),
            "scene.toml, line 3: cell.shear_rate: found 0 beside cell.kind = \"shear\"; allowed: above 0, or kind = \"cooling\"");
  EXPECT_EQ(sentence_for(cell("shear", "wall_speed = 2\n")),
            "scene.toml, line 3: cell.wall_speed = 2 needs walls along z in a cell that is periodic along x, found [\"periodic\", "
            "\"periodic\", \"periodic\"]; allowed: 0");
  EXPECT_EQ(sentence_for(cell("cooling", "wall_no_slip = true\n")),
            "scene.toml, line 3: cell.wall_no_slip = true needs walls, found [\"periodic\", \"periodic\", \"periodic\"]; allowed: false");
  EXPECT_EQ(sentence_for(cell("cooling", "[particles]\nspeed = 0\n")),
            "scene.toml, line 4: particles.speed: found 0 beside cell.kind = \"cooling\", where nothing would move; allowed: above 0");
  EXPECT_EQ(resolved(cell("couette", "wall_no_slip = true\nwall_speed = 2\n")).cell.wall_speed, 2);
}

TEST(CheckCell, GravityEndsAtSomething) {
  EXPECT_EQ(sentence_for(cell("shear", "gravity = [0, 0, -9.81]\n")),
            "scene.toml, line 3: cell.gravity: found -9.81 m/s2 along z, which is periodic, so that everything would fall for ever; "
            "allowed: 0 there, or a wall");
  EXPECT_THAT(sentence_for(cell("couette", "gravity = [1, 0, -9.81]\n")), HasSubstr("found 1 m/s2 along x, which is periodic"));
  EXPECT_EQ(resolved(cell("couette", "gravity = [0, 0, -9.81]\n")).cell.gravity.z(), -9.81);
}

TEST(CheckRun, EndsByItsDurationOrItsStrain) {
  const std::string shear = cell("shear");
  EXPECT_EQ(sentence_for(shear + "[run]\nduration = 1\nstrain = 2\n"),
            "scene.toml, line 5: run.duration and run.strain exclude each other, found 1 and 2; allowed: one of the two");
  EXPECT_EQ(sentence_for(shear + "[run]\nwarmup_duration = 1\nwarmup_strain = 2\n"),
            "scene.toml, line 5: run.warmup_duration and run.warmup_strain exclude each other, found 1 and 2; allowed: one of the two");
  EXPECT_EQ(sentence_for(shear + "[run]\nstrain = 0\n"),
            "scene.toml, line 4: run.duration and run.strain are both 0, and a flow does not end by itself; allowed: one of them above 0");
  EXPECT_EQ(sentence_for(cell("cooling", "[run]\nstrain = 2\n")),
            "scene.toml, line 4: run.strain = 2 needs a flow that is sheared; allowed: run.duration");
  EXPECT_EQ(sentence_for(cell("couette", "wall_speed = 0\n[run]\nwarmup_strain = 2\n")),
            "scene.toml, line 5: run.warmup_strain = 2 needs a flow that is sheared; allowed: run.warmup_duration");
  const Input timed = resolved(shear + "[run]\nduration = 1\nwarmup_duration = 0\n");
  EXPECT_EQ(timed.run.strain, 0);
  EXPECT_EQ(timed.run.warmup_strain, 0) << "none was asked for";
}

TEST(CheckRun, StepsSeedsAndReplicasHaveBounds) {
  const std::string shear = cell("shear");
  EXPECT_EQ(sentence_for(shear + "[run]\nstep_fraction = 0\n"),
            "scene.toml, line 4: run.step_fraction: found 0; allowed: a number above 0 and at most 1");
  EXPECT_EQ(sentence_for(shear + "[run]\nstep_fraction = 1.01\n"),
            "scene.toml, line 4: run.step_fraction: found 1.01; allowed: a number above 0 and at most 1");
  EXPECT_EQ(sentence_for(shear + "[run]\nseed = -1\n"),
            "scene.toml, line 4: run.seed: found -1; allowed: a whole number of at least 0 and at most 9007199254740991");
  EXPECT_EQ(sentence_for(shear + "[run]\nreplicas = 0\n"),
            "scene.toml, line 4: run.replicas: found 0; allowed: a whole number of at least 1 and at most 1000");
  EXPECT_EQ(sentence_for(shear + "[run]\nintegrator = \"leapfrog\"\n"),
            "scene.toml, line 4: run.integrator: found \"leapfrog\"; allowed: \"verlet\", \"synchronized\"");
}

TEST(CheckOutput, KnowsItsFormatsAndFields) {
  const std::string shear = cell("shear");
  EXPECT_EQ(sentence_for(shear + "[output]\nformats = [\"csv\", \"hdf5\"]\n"),
            "scene.toml, line 4: output.formats: found [\"csv\", \"hdf5\"]; allowed: an array of \"csv\", \"vtp\", \"xyz\", \"dump\"");
  EXPECT_EQ(
      sentence_for(shear + "[output]\nfields = [\"colour\"]\n"),
      "scene.toml, line 4: output.fields: found [\"colour\"]; allowed: an array of \"radius\", \"material\", \"velocity\", \"spin\", \"mass\"");
  EXPECT_TRUE(resolved(shear + "[output]\nformats = []\n").output.formats.empty());
  EXPECT_THAT(resolved(shear + "[output]\nformats = [\"dump\", \"csv\"]\n").output.formats,
              testing::ElementsAre(ParticleFormat::dump, ParticleFormat::csv));
}

}  // namespace
}  // namespace scalebreak

#include <scalebreak/scene/input_file.hpp>

#include <gmock/gmock.h>

#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>
#include <scalebreak/scene/keys.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using tests::resolved;
using tests::sentence_for;

constexpr const char* laws =
    "\"none\", \"rps\", \"sup\", \"overlap_kept\", \"force_cubed\", \"torque_cubed\", \"sakai\", \"chen_elliott\", \"bond\", \"cohesion\", "
    "\"thakur\"";

TEST(InputMessage, UnknownKeyWithASuggestion) {
  EXPECT_EQ(
      sentence_for("[material]\nyuong = 1e9\n"),
      "scene.toml, line 2: material.yuong: there is no such key (did you mean material.young?); allowed: material.young, "
      "material.poisson, material.density, material.restitution, material.sliding_friction, material.surface_energy, "
      "material.spring_constant, material.spring_constant_tangential, material.rolling_friction, material.rolling_damping, "
      "material.rolling_angle_max, material.rolling_spring_constant, material.rolling_dashpot, material.surface_tension, material.contact_angle, material.viscosity, material.liquid_volume, "
      "material.liquid_fraction, material.separation_min, material.separation_min_ratio, material.name");
  EXPECT_THAT(sentence_for("[second]\nsurface_tenson = 1\n"), HasSubstr("(did you mean second.surface_tension?)"));
  EXPECT_THAT(sentence_for("[contact]\nroling = \"cdt\"\n"), HasSubstr("(did you mean contact.rolling?)"));
  EXPECT_EQ(sentence_for("[run]\nduraton = 1\n"),
            "scene.toml, line 2: run.duraton: there is no such key (did you mean run.duration?); allowed: run.duration, run.strain, "
            "run.warmup_duration, run.warmup_strain, run.seed, run.step_fraction, run.step_bounds, run.replicas, run.integrator");
  EXPECT_EQ(sentence_for("", {"pair.radii=[1e-3,1e-3]"}),
            "--set pair.radii=[1e-3,1e-3]: pair.radii: there is no such key (did you mean pair.radius?); allowed: pair.radius, "
            "pair.partner");
  EXPECT_EQ(sentence_for("[[body]]\nposition = [0, 0, 0]\nradios = 3\n"),
            "scene.toml, line 3: body.1.radios: there is no such key (did you mean body.radius?); allowed: body.position, body.velocity, "
            "body.spin, body.radius, body.fixed, body.material");
}

TEST(InputMessage, UnknownKeyUnlikeAnyGetsNoSuggestion) {
  EXPECT_EQ(sentence_for("[impact]\nxyzxyzxyzxyz = 1\n"),
            "scene.toml, line 2: impact.xyzxyzxyzxyz: there is no such key; allowed: impact.normal_speed, impact.tangential_speed, "
            "impact.spin1, impact.spin2");
  EXPECT_EQ(sentence_for("[pair]\nxyz = 1\n"), "scene.toml, line 2: pair.xyz: there is no such key; allowed: pair.radius, pair.partner");
}

TEST(InputMessage, UnknownSection) {
  EXPECT_EQ(sentence_for("\n\n[materials]\nyoung = 1e9\n"),
            "scene.toml, line 4: materials.young: there is no such section; allowed: material, second, wall, contact, pair, impact, "
            "particles, cell, scaling, run, output, study, advise, numerics, body");
  EXPECT_EQ(sentence_for("young = 1e9\n"),
            "scene.toml, line 1: young: there is no such section; allowed: material, second, wall, contact, pair, impact, particles, cell, "
            "scaling, run, output, study, advise, numerics, body");
}

TEST(InputMessage, UnknownKeysBelowAKeyOrABody) {
  EXPECT_THAT(sentence_for("[material.young]\nvalue = 1e9\n"), HasSubstr("scene.toml, line 2: material.young.value: there is no such key"));
  const std::string deeper = sentence_for("[[body]]\nplace.position = [0, 0, 1]\n");
  EXPECT_THAT(deeper, HasSubstr("scene.toml, line 2: body.1.place.position: there is no such key"));
  EXPECT_THAT(sentence_for("[body]\n01.radius = 1e-3\n"), HasSubstr("scene.toml, line 2: body.01.radius: there is no such key"));
  EXPECT_THAT(sentence_for("", {"body.0.radius=1e-3"}), HasSubstr("--set body.0.radius=1e-3: body.0.radius: there is no such key"));
  EXPECT_THAT(sentence_for("", {"body.1=3"}), HasSubstr("--set body.1=3: body.1: there is no such key"));
}

TEST(InputMessage, WrongType) {
  EXPECT_EQ(sentence_for("[material]\nyoung = \"stiff\"\n"),
            "scene.toml, line 2: material.young: found \"stiff\"; allowed: a number of at least 100 and at most 1e+14");
  EXPECT_EQ(sentence_for("[pair]\nradius = 1e-3\n"),
            "scene.toml, line 2: pair.radius: found 0.001; allowed: an array of 1 to 2 numbers of at least 1e-09 and at most 100");
  EXPECT_EQ(sentence_for("[wall]\nrigid = 1\n"), "scene.toml, line 2: wall.rigid: found 1; allowed: true or false");
  EXPECT_EQ(sentence_for("[material]\nname = 3\n"),
            "scene.toml, line 2: material.name: found 3; allowed: the name of a material, as a string");
  EXPECT_EQ(sentence_for("", {"study.laws=rps"}),
            std::string("--set study.laws=rps: study.laws: found \"rps\"; allowed: an array of ") + laws);
}

TEST(InputMessage, NegativeAndZero) {
  EXPECT_EQ(sentence_for("[material]\ndensity = -2500\n"),
            "scene.toml, line 2: material.density: found -2500; allowed: a number of at least 0.01 and at most 1e+06");
  EXPECT_EQ(sentence_for("[second]\nsurface_energy = -0.02\n"),
            "scene.toml, line 2: second.surface_energy: found -0.02; allowed: a number of at least 0 and at most 1000");
  EXPECT_EQ(sentence_for("[pair]\nradius = [0, 1e-3]\n"),
            "scene.toml, line 2: pair.radius: found [0, 0.001]; allowed: an array of 1 to 2 numbers of at least 1e-09 and at most 100");
  EXPECT_EQ(sentence_for("[impact]\nnormal_speed = 0\n"),
            "scene.toml, line 2: impact.normal_speed: found 0; allowed: a number of at least 1e-09 and at most 10000");
  EXPECT_EQ(sentence_for("[scaling]\nfactor = 0\n"),
            "scene.toml, line 2: scaling.factor: found 0; allowed: a number of at least 1e-08 and at most 1000");
}

TEST(InputMessage, NotFinite) {
  EXPECT_EQ(sentence_for("[material]\nyoung = nan\n"),
            "scene.toml, line 2: material.young: found nan; allowed: a number of at least 100 and at most 1e+14");
  EXPECT_EQ(sentence_for("[impact]\nnormal_speed = inf\n"),
            "scene.toml, line 2: impact.normal_speed: found inf; allowed: a number of at least 1e-09 and at most 10000");
  EXPECT_EQ(sentence_for("", {"impact.normal_speed=-inf"}),
            "--set impact.normal_speed=-inf: impact.normal_speed: found -inf; allowed: a number of at least 1e-09 and at most 10000");
  EXPECT_EQ(sentence_for("[study]\nspeeds = [1, nan]\n"),
            "scene.toml, line 2: study.speeds: found [1, nan]; allowed: an array of 0 to 1000 numbers of at least 1e-09 and at most 10000");
}

TEST(InputMessage, WhatIsPrintedAsAllowedIsAllowed) {
  const std::string angle = "a number of at least 0 and at most 1.5707963267948966";
  EXPECT_EQ(sentence_for("[material]\ncontact_angle = 1.5708\n"),
            "scene.toml, line 2: material.contact_angle: found 1.5708; allowed: " + angle);
  EXPECT_EQ(resolved("[material]\ncontact_angle = 1.5707963267948966\n").material.contact_angle, std::acos(0.0));
  EXPECT_EQ(sentence_for("[wall]\nseparation_min_ratio = 0\n"),
            "scene.toml, line 2: wall.separation_min_ratio: found 0; allowed: a number of at least 1e-09 and at most 1");
  EXPECT_EQ(sentence_for("[material]\nliquid_fraction = 0.2\n"),
            "scene.toml, line 2: material.liquid_fraction: found 0.2; allowed: a number of at least 0 and at most 0.1");
  EXPECT_EQ(sentence_for("[impact]\nspin1 = [0, 0]\n"),
            "scene.toml, line 2: impact.spin1: found [0, 0]; allowed: an array of 3 numbers of at least -1e+09 and at most 1e+09");
}

TEST(InputMessage, RestitutionBeyondItsEnds) {
  EXPECT_EQ(sentence_for("[material]\nrestitution = 0\n"),
            "scene.toml, line 2: material.restitution: found 0; allowed: a number above 0 and at most 1");
  EXPECT_EQ(sentence_for("[wall]\nrestitution = 1.1\n"),
            "scene.toml, line 2: wall.restitution: found 1.1; allowed: a number above 0 and at most 1");
  EXPECT_EQ(resolved("[material]\nrestitution = 1\n").material.restitution, 1);
}

TEST(InputMessage, WrongWord) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"dmt\"\n"),
            "scene.toml, line 2: contact.normal: found \"dmt\"; allowed: \"linear\", \"hertz\", \"jkr\"");
  EXPECT_EQ(sentence_for("", {"contact.adhesion_range=far"}),
            "--set contact.adhesion_range=far: contact.adhesion_range: found \"far\"; allowed: \"full\", \"pull_off\", \"touch\"");
  EXPECT_EQ(sentence_for("[contact]\ntangential = \"coulomb\"\n"),
            "scene.toml, line 2: contact.tangential: found \"coulomb\"; allowed: \"none\", \"linear\", \"mindlin\"");
  EXPECT_EQ(sentence_for("[contact]\nrolling = \"sdd\"\n"),
            "scene.toml, line 2: contact.rolling: found \"sdd\"; allowed: \"none\", \"cdt\", \"epsd\", \"epsd2\", \"ar\", \"sds\"");
  EXPECT_EQ(sentence_for("[contact]\nattraction = \"viscous+capillary\"\n"),
            "scene.toml, line 2: contact.attraction: found \"viscous+capillary\"; allowed: \"none\", \"capillary\", \"viscous\", "
            "\"capillary+viscous\"");
  EXPECT_EQ(sentence_for("[[body]]\nmaterial = \"wall\"\n"),
            "scene.toml, line 2: body.1.material: found \"wall\"; allowed: \"material\", \"second\"");
  EXPECT_EQ(sentence_for("[scaling]\nlaw = \"RPS\"\n"), std::string("scene.toml, line 2: scaling.law: found \"RPS\"; allowed: ") + laws);
  EXPECT_EQ(sentence_for("[study]\nlaws = [\"rps\", \"spr\"]\n"),
            std::string("scene.toml, line 2: study.laws: found [\"rps\", \"spr\"]; allowed: an array of ") + laws);
}

TEST(InputMessage, WrongNumberOfBodiesOrCoordinates) {
  std::string many;
  for (int i = 0; i < 51; ++i) many += "[[body]]\nradius = 1\n";
  EXPECT_EQ(sentence_for(many), "scene.toml, line 102: body.51.radius: found 51 bodies; allowed: 2 to 50 [[body]] tables, or none");
  EXPECT_EQ(sentence_for("[[body]]\nradius = 1\n"),
            "scene.toml, line 2: body.1.radius: found 1 body; allowed: 2 to 50 [[body]] tables, or none");
  EXPECT_EQ(sentence_for("[[body]]\nradius = 1\nposition = [1, 2]\n[[body]]\nradius = 1\n"),
            "scene.toml, line 3: body.1.position: found [1, 2]; allowed: an array of 3 numbers of at least -1000 and at most 1000");
}

TEST(InputMessage, AWrongValueIsReportedBeforeAMissingOne) {
  const std::string body = "[[body]]\nposition = [0, 0, 1]\n";  // no radius, no second body
  EXPECT_EQ(sentence_for(body + "[impact]\nnormal_speed = -1\n"),
            "scene.toml, line 4: impact.normal_speed: found -1; allowed: a number of at least 1e-09 and at most 10000");
  EXPECT_EQ(sentence_for(body + "[material]\nname = \"glass\"\nyoung = nan\n"),
            "scene.toml, line 5: material.young: found nan; allowed: a number of at least 100 and at most 1e+14");
  EXPECT_EQ(sentence_for(body + "[[body]]\nradius = 1\n"), "body.1.radius is missing; every [[body]] needs position and radius");
}

TEST(InputMessage, AWrongValueIsReportedBeforeAnImpossibleCombination) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"hertz\"\nadhesion_range = \"full\"\n[numerics]\ntolerance = 1\n"),
            "scene.toml, line 5: numerics.tolerance: found 1; allowed: a number of at least 1e-13 and at most 1e-06");
}

TEST(InputMessage, AMissingValueIsReportedBeforeAnImpossibleCombination) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"hertz\"\nadhesion_range = \"full\"\n[[body]]\nradius = 1\n[[body]]\nradius = 1\n"),
            "body.1.position is missing; every [[body]] needs position and radius");
}

TEST(InputMessage, TheFirstOfTwoWrongValuesIsReported) {
  EXPECT_THAT(sentence_for("[impact]\nnormal_speed = -1\n[material]\nyoung = -1\n"), HasSubstr("line 2: impact.normal_speed"));
  EXPECT_THAT(sentence_for("[material]\nyoung = -1\n[impact]\nnormal_speed = -1\n"), HasSubstr("line 2: material.young"));
}

}  // namespace
}  // namespace scalebreak

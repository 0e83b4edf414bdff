#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <scalebreak/contact/damping.hpp>
#include <scalebreak/scaling/scaled_pair.hpp>

namespace scalebreak {
namespace {

Material material(double young, double energy) {
  Material m;
  m.young = young, m.surface_energy = energy;
  return m;
}

TEST(Pair, OfEqualSpheresIsHalfOfOne) {
  const NormalPair pair = sphere_pair({}, 1e-3, {}, 1e-3);
  EXPECT_DOUBLE_EQ(pair.radius, 0.5e-3);
  EXPECT_DOUBLE_EQ(pair.mass, 2500 * 4.0 / 3 * std::numbers::pi * 1e-9 / 2);
  EXPECT_DOUBLE_EQ(pair.young, 10e9 / (2 * (1 - 0.0625)));
  EXPECT_DOUBLE_EQ(pair.surface_energy, 0.02);
  EXPECT_DOUBLE_EQ(pair.damping_ratio, damping_ratio(0.81));
}

TEST(Pair, OfUnlikeSpheresAddsInversesAndMeansTheSurfaceEnergies) {
  const NormalPair pair = sphere_pair(material(1e9, 0.01), 1e-3, material(3e9, 0.05), 3e-3);
  EXPECT_DOUBLE_EQ(1 / pair.radius, 1 / 1e-3 + 1 / 3e-3);
  EXPECT_DOUBLE_EQ(1 / pair.young, 0.9375 / 1e9 + 0.9375 / 3e9);
  EXPECT_DOUBLE_EQ(pair.surface_energy, 0.03);
}

TEST(Pair, WithAWallHasItsMassAndRadiusAloneAndTheWallsRestitution) {
  Wall wall;
  wall.material.restitution = 0.5;
  const NormalPair pair = wall_pair({}, 1e-3, wall);
  EXPECT_DOUBLE_EQ(pair.radius, 1e-3);
  EXPECT_DOUBLE_EQ(pair.mass, sphere_mass(1e-3, 2500));
  EXPECT_DOUBLE_EQ(pair.damping_ratio, damping_ratio(0.5));
  wall.rigid = true, wall.attraction = false;
  EXPECT_DOUBLE_EQ(wall_pair({}, 1e-3, wall).young, 10e9 / 0.9375);
  EXPECT_EQ(wall_pair({}, 1e-3, wall).surface_energy, 0);
}

/// What a law does to E, k, γ, r, and in the map to overlap and force, at factor 4 or 1/4.
struct Row {
  const char* law;
  double factor, young, spring, energy, size;
  bool direct;
  double overlap, force;
};

class ScalingTable : public testing::TestWithParam<Row> {};

TEST_P(ScalingTable, HasTheRowOfThePapers) {
  const Row& row = GetParam();
  const ScalingLaw* law = find_scaling_law(row.law);
  ASSERT_NE(law, nullptr);
  const Material original, scaled = scaled_material(*law, row.factor, original, NormalModel::hertz);
  EXPECT_NEAR(scaled.young / original.young, row.young, 1e-14 * row.young);
  EXPECT_NEAR(scaled.spring_constant / original.spring_constant, row.spring, 1e-14 * row.spring);
  EXPECT_NEAR(scaled.surface_energy / original.surface_energy, row.energy, 1e-14 * row.energy);
  EXPECT_EQ(scaled.density, original.density);
  EXPECT_EQ(scaled.restitution, original.restitution);
  EXPECT_EQ(size_factor(*law, row.factor), row.size);
  EXPECT_EQ(law->direct_force, row.direct);
  const ScaledPair pair = scaled_pair(*law, row.factor, {{}, {}, {}, {1e-3, 1e-3}}, NormalModel::hertz);
  EXPECT_DOUBLE_EQ(pair.overlap, row.overlap);
  EXPECT_DOUBLE_EQ(pair.force, row.force);
}

INSTANTIATE_TEST_SUITE_P(Rows, ScalingTable,
                         testing::Values(Row{"none", 0.25, 0.25, 0.25, 1, 1, false, 1, 1}, Row{"none", 4, 1, 1, 1, 4, false, 1, 1},
                                         Row{"rps", 0.25, 0.25, 0.25, std::pow(0.25, 0.4), 1, false, 1, 1},
                                         Row{"sup", 4, 1, 1, 1, 4, true, 4, 16}, Row{"overlap_kept", 4, 1, 1, 1, 4, true, 1, 16},
                                         Row{"force_cubed", 4, 1, 1, 1, 4, true, 4, 64}, Row{"torque_cubed", 4, 1, 1, 1, 4, true, 4, 16},
                                         Row{"sakai", 4, 1, 1, 1, 4, true, 1, 64}, Row{"chen_elliott", 4, 32, 1, 16, 4, false, 1, 1},
                                         Row{"bond", 4, 1, 1, 16, 4, false, 1, 1},
                                         Row{"cohesion", 4, 1, 1, std::pow(4, 1.6), 4, false, 1, 1},
                                         Row{"thakur", 4, 1, 4, 4, 4, false, 1, 1}),
                         [](const auto& test) { return std::string(test.param.law) + (test.param.factor < 1 ? "_softer" : "_larger"); });

TEST(ScalingLaws, AreAllTested) { EXPECT_EQ(scaling_laws().size(), 11u); }

TEST(ScalingLaws, KeepTheNumbersTheyAreNamedAfter) {
  const Bodies original{{}, {}, {}, {1e-3, 1e-3}};
  const auto bond = [](const Bodies& b) {
    return 3 * std::numbers::pi * b.pair().surface_energy * b.pair().radius / sphere_mass(b.radius[0], b.first.density);
  };
  EXPECT_NEAR(bond(scaled_bodies(*find_scaling_law("bond"), 8, original, NormalModel::jkr)) / bond(original), 1, 1e-13);
  const auto cohesion = [](const Bodies& b) {
    return std::cbrt(std::pow(2 * b.pair().surface_energy, 5) / (std::pow(b.pair().young, 2) * std::pow(b.pair().radius, 8)));
  };
  EXPECT_NEAR(cohesion(scaled_bodies(*find_scaling_law("cohesion"), 8, original, NormalModel::jkr)) / cohesion(original), 1, 1e-12);
}

TEST(ScalingLaws, ScaleTheWallToo) {
  Bodies bodies{{}, {}, {}, {1e-3}};
  bodies.wall.material.young = 3e9;
  const Bodies scaled = scaled_bodies(*find_scaling_law("rps"), 0.01, bodies, NormalModel::jkr);
  EXPECT_DOUBLE_EQ(scaled.wall.material.young, 3e7);
  EXPECT_NEAR(scaled.pair().young / bodies.pair().young, 0.01, 1e-15);
}

/// A liquid said as a share of the spheres and the same said in metres are one liquid, under every law that enlarges the particles.
TEST(ScalingLaws, EnlargeALiquidGivenInMetresAsOneGivenInShares) {
  for (const std::size_t spheres : {2, 1}) {
    Bodies shares{{}, {}, {}, {1e-3, 0.6e-3}};
    shares.radius.resize(spheres);
    for (Material* material : {&shares.first, &shares.second, &shares.wall.material})
      material->liquid_fraction = 0.02, material->separation_min_ratio = 3e-4;
    Bodies metres = shares;
    const SurfacePair original = shares.surfaces();
    for (Material* material : {&metres.first, &metres.second, &metres.wall.material}) {
      material->liquid_fraction = 0, material->liquid_volume = original.bridge_volume;
      material->separation_min_ratio = 0, material->separation_min = original.separation_min;
    }
    for (const char* name : {"none", "chen_elliott", "bond", "cohesion", "thakur"}) {
      const ScalingLaw& law = *find_scaling_law(name);
      const SurfacePair a = scaled_bodies(law, 4, shares, NormalModel::jkr).surfaces();
      const SurfacePair b = scaled_bodies(law, 4, metres, NormalModel::jkr).surfaces();
      EXPECT_NEAR(a.bridge_volume / original.bridge_volume, 64, 1e-12) << name;
      EXPECT_NEAR(b.bridge_volume / a.bridge_volume, 1, 1e-14) << name;
      EXPECT_NEAR(a.separation_min / original.separation_min, 4, 1e-13) << name;
      EXPECT_NEAR(b.separation_min / a.separation_min, 1, 1e-14) << name;
    }
    for (const auto& [name, factor] : {std::pair{"none", 0.01}, {"rps", 0.01}}) {
      const SurfacePair softened = scaled_bodies(*find_scaling_law(name), factor, metres, NormalModel::jkr).surfaces();
      EXPECT_EQ(softened.bridge_volume, original.bridge_volume) << name;
      EXPECT_EQ(softened.separation_min, original.separation_min) << name;
    }
  }
}

}  // namespace
}  // namespace scalebreak

#include <gtest/gtest.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>

// Chung & Ooi, "Benchmark tests for verifying discrete element modelling codes at particle impact level",
// Granular Matter 13 (2011) 643: the normal impacts, tests 1 to 3, at 1e-6.

namespace scalebreak {
namespace {

Material material(double young, double poisson, double density, double restitution) {
  return {.young = young, .poisson = poisson, .density = density, .restitution = restitution, .surface_energy = 0};
}

PairCollision collide(const Bodies& bodies, double speed) {
  return ScaledContact(canonical({.normal = NormalModel::hertz}), bodies, *find_scaling_law("none"), 1).collide(speed, 1e-10, true);
}

TEST(ChungOoi, Test1TwoEqualSpheres) {
  const Material limestone = material(20e9, 0.25, 2500, 1);
  const PairCollision c = collide({limestone, limestone, {}, {10e-3, 10e-3}}, 20);
  EXPECT_NEAR(c.max_overlap, 368.3040e-6, 1e-6 * 368.3040e-6);
  EXPECT_NEAR(c.max_force, 7108.2413, 1e-6 * 7108.2413);
  EXPECT_NEAR(*c.contact_time, 54.2010e-6, 1e-6 * 54.2010e-6);
}

TEST(ChungOoi, Test2SphereOnARigidPlane) {
  const Material alloy = material(40e9, 0.35, 1800, 1);
  Wall wall{alloy, true, true};
  const PairCollision c = collide({alloy, alloy, wall, {0.1}}, 0.2);
  EXPECT_NEAR(c.max_overlap, 52.12329e-6, 1e-6 * 52.12329e-6);
  EXPECT_NEAR(c.max_force, 7232.6810, 1e-6 * 7232.6810);
  EXPECT_NEAR(*c.contact_time, 767.0659e-6, 1e-6 * 767.0659e-6);
}

TEST(ChungOoi, Test3RestitutionOutIsRestitutionIn) {
  for (const auto& [young, poisson, density] : {std::tuple{380e9, 0.23, 4000.0}, {100e9, 0.25, 7000.0}}) {
    for (int percent = 5; percent <= 100; percent += 5) {
      const Material m = material(young, poisson, density, percent / 100.0);
      EXPECT_NEAR(collide({m, m, {m, false, true}, {2.5e-3}}, 3.9).restitution, percent / 100.0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace scalebreak

#include <gtest/gtest.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <verification/chung_ooi_scenes.hpp>

// Chung & Ooi, "Benchmark tests for verifying discrete element modelling codes at particle impact level",
// Granular Matter 13 (2011) 643: the normal impacts, tests 1 to 3, at 1e-6.

namespace scalebreak {
namespace {

using namespace tests;

PairCollision collide(const Input& input) { return contact_of(input).collide(input.normal_speed, 1e-10, true); }

TEST(ChungOoi, Test1TwoEqualSpheres) {
  const PairCollision c = collide(chung_ooi_1());
  EXPECT_NEAR(c.max_overlap, 368.3040e-6, 1e-6 * 368.3040e-6);
  EXPECT_NEAR(c.max_force, 7108.2413, 1e-6 * 7108.2413);
  EXPECT_NEAR(*c.contact_time, 54.2010e-6, 1e-6 * 54.2010e-6);
}

TEST(ChungOoi, Test2SphereOnARigidPlane) {
  const PairCollision c = collide(chung_ooi_2());
  EXPECT_NEAR(c.max_overlap, 52.12329e-6, 1e-6 * 52.12329e-6);
  EXPECT_NEAR(c.max_force, 7232.6810, 1e-6 * 7232.6810);
  EXPECT_NEAR(*c.contact_time, 767.0659e-6, 1e-6 * 767.0659e-6);
}

TEST(ChungOoi, Test3RestitutionOutIsRestitutionIn) {
  for (const bool iron : {false, true}) {
    for (int percent = 5; percent <= 100; percent += 5)
      EXPECT_NEAR(collide(chung_ooi_3(percent / 100.0, iron)).restitution, percent / 100.0, 1e-6);
  }
}

}  // namespace
}  // namespace scalebreak

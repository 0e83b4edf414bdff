#include <scalebreak/measure/sums/sphere_slab.hpp>

#include <numbers>

#include <gtest/gtest.h>

#include <lib/measure/states.hpp>

namespace scalebreak {
namespace {

using std::numbers::pi;

TEST(SphereSlab, HasTheVolumesOfWholeHalfAndCap) {
  EXPECT_DOUBLE_EQ(sphere_between_planes(2, -5, 5), 4 * pi / 3 * 8);
  EXPECT_DOUBLE_EQ(sphere_between_planes(2, 0, 2), 2 * pi / 3 * 8);
  EXPECT_DOUBLE_EQ(sphere_between_planes(2, 1.5, 9), pi * 0.25 * (6 - 0.5) / 3);  // πh²(3r − h)/3
  EXPECT_EQ(sphere_between_planes(2, 2.5, 3), 0);
  EXPECT_EQ(sphere_between_planes(2, -3, -2), 0);
}

TEST(SphereSlab, TheProfileHoldsASphereWhereItsVolumeIs) {
  // Radius 0.3 across the periodic faces: in four slabs of 0.25, a cap of 0.05 is left for each of the middle two.
  System system;
  system.cell = periodic_cell(1, 1, 1);
  add_sphere(system, {0.5, 0.5, 1}, 0.3);
  const auto fraction = profile_of(held(system, {}, 4), "volume_fraction");
  const double cap = pi * 0.0025 * (0.9 - 0.05) / 3, half = 2 * pi / 3 * 0.027;
  EXPECT_NEAR(fraction[1].value, 4 * cap, 1e-14);
  EXPECT_NEAR(fraction[2].value, 4 * cap, 1e-14);
  EXPECT_NEAR(fraction[0].value, 4 * (half - cap), 1e-14);
  EXPECT_NEAR(fraction[3].value, 4 * (half - cap), 1e-14);
}

TEST(SphereSlab, TheProfileAddsUpToTheVolumeFraction) {
  const FlowResult result = held(ideal_gas(periodic_cell(0.2, 0.3, 0.4), 200, 1, 5), {}, 7);
  double mean = 0;
  for (const Measured& slab : profile_of(result, "volume_fraction")) mean += slab.value / 7;
  EXPECT_NEAR(mean, 200 * 4 * pi / 3 * 1e-6 / 0.024, 1e-14);
  EXPECT_NEAR(found(result, "volume_fraction").value, mean, 1e-14);
}

}  // namespace
}  // namespace scalebreak

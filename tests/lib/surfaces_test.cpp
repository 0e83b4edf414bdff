#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <scalebreak/scaling/scaled_pair.hpp>

// What the surfaces of a pair are, and what a scaling law makes of them.

namespace scalebreak {
namespace {

constexpr double pi = std::numbers::pi;

Material first() {
  Material m{.young = 2e9, .poisson = 0.2, .density = 1500, .sliding_friction = 0.4, .surface_energy = 0.01};
  m.spring_constant_tangential = 1e4, m.rolling_friction = 0.1, m.rolling_damping = 0.2, m.rolling_angle_max = 0.01;
  m.rolling_spring_constant = 1e3, m.rolling_dashpot = 0.02;
  m.surface_tension = 0.03, m.contact_angle = 0.2, m.viscosity = 0.001, m.liquid_volume = 1e-13;
  return m;
}
Material second() {
  Material m{.young = 7e9, .poisson = 0.4, .density = 4000, .sliding_friction = 0.9, .surface_energy = 0.05};
  m.spring_constant_tangential = 3e4, m.rolling_friction = 0.4, m.rolling_damping = 0.8, m.rolling_angle_max = 0.04;
  m.rolling_spring_constant = 9e3, m.rolling_dashpot = 0.08;
  m.surface_tension = 0.07, m.contact_angle = 0.6, m.viscosity = 0.005, m.liquid_volume = 3e-13;
  return m;
}

double rolling_inertia(const Material& m, double r) {  // I + m r²
  const double mass = 4.0 / 3 * pi * r * r * r * m.density;
  return 0.4 * mass * r * r + mass * r * r;
}

TEST(Surfaces, OfUnlikeSpheresTakeTheMeansThatTheyAreSaidTo) {
  const double r1 = 1e-3, r2 = 3e-3;
  const SurfacePair pair = sphere_surfaces(first(), r1, second(), r2);
  EXPECT_NEAR(pair.shear * (2 * (2 - 0.2) * (1 + 0.2) / 2e9 + 2 * (2 - 0.4) * (1 + 0.4) / 7e9), 1, 1e-14);  // W eq. 14
  EXPECT_NEAR(pair.spring_constant_tangential, 2 / (1 / 1e4 + 1 / 3e4), 1e-9);
  EXPECT_NEAR(pair.sliding_friction, 0.6, 1e-14);
  EXPECT_NEAR(pair.rolling_friction, 0.2, 1e-14);
  EXPECT_NEAR(pair.rolling_damping, 0.4, 1e-14);
  EXPECT_NEAR(pair.rolling_angle_max, 0.02, 1e-15);
  EXPECT_NEAR(pair.rolling_spring_constant, 3e3, 1e-9);
  EXPECT_NEAR(pair.rolling_dashpot, 0.04, 1e-15);
  EXPECT_NEAR(pair.surface_energy, 0.03, 1e-15);
  EXPECT_NEAR(pair.rolling_inertia * (1 / rolling_inertia(first(), r1) + 1 / rolling_inertia(second(), r2)), 1, 1e-14);  // W eq. 47
  EXPECT_NEAR(pair.surface_tension, 0.05, 1e-15);
  EXPECT_NEAR(pair.contact_angle, 0.4, 1e-15);
  EXPECT_NEAR(pair.viscosity, 0.003, 1e-16);
  EXPECT_NEAR(pair.bridge_volume, 2e-13, 1e-26);
  EXPECT_NEAR(pair.separation_min, 0.0005 * r1, 1e-18);
  const SurfacePair swapped = sphere_surfaces(second(), r2, first(), r1);
  EXPECT_EQ(swapped.shear, pair.shear);
  EXPECT_EQ(swapped.rolling_inertia, pair.rolling_inertia);
  EXPECT_EQ(swapped.separation_min, pair.separation_min);
}

/// A twelfth of both spheres' liquid (Hu 2024, eq. 4.2, which rounds it to 8.3 %).
TEST(Surfaces, ShareTheLiquidOfBothSpheres) {
  Material wet = first(), other = second();
  wet.liquid_fraction = other.liquid_fraction = 0.05;
  const double r1 = 1e-3, r2 = 3e-3, solids = 4.0 / 3 * pi * (r1 * r1 * r1 + r2 * r2 * r2);
  const double bridge = sphere_surfaces(wet, r1, other, r2).bridge_volume;
  EXPECT_NEAR(bridge / (0.05 / 12 * solids), 1, 1e-14);
  EXPECT_NEAR(bridge / (0.05 * 0.083 * solids), 1, 0.005);
  other.liquid_fraction = 0;
  EXPECT_NEAR(sphere_surfaces(wet, r1, other, r2).bridge_volume / (0.05 / 12 * 4.0 / 3 * pi * r1 * r1 * r1), 1, 1e-14)
      << "one wet sphere is enough";
}

TEST(Surfaces, TakeTheLeastSeparationOfTheTwo) {
  Material a = first(), b = second();
  a.separation_min = 3e-7;
  EXPECT_NEAR(sphere_surfaces(a, 1e-3, b, 3e-3).separation_min, 3e-7, 1e-20);
  EXPECT_NEAR(sphere_surfaces(a, 1e-3, b, 0.1e-3).separation_min, 0.5e-7, 1e-20);
}

TEST(Surfaces, AgainstAWallHaveTheCoefficientsGivenForIt) {
  const double r = 1e-3;
  Wall wall{second()};
  const SurfacePair pair = wall_surfaces(first(), r, wall);
  EXPECT_NEAR(pair.shear * (2 * (2 - 0.2) * (1 + 0.2) / 2e9 + 2 * (2 - 0.4) * (1 + 0.4) / 7e9), 1, 1e-14);
  EXPECT_EQ(pair.sliding_friction, 0.9);
  EXPECT_EQ(pair.rolling_friction, 0.4);
  EXPECT_EQ(pair.rolling_damping, 0.8);
  EXPECT_EQ(pair.rolling_angle_max, 0.04);
  EXPECT_EQ(pair.rolling_spring_constant, 9e3);
  EXPECT_EQ(pair.rolling_dashpot, 0.08);
  EXPECT_NEAR(pair.rolling_inertia / rolling_inertia(first(), r), 1, 1e-14);
  EXPECT_NEAR(pair.surface_tension, 0.05, 1e-15);
  EXPECT_NEAR(pair.separation_min, 0.0005 * r, 1e-18);
  wall.rigid = true;
  EXPECT_NEAR(wall_surfaces(first(), r, wall).shear * 2 * (2 - 0.2) * (1 + 0.2) / 2e9, 1, 1e-14);
}

TEST(Surfaces, AgainstAWallWithoutAttractionAreDryAndDoNotStick) {
  Wall wall{second()};
  wall.attraction = false;
  const SurfacePair pair = wall_surfaces(first(), 1e-3, wall);
  EXPECT_EQ(pair.surface_energy, 0);
  EXPECT_EQ(pair.surface_tension, 0);
  EXPECT_EQ(pair.viscosity, 0);
}

/// One row: what a law does to the rolling angle, the liquid beside either normal contact, the torque of adhesive rolling once
/// the material is scaled, in the map to torques, and to the rolling spring of `sds` beside a non-linear contact.
struct Row {
  const char* law;
  double factor, spring_tangential, angle, liquid, liquid_linear, adhesive_rolling, torque, rolling_spring = spring_tangential;
};

class SurfaceScaling : public testing::TestWithParam<Row> {};

TEST_P(SurfaceScaling, HasTheRowOfThePapers) {
  const Row& row = GetParam();
  const ScalingLaw* law = find_scaling_law(row.law);
  ASSERT_NE(law, nullptr);
  const Material original;
  for (const NormalModel normal : {NormalModel::linear, NormalModel::hertz, NormalModel::jkr}) {
    const Material scaled = scaled_material(*law, row.factor, original, normal);
    const double liquid = normal == NormalModel::linear ? row.liquid_linear : row.liquid;
    EXPECT_NEAR(scaled.surface_tension / original.surface_tension / liquid, 1, 1e-14);
    EXPECT_NEAR(scaled.viscosity / original.viscosity / liquid, 1, 1e-14);
    EXPECT_NEAR(scaled.rolling_angle_max / original.rolling_angle_max / row.angle, 1, 1e-14);
    EXPECT_NEAR(scaled.rolling_dashpot / original.rolling_dashpot / liquid, 1, 1e-14);
    const double spring = normal == NormalModel::linear ? row.spring_tangential : row.rolling_spring;
    EXPECT_NEAR(scaled.rolling_spring_constant / original.rolling_spring_constant / spring, 1, 1e-14);
    EXPECT_NEAR(scaled.spring_constant_tangential / original.spring_constant_tangential / row.spring_tangential, 1, 1e-14);
    EXPECT_EQ(scaled.rolling_friction, original.rolling_friction);
    EXPECT_EQ(scaled.rolling_damping, original.rolling_damping);
    EXPECT_EQ(scaled.sliding_friction, original.sliding_friction);
    EXPECT_EQ(scaled.contact_angle, original.contact_angle);
  }
  EXPECT_NEAR(std::pow(row.factor, law->adhesive_rolling) / row.adhesive_rolling, 1, 1e-14);
  EXPECT_NEAR(std::pow(row.factor, law->torque) / row.torque, 1, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, SurfaceScaling,
    testing::Values(Row{"none", 0.25, 0.25, 1, 1, 1, 1, 1}, Row{"none", 4, 1, 1, 1, 1, 1, 1},
                    Row{"rps", 0.25, 0.25, std::pow(4, 0.4), std::pow(0.25, 0.4), 0.5, std::pow(0.25, 0.4), 1, std::pow(0.25, 0.8)},
                    Row{"sup", 4, 1, 1, 1, 1, 1, 16}, Row{"overlap_kept", 4, 1, 1, 1, 1, 1, 16}, Row{"force_cubed", 4, 1, 1, 1, 1, 1, 64},
                    Row{"torque_cubed", 4, 1, 1, 1, 1, 1, 64}, Row{"sakai", 4, 1, 1, 1, 1, 1, 256},
                    Row{"chen_elliott", 4, 1, 1, 1, 1, 1, 1}, Row{"bond", 4, 1, 1, 1, 1, 1, 1}, Row{"cohesion", 4, 1, 1, 1, 1, 1, 1},
                    Row{"thakur", 4, 4, 1, 1, 1, 1, 1}),
    [](const auto& test) { return std::string(test.param.law) + (test.param.factor < 1 ? "_softer" : "_larger"); });

/// W Table 4: with E Ω, γ Ω^{2/5} and θ_max Ω^{−2/5} alone the limit of adhesive rolling would not change at a given a/a_0; it
/// has to fall as the other torques do.
TEST(SurfaceScaling, MultipliesTheTorqueOfAdhesiveRollingOnceMore) {
  const double factor = 1e-3, share = std::pow(factor, 0.4);
  const ScalingLaw& rps = *find_scaling_law("rps");
  const Material original, scaled = scaled_material(rps, factor, original, NormalModel::jkr);
  const auto limit = [](const Material& m) { return m.surface_energy * m.rolling_angle_max; };  // of M_sl = 4 F_po r* (a/a_0)^{3/2} θ_max
  EXPECT_NEAR(limit(scaled) / limit(original), 1, 1e-14);
  EXPECT_NEAR(std::pow(factor, rps.adhesive_rolling) * limit(scaled) / limit(original) / share, 1, 1e-14);
}

}  // namespace
}  // namespace scalebreak

#include <numbers>

#include <gtest/gtest.h>

#include <lib/measure/states.hpp>

namespace scalebreak {
namespace {

constexpr std::int32_t lower_wall = -1 - 2 * 2, upper_wall = -2 - 2 * 2;

TEST(Stress, OfTwoPressedSpheresIsForceTimesBranchOverVolume) {
  System system;
  system.cell = periodic_cell(1, 2, 3);
  add_sphere(system, {0.2, 0.2, 0.2});
  add_sphere(system, {0.23, 0.2, 0.24});
  // 5 N along the branch of 0.05, and a friction of 1 N across it.
  const Eigen::Vector3d n(0.6, 0, 0.8), t(0.8, 0, -0.6);
  const FlowResult result = held(system, {{.first = 0, .second = 1, .branch = 0.05 * n, .force = -5 * n + t}});
  const Eigen::Matrix3d expected = (5 * n - t) * 0.05 * n.transpose() / 6;
  EXPECT_NEAR((result.stress.value - expected).norm(), 0, 1e-15);
  EXPECT_NEAR((result.stress_contact.value - expected).norm(), 0, 1e-15);
  EXPECT_NEAR(found(result, "pressure").value, 5 * 0.05 / 6 / 3, 1e-15);
  EXPECT_GT(result.stress.value(2, 2), 0);
}

TEST(Stress, OfABridgeThatPullsIsNegativeAndIsNoContact) {
  System system;
  system.cell = periodic_cell(1, 1, 1);
  add_sphere(system, {0.2, 0.2, 0.2});
  add_sphere(system, {0.2, 0.2, 0.23});
  const FlowResult result = held(system, {{.first = 0, .second = 1, .touching = false, .branch = {0, 0, 0.03}, .force = {0, 0, 2}}});
  EXPECT_NEAR(result.stress.value(2, 2), -0.06, 1e-15);
  EXPECT_EQ(found(result, "coordination").value, 0);
}

TEST(Stress, OfAGasIsDensityTimesTemperature) {
  const System system = ideal_gas(periodic_cell(1, 1, 2), 20000, 0.04, 4);
  const FlowResult result = held(system);
  const double expected = 20000.0 / 2 * 2 * 0.04;  // n m T
  EXPECT_NEAR(found(result, "pressure").value, expected, 4 * expected * std::sqrt(2.0 / 60000));
  EXPECT_NEAR(found(result, "pressure").value, 20000 * found(result, "temperature").value, 1e-9);
  EXPECT_NEAR(result.stress.value(0, 2), 0, 4 * expected / std::sqrt(20000.0));
  EXPECT_EQ(result.stress_contact.value.norm(), 0);
}

TEST(Stress, OfShearIsTheFluxOfMomentum) {
  // A velocity that is −½ of the rise beside the mean flow: Σ m v'_x v_z = −½ Σ m v_z².
  Cell cell = periodic_cell(1, 1, 1);
  cell.shear_rate = 10;
  System system = ideal_gas(cell, 300, 0.04, 5);
  double flux = 0;
  for (std::size_t i = 0; i < system.count(); ++i) {
    Eigen::Vector3d& v = system.velocity[i];
    v.x() = -0.5 * v.z() + mean_flow(cell, system.position[i].z()).x();
    flux -= 0.5 * 2 * v.z() * v.z();
  }
  const FlowResult result = held(system);
  EXPECT_NEAR(result.stress.value(0, 2), flux, 1e-10);
  EXPECT_NEAR(result.stress.value(2, 0), flux, 1e-10);
  // Held as it is, all work is lost.
  EXPECT_NEAR(found(result, "dissipation").value, -10 * flux, 1e-9);
}

TEST(Stress, AColumnBetweenWallsCarriesTheSameInEverySlab) {
  // Five spheres in a row along z under 7 N, the walls at their surfaces.
  System system;
  system.cell = walled_cell(0.5, 0.4, 0.1);
  std::vector<ContactForce> contacts = {{.first = 0, .second = lower_wall, .branch = {0, 0, -0.01}, .force = {0, 0, 7}}};
  for (int i = 0; i < 5; ++i) {
    add_sphere(system, {0.2, 0.2, 0.01 + 0.02 * i});
    if (i < 4) contacts.push_back({.first = i, .second = i + 1, .branch = {0, 0, 0.02}, .force = {0, 0, -7}});
  }
  contacts.push_back({.first = 4, .second = upper_wall, .branch = {0, 0, 0.01}, .force = {0, 0, -7}});
  const FlowResult result = held(system, contacts, 7);
  EXPECT_NEAR(result.stress.value(2, 2), 7 / 0.2, 1e-12);
  for (const Measured& slab : profile_of(result, "stress_zz")) EXPECT_NEAR(slab.value, 7 / 0.2, 1e-11);
  EXPECT_DOUBLE_EQ(found(result, "coordination").value, 2);
}

TEST(Stress, ABranchAcrossThePeriodicFacesLiesInBothEndSlabs) {
  System system;
  system.cell = periodic_cell(1, 1, 1);
  add_sphere(system, {0.5, 0.5, 0.99});
  add_sphere(system, {0.5, 0.5, 0.02});
  add_sphere(system, {0.9, 0.5, 0.5});
  add_sphere(system, {0.92, 0.5, 0.5});
  const FlowResult result = held(system,
                                 {{.first = 0, .second = 1, .branch = {0, 0, 0.03}, .force = {1, 0, -3}},
                                  {.first = 2, .second = 3, .branch = {0.02, 0, 0}, .force = {-3, 0, 0}}},
                                 10);
  EXPECT_NEAR(profile_of(result, "stress_zz")[9].value, 0.3, 1e-13);
  EXPECT_NEAR(profile_of(result, "stress_zz")[0].value, 0.6, 1e-13);
  EXPECT_NEAR(profile_of(result, "stress_xz")[9].value, -0.1, 1e-13);
  EXPECT_EQ(profile_of(result, "stress_zx")[9].value, 0);
  EXPECT_NEAR(profile_of(result, "stress_xx")[5].value, 0.6, 1e-13);  // level: in the slab where it lies
}

}  // namespace
}  // namespace scalebreak

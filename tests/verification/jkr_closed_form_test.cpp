#include <cmath>

#include <gtest/gtest.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/contact/reduced.hpp>

// Undamped JKR collisions against the energy balance: Chen & Elliott, eqs 11-13 and the sticking speed of section 4.

namespace scalebreak {
namespace {

const ScalingLaw& none() { return *find_scaling_law("none"); }

Material elastic(double young, double poisson, double density, double energy) {
  Material m;
  m.young = young, m.poisson = poisson, m.density = density, m.surface_energy = energy, m.restitution = 1;
  return m;
}

struct Case {
  const char* name;
  Bodies bodies;
};

class UndampedJkr : public testing::TestWithParam<Case> {};

double peeling_work(const NormalPair& pair, AdhesionRange range) {
  const double full = 22.5163187 * std::cbrt(std::pow(pair.surface_energy, 5) * std::pow(pair.radius, 4) / (pair.young * pair.young));
  // The share up to the force minimum, in closed form: ∫ from touch, where â³ = 4/9, to pull-off, where â³ = 1/4.
  const auto share = [](double cube) {
    return 1.6 * std::pow(cube, 5.0 / 3) - 8.0 / 3 * std::pow(cube, 7.0 / 6) + 2.0 / 3 * std::pow(cube, 2.0 / 3);
  };
  const double ratio = (share(0.25) - share(4.0 / 9)) / (share(1.0 / 36) - share(4.0 / 9));
  return range == AdhesionRange::full ? full : range == AdhesionRange::pull_off ? ratio * full : 0.0;
}

TEST_P(UndampedJkr, LosesThePeelingWorkAtEverySpeed) {
  const NormalPair pair = GetParam().bodies.pair();
  for (const auto range : {AdhesionRange::full, AdhesionRange::pull_off, AdhesionRange::touch}) {
    const ScaledContact contact({NormalModel::jkr, range, DampingOn::contact_radius}, GetParam().bodies, none(), 1);
    const double stick = std::sqrt(2 * peeling_work(pair, range) / pair.mass);
    EXPECT_NEAR(contact.sticking_speed(1e-10).value(), stick, 1e-8 * stick);
    const double unit = std::sqrt(2 * peeling_work(pair, AdhesionRange::full) / pair.mass);
    for (const double ratio : {1.01, 1.5, 4.0, 30.0, 1000.0}) {
      const double speed = ratio * unit;
      EXPECT_NEAR(contact.collide(speed, 1e-10).restitution, std::sqrt(1 - std::pow(stick / speed, 2)), 1e-8) << ratio;
    }
    if (stick > 0) {
      EXPECT_TRUE(contact.collide(0.999 * stick, 1e-10).stuck);
    }
  }
}

TEST_P(UndampedJkr, PullOffSticksAt7028OfTheFullRange) {
  const auto stick = [&](AdhesionRange range) {
    return *ScaledContact({NormalModel::jkr, range, DampingOn::contact_radius}, GetParam().bodies, none(), 1).sticking_speed(1e-10);
  };
  EXPECT_NEAR(stick(AdhesionRange::pull_off) / stick(AdhesionRange::full), 0.7028, 5e-5);
}

const Material w_glass = elastic(10e9, 0.25, 2500, 0.02);
Wall quartz() {
  Wall wall;
  wall.material = elastic(98e9, 0.3, 2200, 0.021);
  return wall;
}

INSTANTIATE_TEST_SUITE_P(Pairs, UndampedJkr,
                         testing::Values(Case{"glass_pair", {w_glass, w_glass, {}, {0.5e-3, 0.5e-3}}},
                                         Case{"unequal", {w_glass, w_glass, {}, {0.5e-3, 1e-3}}},
                                         Case{"soft_pair_of_chen_elliott_case_a",
                                              {elastic(1e6, 0.3, 1000, 0.5), elastic(1e6, 0.3, 1000, 0.5), {}, {0.25e-3, 0.5e-3}}},
                                         Case{"latex_on_quartz", {elastic(140e6, 0.3, 1050, 0.021), {}, quartz(), {0.635e-6}}}),
                         [](const auto& test) { return test.param.name; });

TEST(JkrStickingSpeed, OfASphereOnAWallIsTheClosedForm) {
  const Bodies bodies{elastic(140e6, 0.3, 1050, 0.021), {}, quartz(), {0.635e-6}};
  const NormalPair pair = bodies.pair();
  const double expected = 1.8401832 * std::pow(std::pow(2 * 0.021 / 0.635e-6, 5) / (std::pow(1050, 3) * pair.young * pair.young), 1.0 / 6);
  const ScaledContact contact({}, bodies, none(), 1);
  EXPECT_NEAR(*contact.sticking_speed(1e-10) / expected, 1, 2.8e-8);  // half a unit of the constant's last digit
}

/// With vanishing surface energy the JKR contact becomes Hertz's: the loss and the shift of t_c fall with γ.
TEST(JkrWithLittleSurfaceEnergy, MeetsHertz) {
  double last_restitution = 1, last_time = 1;
  for (const double energy : {1e-4, 1e-8, 1e-12, 1e-16}) {
    Material m = elastic(10e9, 0.25, 2500, energy);
    m.restitution = 0.8;
    const Bodies bodies{m, m, {}, {0.5e-3, 0.5e-3}};
    const PairCollision jkr = ScaledContact({}, bodies, none(), 1).collide(0.3, 1e-11);
    const PairCollision hertz = ScaledContact(canonical({.normal = NormalModel::hertz}), bodies, none(), 1).collide(0.3, 1e-11);
    EXPECT_LT(std::abs(jkr.restitution - hertz.restitution), last_restitution);
    EXPECT_LT(std::abs(*jkr.contact_time / *hertz.contact_time - 1), last_time);
    last_restitution = std::abs(jkr.restitution - hertz.restitution);
    last_time = std::abs(*jkr.contact_time / *hertz.contact_time - 1);
  }
  EXPECT_LT(last_restitution, 1e-8);
}

TEST(JkrWithoutSurfaceEnergy, IsModelledAsHertz) {
  const Material m = elastic(10e9, 0.25, 2500, 0);
  const ScaledContact contact({}, {m, m, {}, {0.5e-3, 0.5e-3}}, none(), 1);
  EXPECT_EQ(contact.kind().normal, NormalModel::hertz);
  EXPECT_FALSE(contact.sticking_speed(1e-10).has_value());
}

}  // namespace
}  // namespace scalebreak

#include <scalebreak/contact/tangential.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <scalebreak/contact/contact_laws.hpp>
#include <scalebreak/contact/damping.hpp>

// Spring, dashpot and limit of friction against the papers' equations, written here once more.

namespace scalebreak {
namespace {

constexpr double e = 0.81, mass = 6.5e-7, radius = 0.25e-3, young = 5.3e9, shear = 1.1e9, energy = 0.02, mu = 0.3;

NormalPair normal_pair() { return {mass, radius, young, energy, 8.1e4, damping_ratio(e)}; }
SurfacePair surface_pair() { return {.shear = shear, .spring_constant_tangential = 2.7e4, .sliding_friction = mu}; }

/// W eq. 17, which is negative.
double beta() { return std::log(e) / std::sqrt(std::pow(std::log(e), 2) + std::pow(std::numbers::pi, 2)); }

ContactLaws laws(NormalModel normal, TangentialModel tangential, DampingOn tangential_radius) {
  const SurfaceKind surface{.tangential = tangential, .tangential_radius = tangential_radius};
  return contact_laws({normal, AdhesionRange::full, DampingOn::contact_radius}, surface, normal_pair(), surface_pair());
}

TEST(Tangential, LinearSpringHasTheDashpotOfItsOwnConstant) {
  const SliderLaw law = laws(NormalModel::linear, TangentialModel::linear, DampingOn::overlap).tangential.at({.load = 7}, {.load = 3});
  EXPECT_EQ(law.stiffness, 2.7e4);
  // W eq. 70 in SI: as eq. 8 with k_t for k_n.
  EXPECT_NEAR(law.damping / std::sqrt(4 * mass * 2.7e4 / (1 + std::pow(std::numbers::pi / std::log(e), 2))), 1, 1e-14);
  EXPECT_EQ(law.stiffness_rate, 0);
  EXPECT_EQ(law.damping_rate, 0);
  EXPECT_NEAR(law.limit, mu * 7, 1e-15);
  EXPECT_NEAR(law.limit_rate, mu * 3, 1e-15);
  EXPECT_TRUE(law.dashpot_is_limited);
  EXPECT_FALSE(law.incremental);
}

TEST(Tangential, MindlinsOnTheOverlapIsWashinos) {
  const double overlap = 2.3e-7;
  const ContactPoint point{.overlap = overlap, .root = 99, .overlap_root = std::pow(radius * overlap, 0.25), .load = 7};
  const SliderLaw law = laws(NormalModel::jkr, TangentialModel::mindlin, DampingOn::overlap).tangential.at(point, {});
  EXPECT_NEAR(law.stiffness / (8 * shear * std::sqrt(radius * overlap)), 1, 1e-14);  // W eq. 11
  const double dashpot = -4 * std::sqrt(5.0 / 3) * beta() * std::sqrt(mass * shear) * std::pow(radius, 0.25) * std::pow(overlap, 0.25);
  EXPECT_NEAR(law.damping / dashpot, 1, 1e-14);  // W eq. 16
}

TEST(Tangential, MindlinsOnTheContactRadiusPutsItForTheRoot) {
  const double a = 3.1e-6;
  const ContactPoint point{.overlap = -1e-9, .root = std::sqrt(a), .load = 7};
  const SliderLaw law = laws(NormalModel::jkr, TangentialModel::mindlin, DampingOn::contact_radius).tangential.at(point, {});
  EXPECT_NEAR(law.stiffness / (8 * shear * a), 1, 1e-14);
  EXPECT_NEAR(law.damping / (-4 * std::sqrt(5.0 / 3) * beta() * std::sqrt(mass * shear * a)), 1, 1e-14);
}

TEST(Tangential, OnTheOverlapIsZeroBelowZeroOverlap) {
  const SliderLaw law =
      laws(NormalModel::jkr, TangentialModel::mindlin, DampingOn::overlap).tangential.at({.overlap = -1e-9, .root = 1e-3, .load = 7}, {});
  EXPECT_EQ(law.stiffness, 0);
  EXPECT_EQ(law.damping, 0);
}

TEST(Tangential, RatesAreThoseOfItsParts) {
  for (const DampingOn on : {DampingOn::overlap, DampingOn::contact_radius}) {
    const Tangential law = laws(NormalModel::jkr, TangentialModel::mindlin, on).tangential;
    const ContactPoint point{.root = 1.7e-3, .overlap_root = 1.3e-3, .load = 7}, rate{.root = 0.4, .overlap_root = 0.9, .load = -20};
    const auto later = [&](double dt) {
      return law.at({.root = point.root + dt * rate.root,
                     .overlap_root = point.overlap_root + dt * rate.overlap_root,
                     .load = point.load + dt * rate.load},
                    {});
    };
    constexpr double dt = 1e-7;
    const SliderLaw now = law.at(point, rate), after = later(dt), before = later(-dt);
    EXPECT_NEAR((after.stiffness - before.stiffness) / (2 * dt) / now.stiffness_rate, 1, 1e-7);
    EXPECT_NEAR((after.damping - before.damping) / (2 * dt) / now.damping_rate, 1, 1e-7);
    EXPECT_NEAR((after.limit - before.limit) / (2 * dt) / now.limit_rate, 1, 1e-7);
  }
}

TEST(Tangential, LoadOfHertzAndLinearIsSpringPlusDashpot) {
  const auto hertz = Hertz<double>::make(normal_pair(), AdhesionRange::touch);
  EXPECT_EQ(hertz.load(1e-3, 5.5), 5.5);
  const auto linear = Linear<double>::make(normal_pair(), AdhesionRange::touch);
  EXPECT_EQ(linear.load(1e-7, -5.5), -5.5);  // the engine takes its magnitude, and follows its sign
}

TEST(Tangential, LoadOfJkrIsTheEffectiveLoadOfWashinosEquation18) {
  const auto jkr = Jkr<double>::make(normal_pair(), AdhesionRange::full);
  const double pull_off = 3 * std::numbers::pi * energy * radius;                         // W eq. 19
  const double a_0 = std::cbrt(9 * std::numbers::pi * energy * radius * radius / young);  // W eq. 20
  for (const double ratio : {0.3, 0.7937, 1.0, 2.5, 11.0}) {
    const double load = std::abs(4 * std::pow(ratio, 3) - 4 * std::pow(ratio, 1.5) + 2) * pull_off;
    EXPECT_NEAR(jkr.load(std::sqrt(ratio * a_0), 1e9) / load, 1, 1e-12);
    const double x = std::sqrt(ratio * a_0), dx = 1e-6 * x;
    EXPECT_NEAR((jkr.load(x + dx, 0) - jkr.load(x - dx, 0)) / (2 * dx), jkr.load_rate(x, 1, 1e9), 1e-6 * load / x);
  }
}

}  // namespace
}  // namespace scalebreak

#include <scalebreak/contact/rolling.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <scalebreak/contact/damping.hpp>
#include <scalebreak/contact/jkr.hpp>

// Rolling resistance against the papers' equations (W: Washino et al. 2024, H: Hu 2024), written here once more.

namespace scalebreak {
namespace {

constexpr double mass = 6.5e-7, radius = 0.25e-3, young = 5.3e9, shear = 1.1e9, energy = 0.02;
constexpr double friction = 0.13, damping = 0.4, angle = 0.012, inertia = 3e-13;

Rolling rolling(RollingModel model, NormalModel normal = NormalModel::jkr, double adhesive = 1) {
  const NormalPair pair{mass, radius, young, energy, 8.1e4, damping_ratio(0.81)};
  const SurfacePair surfaces{.shear = shear,
                             .spring_constant_tangential = 2.7e4,
                             .rolling_friction = friction,
                             .rolling_damping = damping,
                             .rolling_angle_max = angle,
                             .rolling_spring_constant = 120,
                             .rolling_dashpot = 3e-4,
                             .surface_energy = energy,
                             .rolling_inertia = inertia};
  return Rolling::make({.rolling = model}, {.normal = normal}, pair, surfaces, adhesive);
}

constexpr double overlap = 2.3e-7, a = 8e-6, load = 7;
ContactPoint point() { return {.overlap = overlap, .root = std::sqrt(a), .overlap_root = std::pow(radius * overlap, 0.25), .load = load}; }

TEST(Rolling, CdtIsAConstantTorque) {
  const SliderLaw law = rolling(RollingModel::cdt).at(point(), {.load = 3});
  EXPECT_NEAR(law.limit / (friction * radius * load), 1, 1e-14);  // W eq. 38
  EXPECT_NEAR(law.limit_rate / (friction * radius * 3), 1, 1e-14);
  EXPECT_EQ(law.stiffness, 0);
  EXPECT_EQ(law.damping, 0);
  EXPECT_TRUE(rolling(RollingModel::cdt).rigid());
}

TEST(Rolling, EpsdIsWashinosEquations44And45) {
  for (const NormalModel normal : {NormalModel::linear, NormalModel::hertz, NormalModel::jkr}) {
    const SliderLaw law = rolling(RollingModel::epsd, normal).at(point(), {});
    const double k_n = normal == NormalModel::linear ? 8.1e4 : 4.0 / 3 * young * std::sqrt(radius * overlap);
    const double k_r = 2.25 * k_n * friction * friction * radius * radius;
    EXPECT_NEAR(law.stiffness / k_r, 1, 1e-14);
    EXPECT_NEAR(law.damping / (2 * damping * std::sqrt(inertia * k_r)), 1, 1e-14);
    EXPECT_NEAR(law.limit / (friction * radius * load), 1, 1e-14);
    EXPECT_FALSE(law.dashpot_is_limited);  // W eq. 42: the limit is on the spring alone
    EXPECT_TRUE(law.incremental);          // W eq. 43: ∫ k_r ω dt
  }
}

TEST(Rolling, SdsIsThatOfLammps) {
  const SliderLaw law = rolling(RollingModel::sds).at(point(), {.load = 3});
  EXPECT_NEAR(law.stiffness / (120 * radius * radius), 1, 1e-14);  // F = k_r R* θ at the lever R*
  EXPECT_NEAR(law.damping / (3e-4 * radius * radius), 1, 1e-14);
  EXPECT_NEAR(law.limit / (friction * radius * load), 1, 1e-14);
  EXPECT_NEAR(law.limit_rate / (friction * radius * 3), 1, 1e-14);
  EXPECT_TRUE(law.dashpot_is_limited);
  EXPECT_FALSE(law.incremental);
}

TEST(Rolling, Epsd2IsHusEquation250) {
  const SliderLaw law = rolling(RollingModel::epsd2).at(point(), {});
  EXPECT_NEAR(law.stiffness / (8 * shear * std::sqrt(radius * overlap) * radius * radius), 1, 1e-14);
  EXPECT_NEAR(law.limit / (friction * radius * load), 1, 1e-14);  // H eq. 2.47
  EXPECT_EQ(law.damping, 0);
  EXPECT_TRUE(law.incremental);
  EXPECT_NEAR(rolling(RollingModel::epsd2, NormalModel::linear).at(point(), {}).stiffness / (2.7e4 * radius * radius), 1, 1e-14);
}

TEST(Rolling, AdhesiveRollingIsWashinosEquations49And53) {
  const double pull_off = 3 * std::numbers::pi * energy * radius;
  const double a_0 = std::cbrt(9 * std::numbers::pi * energy * radius * radius / young);
  const double k_r = 4 * pull_off * radius * std::pow(a / a_0, 1.5);
  for (const NormalModel normal : {NormalModel::hertz, NormalModel::jkr}) {
    const SliderLaw law = rolling(RollingModel::ar, normal).at(point(), {});
    EXPECT_NEAR(law.stiffness / k_r, 1, 1e-13);
    EXPECT_NEAR(law.limit / (k_r * angle), 1, 1e-13);
    EXPECT_EQ(law.damping, 0);
    EXPECT_FALSE(law.incremental);  // the torque is k_r θ, whatever k_r was before
  }
  EXPECT_NEAR(rolling(RollingModel::ar, NormalModel::jkr, 0.3).at(point(), {}).stiffness / (0.3 * k_r), 1, 1e-13);
}

TEST(Rolling, AdhesiveRollingHasTheRatesOfItsParts) {
  const Rolling law = rolling(RollingModel::ar);
  constexpr double dt = 1e-8;
  const auto at = [&](double t) { return law.at({.root = std::sqrt(a) + 0.4 * t}, {}); };
  const SliderLaw now = law.at({.root = std::sqrt(a)}, {.root = 0.4});
  EXPECT_NEAR((at(dt).stiffness - at(-dt).stiffness) / (2 * dt) / now.stiffness_rate, 1, 1e-7);
  EXPECT_NEAR((at(dt).limit - at(-dt).limit) / (2 * dt) / now.limit_rate, 1, 1e-7);
}

TEST(Rolling, SpringsOnTheOverlapVanishBelowZeroOverlap) {
  const ContactPoint stretched{.overlap = -1e-9, .root = std::sqrt(a), .load = load};
  for (const RollingModel model : {RollingModel::epsd, RollingModel::epsd2}) {
    EXPECT_TRUE(rolling(model).on_overlap());
    EXPECT_EQ(rolling(model).at(stretched, {}).stiffness, 0);
    EXPECT_EQ(rolling(model).at(stretched, {}).damping, 0);
  }
  EXPECT_FALSE(rolling(RollingModel::ar).on_overlap());
  EXPECT_FALSE(rolling(RollingModel::epsd, NormalModel::linear).on_overlap());
}

}  // namespace
}  // namespace scalebreak

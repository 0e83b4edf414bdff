#include <scalebreak/dem/critical_step.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

// The papers' critical steps, written once more.

namespace scalebreak {
namespace {

constexpr double radius = 0.5e-3, pi = std::numbers::pi;

DemSetup glass(NormalModel normal) {
  DemSetup setup{.contact = {normal, AdhesionRange::touch, DampingOn::overlap}};
  for (Material* material : {&setup.material, &setup.second}) material->surface_energy = 0;
  return setup;
}

TEST(CriticalStep, OfAHertzContactIsRayleighs) {
  const double expected = pi * radius / (0.8766 + 0.163 * 0.25) * std::sqrt(2 * 2500 * 1.25 / 10e9);  // W eq. 55
  const auto bounds = critical_steps(glass(NormalModel::hertz), radius);
  ASSERT_EQ(bounds.size(), 1u);
  EXPECT_EQ(bounds[0].name, "Rayleigh");
  EXPECT_NEAR(bounds[0].step / expected, 1, 1e-14);
}

TEST(CriticalStep, OfALinearContactIsATenthOfItsOscillation) {
  const double mass = 4.0 / 3 * pi * radius * radius * radius * 2500;
  const auto bounds = critical_steps(glass(NormalModel::linear), radius);
  EXPECT_EQ(bounds[0].name, "oscillation");
  EXPECT_NEAR(bounds[0].step / (0.1 * 2 * pi * std::sqrt(mass / 8.1e4)), 1, 1e-14);  // W eq. 54
}

TEST(CriticalStep, NamesTheSmallestBound) {
  const DemSetup setup = glass(NormalModel::hertz);
  const double rayleigh = rayleigh_step(setup, radius);
  EXPECT_EQ(critical_steps(setup, radius, 29 * rayleigh).front().name, "contact time");
  EXPECT_EQ(critical_steps(setup, radius, 31 * rayleigh).front().name, "Rayleigh");
}

TEST(CriticalStep, GrowsUnderScalingLaws) {
  DemSetup setup = glass(NormalModel::hertz);
  const double original = rayleigh_step(setup, radius);
  setup.law = *find_scaling_law("rps"), setup.factor = 1e-4;
  EXPECT_NEAR(rayleigh_step(setup, radius) / original, 100, 1e-10);
  // Hu 2024, section 4.4: 0.6, 1.2 and 2.4 µs for l = 1, 2 and 4.
  setup.law = *find_scaling_law("sup");
  for (const double size : {2.0, 4.0}) {
    setup.factor = size;
    EXPECT_NEAR(rayleigh_step(setup, size * radius) / original, size, 1e-12);
  }
}

}  // namespace
}  // namespace scalebreak

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include <scalebreak/ensembles/engine/event_engine.hpp>
#include <scalebreak/ensembles/prediction/granular_theory.hpp>

namespace scalebreak::tests {
namespace {

using std::numbers::pi;

TEST(GranularTheory, MeetsEnskogFarFromJamming) {
  const double phi = 0.3, d = 1e-3, temperature = 4e-4, jamming = 0.6;
  const double free = contact_value(phi, jamming) * (1 - jamming_share(phi, jamming));
  EXPECT_NEAR(free, (1 - phi / 2) / std::pow(1 - phi, 3), 1e-12);
  EXPECT_NEAR(fluid_contact_value(phi), free, 1e-12);
  const double crowd = 6 * phi / (pi * d);  // Σd²/V
  EXPECT_NEAR(collisions_of_sphere(phi, free, temperature, d) / enskog_rate(crowd, phi, std::sqrt(3 * temperature)), 1, 1e-12);
}

TEST(GranularTheory, ImpactSpeedIsTheMeanOverMaxwellsCollisions) {
  const double temperature = 2.5;  // of approach speeds v along the line of centres, collisions have v exp(−v²/4T)
  double sum = 0, weight = 0;
  for (double v = 0.0005; v < 40; v += 0.001) {
    const double w = v * std::exp(-v * v / (4 * temperature));
    sum += w * v, weight += w;
  }
  EXPECT_NEAR(mean_impact_speed(temperature) / (sum / weight), 1, 1e-6);
}

TEST(GranularTheory, ShearBalancesWorkAndDissipation) {
  // A dilute gas that is nearly elastic: η = (5√π/96) ρ d √T (Chapman & Enskog), dissipation (12/√π) ρφ²χ(1 − e²)T^{3/2}/d.
  const double phi = 1e-5, e = 0.999;
  const double dilute = 5 * pi / (96 * 12 * phi * phi * (1 - e * e));
  EXPECT_NEAR(shear_temperature_number(phi, 1, e) / dilute, 1, 3e-3);
  // Dense: nothing but collisions, a number of e alone.
  const double j = (1 + e) / 2 + pi / 4 * (1 + e) * (1 + e) * (3 * e - 1) / (24 - 6 * (1 - e) * (1 - e) - 5 * (1 - e * e));
  EXPECT_NEAR(shear_temperature_number(0.6, 1e6, e) / (2 * j / (15 * (1 - e * e))), 1, 1e-4);
}

TEST(GranularTheory, KnowsFriction) {
  EXPECT_EQ(effective_restitution(0.8, 0), 0.8);
  EXPECT_NEAR(effective_restitution(0.81, 0.3), 0.81 - 0.45 * std::exp(-0.9), 1e-12);
  EXPECT_EQ(effective_restitution(0.1, 0.3), 0);
  EXPECT_NEAR(jamming_fraction(0.3), 0.596, 1e-12);
  EXPECT_NEAR(jamming_fraction(0.2), 0.6045, 1e-12);
  EXPECT_NEAR(jamming_fraction(5), 0.581, 1e-12);
}

}  // namespace
}  // namespace scalebreak::tests

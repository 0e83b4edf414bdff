#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/rules/constant_restitution.hpp>

#include "dem/flows.hpp"

// Gases of hard spheres beside the theory of fluids and of granular gases.

namespace scalebreak {
namespace {

using Smooth = EventSpheres<CalendarQueue, SmoothRule>;
using Rough = EventSpheres<CalendarQueue, RoughRule>;
constexpr double radius = 0.5e-3, speed = 0.1;

/// One third of the mean squared velocity, of N − 1 spheres' worth as there is no net momentum [m²/s²].
double temperature(const System& system) {
  double sum = 0;
  for (const auto& v : system.velocity) sum += v.squaredNorm();
  return sum / (3 * static_cast<double>(system.count() - 1));
}

/// The same of the spins, as energy over mass: I/m times a third of the mean squared spin.
double spin_temperature(const System& system) {
  double sum = 0;
  for (const auto& spin : system.spin) sum += spin.squaredNorm();
  return 0.4 * radius * radius * sum / (3 * static_cast<double>(system.count()));
}

/// Of a pair in contact, by Carnahan and Starling.
double contact_value(double volume_fraction) { return (1 - volume_fraction / 2) / std::pow(1 - volume_fraction, 3); }

/// Enskog's collision rate per sphere, 4 n d² χ √(πT).
double enskog_rate(const System& system, double volume_fraction, double t) {
  const double d = 2 * radius, density = static_cast<double>(system.count()) / system.cell.volume();
  return 4 * density * d * d * contact_value(volume_fraction) * std::sqrt(std::numbers::pi * t);
}

TEST(ElasticHardSpheres, HavePressureOfCarnahanAndStarlingAndCollideAtEnskogsRate) {
  for (const double volume_fraction : {0.1, 0.2, 0.3, 0.4, 0.45}) {
    const System start = test::filled(4000, volume_fraction, {radius}, speed);
    Smooth flow(start, {}, {1.0});
    flow.advance_collisions(60'000);  // 30 a sphere
    const double began = flow.time(), moment = flow.totals().contact_moment.trace();
    constexpr long collisions = 400'000;
    flow.advance_collisions(collisions);
    const double time = flow.time() - began, t = temperature(start);
    const double phi = volume_fraction, carnahan_starling = (1 + phi + phi * phi - phi * phi * phi) / std::pow(1 - phi, 3);
    const double measured = 1 + (flow.totals().contact_moment.trace() - moment) / (3 * 4000 * start.mass[0] * t * time);
    EXPECT_NEAR(measured / carnahan_starling, 1, 0.01) << phi;
    EXPECT_NEAR((measured - 1) / (carnahan_starling - 1), 1, 0.01) << phi;
    EXPECT_NEAR(2 * collisions / (4000 * time) / enskog_rate(start, phi, t), 1, 0.01) << phi;
  }
}

TEST(InelasticHardSpheres, CoolByHaffsLaw) {
  for (const double restitution : {0.9, 0.97}) {
    const double volume_fraction = 0.2;
    const System start = test::filled(8000, volume_fraction, {radius}, speed);
    Smooth elastic(start, {}, {1.0});
    elastic.advance_collisions(40'000);  // forgets how the filling was made
    const System fluid = elastic.system();
    Smooth flow(fluid, {}, {restitution});
    const double initial = temperature(fluid), rate = enskog_rate(fluid, volume_fraction, initial);
    for (const double collisions : {5.0, 10.0, 20.0}) {
      const double time = collisions / rate;
      flow.advance_to(fluid.time + time);
      const double haff = initial / std::pow(1 + (1 - restitution * restitution) * rate * time / 6, 2);
      EXPECT_NEAR(temperature(flow.system()) / haff, 1, 0.03) << restitution << ' ' << collisions;
    }
    EXPECT_NEAR(flow.totals().dissipated / (1.5 * 7999 * fluid.mass[0] * (initial - temperature(flow.system()))), 1, 1e-9);
  }
}

/// Mean-field cooling of rough spheres (Huthmann & Zippelius, Phys. Rev. E 56, R6275 (1997); Luding, Huthmann, McNamara & Zippelius, Phys.
/// Rev. E 58, 3416 (1998)): dT/dt = −G (A T^{3/2} − B T^{1/2} T_r), dT_r/dt = G (B T^{3/2} − C T^{1/2} T_r), with q = 2/5, η = q (1 + β)/(2 + 2q),
/// A = (1 − e²)/4 + η (1 − η), B = η²/q, C = (η/q)(1 − η/q), and G √T = 4/3 of Enskog's rate, so that smooth spheres cool by Haff's law.
std::array<double, 2> mean_field(std::array<double, 2> temperatures, double e, double beta, double rate, double time) {
  const double q = 0.4, eta = q * (1 + beta) / (2 + 2 * q);
  const double a = (1 - e * e) / 4 + eta * (1 - eta), b = eta * eta / q, c = eta / q * (1 - eta / q), t0 = temperatures[0];
  const auto slope = [&](const std::array<double, 2>& t) {
    const double g = 4.0 / 3 * rate * std::sqrt(t[0] / t0);
    return std::array{-g * (a * t[0] - b * t[1]), g * (b * t[0] - c * t[1])};
  };
  constexpr int steps = 2000;  // of the midpoint rule
  for (int step = 0; step < steps; ++step) {
    const auto k = slope(temperatures);
    const auto middle = slope({temperatures[0] + k[0] * time / steps / 2, temperatures[1] + k[1] * time / steps / 2});
    for (const std::size_t i : {0, 1}) temperatures[i] += middle[i] * time / steps;
  }
  return temperatures;
}

TEST(RoughHardSpheres, ShareTheirEnergyAsMeanFieldTheorySays) {
  const double volume_fraction = 0.1, e = 0.95;
  for (const double beta : {-0.5, 0.0, 0.8}) {
    const System filled = test::filled(8000, volume_fraction, {radius}, speed);
    Smooth elastic(filled, {}, {1.0});
    elastic.advance_collisions(40'000);
    const System start = elastic.system();
    Rough flow(start, {}, {e, beta});
    const double initial = temperature(start), rate = enskog_rate(start, volume_fraction, initial);
    for (const double collisions : {2.0, 6.0, 15.0}) {
      flow.advance_to(start.time + collisions / rate);
      const System now = flow.system();
      const auto theory = mean_field({initial, 0}, e, beta, rate, collisions / rate);
      EXPECT_NEAR(temperature(now) / theory[0], 1, 0.03) << beta << ' ' << collisions;
      EXPECT_NEAR(spin_temperature(now) / theory[1], 1, 0.05) << beta << ' ' << collisions;
    }
  }
}

TEST(RoughHardSpheres, ThatLoseNothingShareTheirEnergyEvenly) {
  const System start = test::filled(2000, 0.3, {radius}, speed);
  Rough flow(start, {}, {1.0, 1.0});
  flow.advance_collisions(100'000);
  const System end = flow.system();
  EXPECT_NEAR(test::kinetic_energy_about_flow(end) / test::kinetic_energy_about_flow(start), 1, 1e-12);
  EXPECT_NEAR(spin_temperature(end) / temperature(end), 1, 0.05);  // 3 N degrees of freedom each: 2 % one standard error
}

}  // namespace
}  // namespace scalebreak

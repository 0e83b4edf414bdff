#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dem/flows.hpp"

// Gases of soft spheres beside kinetic theory, and the balance of the laws that a flow keeps.

namespace scalebreak {
namespace {

/// One third of the mean squared velocity [m²/s²].
double temperature(const System& system) {
  double sum = 0;
  for (const auto& v : system.velocity) sum += v.squaredNorm();
  return sum / (3 * static_cast<double>(system.count()));
}

/// Enskog's collision rate per sphere, 4 n d² χ √(πT), with Carnahan and Starling's χ.
double enskog_rate(const System& system, double volume_fraction, double temperature) {
  const double d = 2 * system.radius[0], density = static_cast<double>(system.count()) / system.cell.volume();
  const double contact_value = (1 - volume_fraction / 2) / std::pow(1 - volume_fraction, 3);
  return 4 * density * d * d * contact_value * std::sqrt(std::numbers::pi * temperature);
}

TEST(ElasticGas, CollidesAtEnskogsRate) {
  for (const double volume_fraction : {0.1, 0.3}) {
    // Stiff enough that the overlap, which makes spheres smaller, is far below the statistics.
    const System start = test::filled(3000, volume_fraction, {0.5e-3}, 0.05);
    const DemSetup setup = test::smooth(1e9, 1, 0.2, 0.5e-3);
    Dem dem(start, setup);
    dem.keep_sums(false);
    const double rate = enskog_rate(start, volume_fraction, temperature(start));
    dem.advance(std::lround(2 / rate / setup.step));
    const double before = dem.totals().contact_starts, began = dem.time();
    dem.advance(std::lround(20 / rate / setup.step));
    const double measured = 2 * (dem.totals().contact_starts - before) / (3000 * (dem.time() - began));
    EXPECT_NEAR(measured / rate, 1, 0.015) << volume_fraction;  // 30 000 collisions: 0.6 %, and soft spheres are smaller by their overlap
  }
}

TEST(ElasticGas, KeepsItsEnergyAndMomentum) {
  const System start = test::filled(2000, 0.5, {0.5e-3}, 0.1);
  Dem dem(start, test::smooth(1e8, 1, 0.1, 0.5e-3));
  const auto energy = [&] { return test::kinetic_energy_about_flow(dem.system()) + dem.elastic_energy(); };
  const double before = energy(), momentum = test::momentum_of(start).norm();
  dem.advance(40'000);
  const double collisions = dem.totals().contact_starts;
  EXPECT_GT(collisions, 1e5);
  EXPECT_LT(std::abs(energy() / before - 1) / collisions, 1e-5);
  double size = 0;
  for (std::size_t i = 0; i < start.count(); ++i) size += start.mass[i] * start.velocity[i].norm();
  EXPECT_LT(std::abs(test::momentum_of(dem.system()).norm() - momentum), 1e-12 * size);
}

TEST(InelasticGas, CoolsByHaffsLaw) {
  const double restitution = 0.9, volume_fraction = 0.2;
  const System start = test::filled(4000, volume_fraction, {0.5e-3}, 0.1);
  DemSetup setup = test::smooth(1e9, restitution, 0.2, 0.5e-3);
  Dem dem(start, setup);
  dem.keep_sums(false);
  const double initial = temperature(start), rate = enskog_rate(start, volume_fraction, initial);
  for (const double collisions : {5.0, 10.0}) {
    dem.advance(std::lround(collisions / rate / setup.step) - dem.steps());
    const double haff = initial / std::pow(1 + (1 - restitution * restitution) * rate * dem.time() / 6, 2);
    EXPECT_NEAR(temperature(dem.system()) / haff, 1, 0.03);
  }
}

TEST(ShearedGas, KeepsNoMomentumAndFeelsItsStress) {
  const System start = test::filled(1000, 0.4, {0.5e-3}, 0.1, 100);
  DemSetup setup = test::rough(1e8, 0.8, 0.15, 0.5e-3);
  Dem dem(start, setup);
  dem.advance(20'000);
  const System end = dem.system();
  double size = 0;
  for (std::size_t i = 0; i < end.count(); ++i) size += end.mass[i] * end.velocity[i].norm();
  // A net velocity would make the mean profile drift away from the cell's.
  EXPECT_LT(test::momentum_of(end).norm(), 1e-9 * size);
  // Work of shear: the contact stress resists it, −∫P_xz dt < 0 for a flow along +x that grows with z.
  EXPECT_LT(dem.totals().contact_moment(0, 2), 0);
}

}  // namespace
}  // namespace scalebreak

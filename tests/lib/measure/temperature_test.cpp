#include <cmath>

#include <gtest/gtest.h>

#include <lib/measure/states.hpp>
#include <scalebreak/measure/flow_csv.hpp>

namespace scalebreak {
namespace {

/// One third of the mean squared velocity.
double own_temperature(const System& system) {
  double sum = 0;
  for (const auto& v : system.velocity) sum += v.squaredNorm();
  return sum / (3 * static_cast<double>(system.count()));
}

void add_flow(System& system, double (*speed)(double)) {
  for (std::size_t i = 0; i < system.count(); ++i) system.velocity[i].x() += speed(system.position[i].z());
}

TEST(Temperature, OfAGasAtRestIsAboutItsMeanVelocity) {
  System system = ideal_gas(periodic_cell(1, 1, 1), 500, 0.04, 1);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& v : system.velocity) mean += v / 500;
  for (auto& v : system.velocity) v -= mean;
  const double expected = own_temperature(system);
  for (auto& v : system.velocity) v += Eigen::Vector3d(3, -2, 1);
  EXPECT_NEAR(found(held(system), "temperature").value, expected, 1e-13);
}

TEST(Temperature, OfHomogeneousShearIsAboutTheImposedProfile) {
  Cell cell = periodic_cell(1, 1, 2);
  cell.shear_rate = 30;
  System system = ideal_gas(cell, 500, 0.04, 2);
  const double expected = own_temperature(system);
  for (std::size_t i = 0; i < system.count(); ++i) system.velocity[i] += mean_flow(cell, system.position[i].z());
  EXPECT_NEAR(found(held(system), "temperature").value, expected, 1e-11);
  // Spheres that have left through a face come back with the velocity of the place.
  for (std::size_t i = 0; i < system.count(); i += 2) {
    system.position[i].z() += 2;
    system.velocity[i].x() += 60;
  }
  EXPECT_NEAR(found(held(system), "temperature").value, expected, 1e-11);
}

TEST(Temperature, BetweenWallsDoesNotDependOnTheSlabs) {
  // W: not sensitive to Δz. About the means of five slabs, a shear of 10/s over slabs of 0.2 would add (γ̇Δz)²/36 = 0.11.
  const auto measure = [](int slabs) {
    FlowMeasurement measurement(slabs);
    for (int k = 0; k <= 40; ++k) {
      System system = ideal_gas(walled_cell(1, 1, 1), 500, 0.04, static_cast<std::uint64_t>(100 + k));
      add_flow(system, [](double z) { return 10 * (z - 0.5); });
      system.time = k;
      measurement.add({system, {}});
    }
    return measurement.result();
  };
  const double error = 0.04 * std::sqrt(2.0 / (3 * 500 * 40));
  for (const int slabs : {5, 20}) {
    const FlowResult result = measure(slabs);
    EXPECT_NEAR(found(result, "temperature").value, 0.04, 4 * error) << slabs;
    for (const Measured& slab : profile_of(result, "temperature")) EXPECT_NEAR(slab.value, 0.04, 4 * error * std::sqrt(slabs));
    for (int k = 0; k < slabs; ++k) {
      const double middle = (k + 0.5) / slabs, spread = 10.0 / slabs / std::sqrt(12.0);
      EXPECT_NEAR(profile_of(result, "velocity_x")[static_cast<std::size_t>(k)].value, 10 * (middle - 0.5),
                  4 * (0.2 + spread) / std::sqrt(500.0 * 40 / slabs));
    }
  }
}

TEST(Temperature, OfAContinuousProfileWithoutFluctuationsIsZero) {
  System system = ideal_gas(walled_cell(1, 1, 1), 500, 0, 3);
  add_flow(system, [](double z) { return z < 0.25 ? 8 * z : 2 - (z - 0.25); });  // kink at a face of the slabs
  const FlowResult result = held(system);
  EXPECT_NEAR(found(result, "temperature").value, 0, 1e-13);
  EXPECT_NEAR(found(result, "stress_xx").value, 0, 1e-10);
}

TEST(Temperature, OfOneStateBetweenWallsIsRaisedForWhatTheFitTakes) {
  double mean = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const System system = ideal_gas(walled_cell(1, 1, 1), 100, 0.04, 1000 + seed);
    mean += std::get<double>(series_row({system, {}})[1]) / 400;
  }
  EXPECT_NEAR(mean, 0.04, 4 * 0.04 * std::sqrt(2.0 / (3 * 79 * 400)));  // without it 0.0316
}

TEST(Temperature, ItsErrorIsThatOfItsMean) {
  // Ornstein–Uhlenbeck velocities of 20 spheres; T decorrelates twice as fast as they do.
  double mean_square = 0;
  constexpr int seeds = 200;
  for (int seed = 0; seed < seeds; ++seed) {
    System system = ideal_gas(periodic_cell(1, 1, 1), 20, 1, static_cast<std::uint64_t>(seed));
    std::mt19937_64 random(static_cast<std::uint64_t>(seed + 5000));
    std::normal_distribution<double> normal;
    FlowMeasurement measurement(1);
    for (int k = 0; k <= 2000; ++k) {
      measurement.add({system, {}});
      system.time += 1;
      for (auto& v : system.velocity) {
        for (double& component : v) component = 0.9 * component + std::sqrt(1 - 0.81) * normal(random);
      }
    }
    const Measured temperature = found(measurement.result(), "temperature");
    mean_square += std::pow((temperature.value - 1) / temperature.error, 2) / seeds;
  }
  EXPECT_NEAR(mean_square, 1, 0.3);  // three times √(2/200)
}

}  // namespace
}  // namespace scalebreak

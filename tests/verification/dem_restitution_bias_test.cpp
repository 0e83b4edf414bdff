#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>

// What velocity Verlet does to an elastic Hertz collision of N steps, over the phases of a step at which it begins.

namespace scalebreak {
namespace {

struct Bias {
  double largest = 0;    ///< |e − 1|
  double mean_gain = 0;  ///< of e² − 1
};

/// Two soft-sphere steps of any size see the same collision in units of its contact time, as long as overlaps are small.
Bias bias(double steps_per_contact) {
  Input input;
  input.contact = canonical({.normal = NormalModel::hertz});
  for (Material* material : {&input.material, &input.second}) material->restitution = 1, material->surface_energy = 0;
  const CollisionScene scene = collision_scene(input);
  constexpr int phases = 128;
  Bias bias;
  for (int k = 0; k < phases; ++k) {
    const CollisionOutcome outcome =
        step_collision(scene, Integrator::verlet, scene.reference.last_separation / steps_per_contact, (k + 0.5) / phases);
    const double e = (outcome.bodies[0].velocity.z() - outcome.bodies[1].velocity.z()) / input.normal_speed;
    bias.largest = std::max(bias.largest, std::abs(e - 1));
    bias.mean_gain += (e * e - 1) / phases;
  }
  return bias;
}

TEST(HertzByVelocityVerlet, IsOffByTheSizesKnownAndGainsEnergyInTheMean) {
  const Bias ten = bias(10), thirty = bias(30), hundred = bias(100);
  EXPECT_NEAR(ten.largest, 2.6e-3, 0.05e-3);
  EXPECT_NEAR(thirty.largest, 1.5e-4, 0.05e-4);
  EXPECT_NEAR(hundred.largest, 7.2e-6, 0.05e-6);
  for (const Bias& b : {ten, thirty, hundred}) EXPECT_GT(b.mean_gain, 0);
  EXPECT_LT(hundred.mean_gain, 1e-8);
}

/// The force begins as (v t)^{3/2}: a sum over steps is off its integral by step^{5/2}.
TEST(HertzByVelocityVerlet, ErrsByThePowerFiveHalvesOfTheStep) {
  EXPECT_NEAR(std::log(bias(40).largest / bias(160).largest) / std::log(4), 2.5, 0.1);
}

/// What begins and ends in phase gains; between whole numbers of steps most of it goes away again.
TEST(HertzByVelocityVerlet, GainsLessOverAllNumbersOfSteps) {
  double gain = 0;
  for (const double part : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}) gain += bias(30 + part).mean_gain / 8;
  EXPECT_LT(std::abs(gain), 0.3 * bias(30).mean_gain);
}

}  // namespace
}  // namespace scalebreak

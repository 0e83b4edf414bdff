#include <cmath>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/height.hpp>

#include "dem/flows.hpp"

// A cell whose height follows the normal stress: the law of the height, what the spheres keep, and the account of its work.

namespace scalebreak {
namespace {

/// A flow that stiffens like a spring is a damped oscillator: Ḧ = −(K/μH₀)(H − H₀) − (c/τ)Ḣ.
TEST(Height, SwingsLikeADampedOscillator) {
  dem::Height law{.pressure = 1000, .inertia = 1.3};
  const double rest = 8e-3, stiffness = 3e4, amplitude = 1e-4 * rest;
  const double decay = dem::Height::damping / 2 / std::sqrt(law.inertia * rest / law.pressure);
  const double frequency = std::sqrt(stiffness / (law.inertia * rest) - decay * decay), step = 1e-3 / frequency;
  double height = rest + amplitude;
  const int steps = 10'000;
  for (int k = 0; k < steps; ++k) {
    // The first push is by half a step.
    law.speed = law.pushed(height, law.pressure - stiffness * (height - rest) / rest, k == 0 ? step / 2 : step);
    height += step * law.speed;
  }
  const double phase = frequency * step * steps,
               exact = amplitude * std::exp(-decay * step * steps) * (std::cos(phase) + decay / frequency * std::sin(phase));
  EXPECT_LT(std::exp(-decay * step * steps), 0.5);
  EXPECT_NEAR(height - rest, exact, 1e-4 * amplitude);
}

DemSetup pressed(DemSetup setup, double pressure, int threads = 1) {
  setup.pressure = pressure, setup.threads = threads;
  return setup;
}

TEST(ConfinedShear, KeepsMomentumToRounding) {
  const System start = test::filled(500, 0.4, {0.5e-3, 0.4e-3}, 0.1, 100);
  Dem dem(start, pressed(test::rough(1e8, 0.8, 0.15, 0.4e-3), 2e3));
  dem.advance(20'000);
  const System end = dem.system();
  double size = 0;
  for (std::size_t i = 0; i < end.count(); ++i) size += end.mass[i] * end.velocity[i].norm();
  EXPECT_LT(end.cell.size.z(), 0.95 * start.cell.size.z());
  EXPECT_EQ(end.cell.size.x(), start.cell.size.x());
  EXPECT_LT(test::momentum_of(end).norm(), 1e-10 * size);
}

/// Spheres that lose nothing gain what the shear and the height do: −∫(γ̇ P_xz + ε P_zz)V dt.
TEST(ConfinedShear, AccountsForTheWorkOfTheHeight) {
  const double shear_rate = 100;
  for (const double pressure : {20.0, 2000.0}) {  // it rises, it falls
    const System start = test::filled(300, 0.4, {0.5e-3}, 0.2, shear_rate);
    const DemSetup setup = pressed(test::smooth(1e7, 1, 0.02, 0.5e-3), pressure);
    Dem dem(start, setup);
    const auto energy = [&] { return test::kinetic_energy_about_flow(dem.system()) + dem.elastic_energy(); };
    const double before = energy(), moment_before = dem.totals().contact_moment(0, 2);
    double kinetic = 0;
    for (int step = 0; step < 15'000; ++step) {
      dem.advance(1);
      const System system = dem.system();
      for (std::size_t i = 0; i < system.count(); ++i) {
        const Eigen::Vector3d v = system.velocity[i] - mean_flow(system.cell, system.position[i].z());
        kinetic += setup.step * system.mass[i] * v.x() * v.z();
      }
    }
    const double shear = -shear_rate * (kinetic + dem.totals().contact_moment(0, 2) - moment_before);
    const double height = dem.totals().wall_work, gain = energy() - before;
    EXPECT_GT(std::abs(height), 0.1 * before) << pressure;
    EXPECT_GT(shear, 0.01 * before);
    EXPECT_NEAR(gain, shear + height, 2e-3 * std::abs(height)) << pressure;
  }
}

TEST(ConfinedShear, SavedGoesOnBitForBit) {
  for (const int threads : {1, 2}) {
    for (const Integrator integrator : {Integrator::verlet, Integrator::synchronized}) {
      DemSetup setup = pressed(test::rough(1e7, 0.8, 0.1, 0.3e-3), 500, threads);
      setup.integrator = integrator;
      Dem straight(test::filled(300, 0.45, {0.5e-3, 0.3e-3}, 0.2, 100), setup);
      straight.advance(137);
      Dem resumed(straight.save(), setup);
      straight.advance(400);
      resumed.advance(400);
      const System a = straight.system(), b = resumed.system();
      EXPECT_EQ(a.cell, b.cell);
      for (std::size_t i = 0; i < a.count(); ++i) {
        ASSERT_EQ(a.position[i], b.position[i]);
        ASSERT_EQ(a.velocity[i], b.velocity[i]);
        ASSERT_EQ(a.spin[i], b.spin[i]);
      }
      EXPECT_EQ(straight.totals().wall_work, resumed.totals().wall_work);
      EXPECT_GT(straight.totals().contact_starts, 100);
    }
  }
}

/// Contacts see the affine motion too: forces are those of the same spheres with it among their velocities, in a cell that keeps its height.
TEST(ConfinedShear, ShowsContactsTheMotionOfTheHeight) {
  for (const double pressure : {1.0, 1e5}) {
    DemSetup setup = pressed(test::rough(1e7, 0.3, 0.02, 0.5e-3), pressure);
    setup.integrator = Integrator::synchronized;
    Dem dem(test::filled(300, 0.5, {0.5e-3}, 0.3, 100), setup);
    dem.advance(400);
    const double before = dem.system().cell.size.z();
    dem.advance(1);
    const System state = dem.system();
    const double height = state.cell.size.z(), rate = (height - before) / setup.step / height;
    System with = state;
    for (std::size_t i = 0; i < with.count(); ++i) with.velocity[i].z() += rate * with.position[i].z();
    setup.pressure = 0;
    const auto told = dem.contact_forces(), seen = Dem(with, setup).contact_forces(), unseen = Dem(state, setup).contact_forces();
    ASSERT_EQ(told.size(), seen.size());
    double apart = 0, effect = 0;
    std::size_t compared = 0;
    for (const ContactForce& one : told) {
      const Eigen::Vector3d between =
          state.position[static_cast<std::size_t>(one.second)] - state.position[static_cast<std::size_t>(one.first)];
      if (std::abs(between.z()) > height / 2) continue;  // across the faces, where the other cell's images do not rise
      const auto of = [&](const std::vector<ContactForce>& forces) -> Eigen::Vector3d {
        for (const ContactForce& other : forces) {
          if (other.first == one.first && other.second == one.second) return other.force;
          if (other.first == one.second && other.second == one.first) return -other.force;
        }
        ADD_FAILURE() << "no contact of " << one.first << " and " << one.second;
        return {};
      };
      ++compared;
      apart += (one.force - of(seen)).squaredNorm(), effect += (of(seen) - of(unseen)).squaredNorm();
    }
    EXPECT_GT(compared, 20u);
    EXPECT_LT(std::sqrt(apart), 0.05 * std::sqrt(effect)) << pressure;
  }
}

/// Where the faces of the cell lie is no physics: all moved up by half the height goes the same way.
TEST(ConfinedShear, KnowsNoPlaceOfTheFaces) {
  const System start = test::filled(200, 0.45, {0.5e-3}, 0.2, 100);
  System moved = start;
  for (std::size_t i = 0; i < start.count(); ++i) {
    moved.position[i].z() += start.cell.size.z() / 2;
    moved.velocity[i].x() += start.cell.shear_rate * start.cell.size.z() / 2;
    wrap(moved.cell, moved.position[i], moved.velocity[i]);
  }
  const DemSetup setup = pressed(test::rough(1e7, 0.7, 0.1, 0.5e-3), 3e3);
  Dem one(start, setup), other(moved, setup);
  for (Dem* dem : {&one, &other}) dem->advance(300);
  const System a = one.system(), b = other.system();
  EXPECT_GT(one.totals().contact_starts, 100);
  EXPECT_LT(a.cell.size.z(), 0.995 * start.cell.size.z());
  EXPECT_NEAR(a.cell.size.z(), b.cell.size.z(), 1e-9 * a.cell.size.z());
  for (std::size_t i = 0; i < a.count(); ++i) {
    const Eigen::Vector3d u = a.velocity[i] - mean_flow(a.cell, a.position[i].z()),
                          v = b.velocity[i] - mean_flow(b.cell, b.position[i].z());
    EXPECT_LT((u - v).norm(), 1e-7);
  }
}

TEST(ConfinedShear, NeedsPeriodicFacesAndRoom) {
  const DemSetup setup = pressed(test::smooth(1e7, 0.8, 0.1, 0.5e-3), 100);
  EXPECT_THAT([&] { Dem(test::filled(100, 0.2, {0.5e-3}, 0.2, 0, Boundary::wall), setup); },
              testing::ThrowsMessage<InputError>("a height that follows the pressure needs periodic faces all around and no gravity"));
  Dem dem(test::filled(8, 0.2, {0.5e-3}, 0.01, 10), pressed(setup, 1e4));
  EXPECT_THAT(
      [&] { dem.advance(1'000'000); },
      testing::ThrowsMessage<WorkError>(testing::HasSubstr("so that a sphere could meet two images of another; allowed: above 0.002 m")));
}

}  // namespace
}  // namespace scalebreak

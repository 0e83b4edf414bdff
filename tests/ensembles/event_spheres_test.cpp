#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/queue/reference_queue.hpp>
#include <scalebreak/ensembles/event/rules/constant_restitution.hpp>
#include <scalebreak/start/check_overlap.hpp>

#include "dem/flows.hpp"

namespace scalebreak {
namespace {

using Smooth = EventSpheres<CalendarQueue, SmoothRule>;
using Rough = EventSpheres<CalendarQueue, RoughRule>;
constexpr double radius = 0.5e-3, speed = 0.1;

/// The deepest overlap of two surfaces over the sum of their radii.
double deepest_overlap(const System& system) { return -least_gap_ratio(system, 0.0); }

void expect_same(const System& a, const System& b) {
  ASSERT_EQ(a.count(), b.count());
  EXPECT_EQ(a.time, b.time);
  for (std::size_t i = 0; i < a.count(); ++i) {
    ASSERT_EQ(a.position[i], b.position[i]) << i;
    ASSERT_EQ(a.velocity[i], b.velocity[i]) << i;
    ASSERT_EQ(a.spin[i], b.spin[i]) << i;
  }
}

/// Two spheres on their way to each other, in a cell of 20 radii.
System pair_of_spheres(const Eigen::Vector3d& apart, const Eigen::Vector3d& velocity) {
  System system;
  system.cell.size = Eigen::Vector3d::Constant(20 * radius);
  system.radius = {radius, radius};
  system.mass = {sphere_mass(radius, 2500), sphere_mass(radius, 2500)};
  system.material = {0, 0};
  system.position = {0.4 * system.cell.size, 0.4 * system.cell.size + apart};
  system.velocity = {velocity, Eigen::Vector3d::Zero()};
  system.spin.assign(2, Eigen::Vector3d::Zero());
  return system;
}

TEST(EventPair, MeetsWhenItsDistanceIsTheSumOfRadii) {
  Smooth flow(pair_of_spheres({4 * radius, 0, 0}, {speed, 0, 0}), {}, {0.5});
  const double meets = 2 * radius / speed;
  flow.advance_to(0.999 * meets);
  EXPECT_EQ(flow.totals().collisions, 0);
  flow.advance_to(1.5 * meets);
  EXPECT_EQ(flow.totals().collisions, 1);
  const System after = flow.system();
  EXPECT_NEAR(after.velocity[0].x(), 0.25 * speed, 1e-15);
  EXPECT_NEAR(after.velocity[1].x(), 0.75 * speed, 1e-15);
  EXPECT_NEAR(after.position[1].x() - after.position[0].x(), 2 * radius + 0.5 * speed * 0.5 * meets, 1e-15);
  EXPECT_NEAR(flow.totals().dissipated, 0.75 * sphere_mass(radius, 2500) / 4 * speed * speed, 1e-22);
  EXPECT_NEAR(flow.totals().contact_moment(0, 0), sphere_mass(radius, 2500) * 0.75 * speed * 2 * radius, 1e-20);
}

TEST(EventPair, MeetsAcrossEachPeriodicFace) {
  for (const int axis : {0, 1, 2}) {
    for (const double sign : {-1.0, 1.0}) {
      System start = pair_of_spheres(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
      start.position = {Eigen::Vector3d::Constant(10 * radius), Eigen::Vector3d::Constant(10 * radius)};
      start.position[0][axis] = sign > 0 ? 18 * radius : 2 * radius;
      start.position[1][axis] = sign > 0 ? 2 * radius : 18 * radius;
      start.velocity[0][axis] = sign * speed;
      Smooth flow(start, {}, {1.0});
      flow.advance_to(1.99 * radius / speed);
      EXPECT_EQ(flow.totals().collisions, 0);
      flow.advance_to(2.01 * radius / speed);
      EXPECT_EQ(flow.totals().collisions, 1) << axis;
      EXPECT_NEAR(flow.system().velocity[1][axis], sign * speed, 1e-15);
    }
  }
}

TEST(EventPair, ThatOverlapsByRoundingMeetsAtOnceIfItApproachesAndNotIfItParts) {
  const double almost = 2 * radius * (1 - 1e-14);
  Smooth approaching(pair_of_spheres({almost, 0, 0}, {speed, 0, 0}), {}, {1.0});
  approaching.advance_to(1e-6 * radius / speed);
  EXPECT_EQ(approaching.totals().collisions, 1);
  Smooth parting(pair_of_spheres({almost, 0, 0}, {-speed, 0, 0}), {}, {1.0});
  parting.advance_to(radius / speed);
  EXPECT_EQ(parting.totals().collisions, 0);
}

TEST(EventPair, OfRoughSpheresKeepsItsAngularMomentumAndTurnsItsSliding) {
  System start = pair_of_spheres({4 * radius, 0.7 * radius, 0.3 * radius}, {speed, 0.02, 0});
  start.spin = {{10, -30, 50}, {-70, 20, 40}};
  Rough flow(start, {}, {0.8, 0.6});
  flow.advance_to(2 * radius / speed * 1.5);
  ASSERT_EQ(flow.totals().collisions, 1);
  const System end = flow.system();
  const auto angular = [&](const System& s) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::size_t i : {0, 1}) sum += s.mass[i] * s.position[i].cross(s.velocity[i]) + s.inertia(i) * s.spin[i];
    return sum;
  };
  EXPECT_LT((angular(end) - angular(start)).norm(), 1e-12 * angular(start).norm());
  EXPECT_LT((end.velocity[0] + end.velocity[1] - start.velocity[0] - start.velocity[1]).norm(), 1e-15);
  const auto energy = [](const System& s) { return test::kinetic_energy_about_flow(s); };
  EXPECT_NEAR(energy(start) - energy(end), flow.totals().dissipated, 1e-12 * energy(start));
}

TEST(EventGasOfElasticSpheres, KeepsEnergyAndMomentumAndNeverOverlaps) {
  for (const double volume_fraction : {0.1, 0.5}) {
    const System start = test::filled(2000, volume_fraction, {radius}, speed);
    Smooth flow(start, {}, {1.0});
    double deepest = 0;
    for (int look = 0; look < 20; ++look) {
      flow.advance_collisions(22'000);
      deepest = std::max(deepest, deepest_overlap(flow.system()));
    }
    const System end = flow.system();
    EXPECT_LT(deepest, 1e-12) << volume_fraction;
    EXPECT_NEAR(test::kinetic_energy_about_flow(end) / test::kinetic_energy_about_flow(start), 1, 1e-12);
    EXPECT_LT(test::momentum_of(end).norm(), 1e-12 * start.mass[0] * speed * 2000);
    EXPECT_GT(flow.totals().renewals, 0);  // times were rebased on the way
  }
}

TEST(EventGasOfElasticSpheres, OfManySizesNeverOverlaps) {
  const System start = test::filled(3000, 0.4, {radius, 2 * radius, 0.6 * radius, radius, 0.5 * radius}, speed);
  Smooth flow(start, {}, {1.0});
  double deepest = 0;
  for (int look = 0; look < 20; ++look) {
    flow.advance_collisions(10'000);
    deepest = std::max(deepest, deepest_overlap(flow.system()));
  }
  EXPECT_LT(deepest, 1e-12);
  EXPECT_NEAR(test::kinetic_energy_about_flow(flow.system()) / test::kinetic_energy_about_flow(start), 1, 1e-12);
}

TEST(EventGasOfElasticSpheres, GoesTheWayBackWhenVelocitiesAreReversed) {
  const System start = test::filled(1000, 0.3, {radius}, speed);
  Smooth there(start, {}, {1.0});
  there.advance_collisions(2000);  // four a sphere: rounding grows by about ten in each
  System turned = there.system();
  const double time = turned.time;
  for (Eigen::Vector3d& velocity : turned.velocity) velocity = -velocity;
  Smooth back(turned, {}, {1.0});
  back.advance_to(2 * time);
  EXPECT_EQ(back.totals().collisions, 2000);
  const System end = back.system();
  double farthest = 0;
  for (std::size_t i = 0; i < start.count(); ++i)
    farthest = std::max(farthest, nearest_image(start.cell, end.position[i] - start.position[i]).norm());
  EXPECT_LT(farthest, 1e-6 * radius);
}

/// The same bits by the fast queue and the plain one, with and without looks on the way, and through a saved state.
template <class Rule>
void expect_one_path(const System& start, const EventSetup& setup, const Rule& rule, double time) {
  EventSpheres<CalendarQueue, Rule> fast(start, setup, rule), looked_at(start, setup, rule);
  EventSpheres<ReferenceQueue, Rule> plain(start, setup, rule);
  fast.advance_to(time);
  plain.advance_to(time);
  for (int look = 1; look < 7; ++look) looked_at.advance_to(look * time / 7.3), (void)looked_at.system();
  looked_at.advance_to(time);
  EXPECT_GT(fast.totals().collisions, static_cast<long>(3 * start.count()));
  EXPECT_EQ(fast.totals().collisions, plain.totals().collisions);
  expect_same(fast.system(), plain.system());
  expect_same(fast.system(), looked_at.system());
  EventSpheres<CalendarQueue, Rule> left(start, setup, rule);
  left.advance_to(0.37 * time);
  EventSpheres<CalendarQueue, Rule> resumed(left.save(), setup, rule);
  resumed.advance_to(time);
  expect_same(fast.system(), resumed.system());
  EXPECT_EQ(fast.totals().contact_moment, resumed.totals().contact_moment);
  EXPECT_EQ(fast.totals().lists, resumed.totals().lists);
}

TEST(EventSpheresAreTheSameBits, InAnElasticGas) { expect_one_path(test::filled(500, 0.3, {radius}, speed), {}, SmoothRule{1.0}, 0.1); }

TEST(EventSpheresAreTheSameBits, InAShearedGasOfRoughSpheresOfTwoSizes) {
  expect_one_path(test::filled(500, 0.4, {radius, 1.5 * radius}, speed, 40), {}, RoughRule{0.9, 0.3}, 0.1);
}

TEST(EventLists, OfAnyLengthGiveTheSamePath) {
  // To rounding, as paths are brought up at other times.
  const System start = test::filled(500, 0.3, {radius}, speed, 40);
  Smooth narrow(start, {.allowance = 0.1 * radius}, {0.9}), wide(start, {.allowance = 0.9 * radius}, {0.9});
  narrow.advance_to(0.01), wide.advance_to(0.01);
  EXPECT_EQ(narrow.totals().collisions, wide.totals().collisions);
  EXPECT_GT(narrow.totals().lists, 2 * wide.totals().lists);
  const System a = narrow.system(), b = wide.system();
  for (std::size_t i = 0; i < a.count(); ++i) ASSERT_LT((a.velocity[i] - b.velocity[i]).norm(), 1e-6 * speed);
}

TEST(EventCell, ThatIsTooShortForItsListsIsRefused) {
  System start = pair_of_spheres({3 * radius, 0, 0}, {speed, 0, 0});
  start.cell.size.y() = 4.01 * radius;
  EXPECT_THROW(Smooth(start, {}, {1.0}), InputError);
}

}  // namespace
}  // namespace scalebreak

#include <cmath>

#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/rules/constant_restitution.hpp>
#include <scalebreak/start/check_overlap.hpp>

#include "dem/flows.hpp"

// Hard spheres in a sheared cell, under gravity, and between walls.

namespace scalebreak {
namespace {

using Smooth = EventSpheres<CalendarQueue, SmoothRule>;
using Rough = EventSpheres<CalendarQueue, RoughRule>;
constexpr double radius = 0.5e-3, speed = 0.1;

System spheres(const std::vector<Eigen::Vector3d>& position, const std::vector<Eigen::Vector3d>& velocity) {
  System system;
  system.cell.size = Eigen::Vector3d::Constant(20 * radius);
  system.position = position, system.velocity = velocity;
  system.radius.assign(position.size(), radius);
  system.mass.assign(position.size(), sphere_mass(radius, 2500));
  system.material.assign(position.size(), 0);
  system.spin.assign(position.size(), Eigen::Vector3d::Zero());
  return system;
}

TEST(EventShear, CarriesTheImageAboveAlong) {
  // The upper sphere rises through the face and comes back below, slower by shear_rate × height, and displaced by the offset.
  System start = spheres({{3 * radius, radius, 19.5 * radius}, {radius, 15 * radius, 10 * radius}}, {{speed, 0, speed}, {0, 0, 0}});
  start.cell.shear_rate = 10;
  start.cell.shear_offset = 2 * radius;
  Smooth flow(start, {}, {1.0});
  const double time = 2 * radius / speed;
  flow.advance_to(time);
  const System end = flow.system();
  const double passing = 10 * 20 * radius;
  EXPECT_NEAR(end.cell.shear_offset, 2 * radius + passing * time, 1e-15);
  EXPECT_NEAR(end.velocity[0].x(), speed - passing, 1e-15);
  EXPECT_NEAR(end.position[0].z(), 1.5 * radius, 1e-15);
  EXPECT_NEAR(end.position[0].x(), 3 * radius + speed * time - end.cell.shear_offset, 1e-15);
}

TEST(EventShear, MeetsTheImageThatPassesAbove) {
  // At rest one diameter and a half apart across the face: the image comes along and pushes.
  System start = spheres({{10 * radius, 10 * radius, 0.5 * radius}, {4 * radius, 10 * radius, 19 * radius}}, {{0, 0, 0}, {0, 0, 0}});
  start.cell.shear_rate = -10;
  Smooth flow(start, {}, {1.0});
  // Seen from the first, the second is at −1.5 r along z, moving at +passing along x: it meets where the distance is 2 r.
  const double passing = 10 * 20 * radius, meets = (6 - std::sqrt(4 - 1.5 * 1.5)) * radius / passing;
  flow.advance_to(meets * (1 - 1e-9));
  EXPECT_EQ(flow.totals().collisions, 0);
  flow.advance_to(meets * (1 + 1e-9));
  ASSERT_EQ(flow.totals().collisions, 1);
  const double along = std::sqrt(1 - 0.75 * 0.75);  // of the normal
  EXPECT_NEAR(flow.system().velocity[0].x(), passing * along * along, 1e-12 * passing);
  EXPECT_NEAR(flow.system().velocity[0].z(), passing * along * 0.75, 1e-12 * passing);
}

TEST(EventShear, NeverOverlapsOverAnyStrainAndBalancesItsEnergy) {
  const double shear_rate = 60, restitution = 0.8;
  const System start = test::filled(1500, 0.4, {radius, 1.4 * radius}, speed, shear_rate);
  Smooth flow(start, {}, {restitution});
  const double step = 0.002 / shear_rate;
  double deepest = 0, kinetic_moment = 0;
  const auto kinetic = [&](const System& system) {
    double sum = 0;
    for (std::size_t i = 0; i < system.count(); ++i) {
      const Eigen::Vector3d own = system.velocity[i] - mean_flow(system.cell, system.position[i].z());
      sum += system.mass[i] * own.x() * own.z();
    }
    return sum;
  };
  double last = kinetic(start);
  for (int k = 1; k <= 1500; ++k) {  // a strain of 3: the images pass each other three times
    flow.advance_to(k * step);
    const System now = flow.system();
    const double next = kinetic(now);
    kinetic_moment += step * (last + next) / 2;
    last = next;
    if (k % 50 == 0) deepest = std::max(deepest, -least_gap_ratio(now, 0.0));
  }
  EXPECT_LT(deepest, 1e-12);
  EXPECT_GT(flow.totals().collisions, 20'000);
  const System end = flow.system();
  const double gain = test::kinetic_energy_about_flow(end) - test::kinetic_energy_about_flow(start);
  const double work = -shear_rate * (flow.totals().contact_moment(0, 2) + kinetic_moment);
  EXPECT_NEAR(gain, work - flow.totals().dissipated, 1e-3 * work);  // what is sampled of the kinetic part
  double size = 0;
  for (std::size_t i = 0; i < end.count(); ++i) size += end.mass[i] * end.velocity[i].norm();
  EXPECT_LT(test::momentum_of(end).norm(), 1e-10 * size);
}

TEST(EventShear, NeverOverlapsInAThinGasWhileImagesPassManyTimes) {
  // Few collisions between two renewals, so that lists are made far from where the cell was at the last.
  const double shear_rate = 60;
  const System start = test::filled(300, 0.1, {radius}, speed, shear_rate);
  Smooth flow(start, {}, {0.9});
  double deepest = 0;
  for (int k = 1; k <= 600; ++k) {
    flow.advance_to(k * 0.02 / shear_rate);
    deepest = std::max(deepest, -least_gap_ratio(flow.system(), 0.0));
  }
  EXPECT_LT(deepest, 1e-12);
  EXPECT_GT(flow.totals().renewals, 2);
}

System box(std::size_t count, double volume_fraction) {
  Filling filling;
  filling.radius.assign(count, radius);
  filling.mass.assign(count, sphere_mass(radius, 2500));
  filling.material.assign(count, 0);
  filling.cell.size = Eigen::Vector3d::Constant(std::cbrt(static_cast<double>(count) * sphere_mass(radius, 1.0) / volume_fraction));
  filling.cell.boundary.fill(Boundary::wall);
  filling.speed = speed;
  return fill(filling);
}

TEST(EventGravity, LetsASphereBounceOnParabolas) {
  System start = spheres({{10 * radius, 10 * radius, 11 * radius}, {3 * radius, 3 * radius, 12 * radius}}, {{0.02, 0, 0}, {0, 0, 0.2}});
  start.cell.boundary[2] = Boundary::wall;
  const double g = 9.81, e = 0.8;
  Smooth flow(start, {.gravity = {0, 0, -g}}, {e});
  const double falls = std::sqrt(2 * 10 * radius / g), rises = e * falls;
  flow.advance_to(falls + rises);  // to the top of its first leap
  EXPECT_NEAR(flow.system().position[0].z(), radius + e * e * 10 * radius, 1e-12);
  EXPECT_NEAR(flow.system().velocity[0].z(), 0, 1e-12);
  EXPECT_NEAR(flow.system().velocity[0].x(), 0.02, 1e-15);
  const double impulse = start.mass[0] * (1 + e) * g * falls;
  EXPECT_NEAR(flow.totals().contact_moment(2, 2), impulse * radius, 1e-12 * impulse * radius);  // the other one falls later
  flow.advance_to(falls + 2 * rises + e * rises);
  EXPECT_NEAR(flow.system().position[0].z(), radius + std::pow(e, 4) * 10 * radius, 1e-12);
}

TEST(EventGravity, SaysThatASphereComesToRestWhereEventsDoNotEnd) {
  System start = spheres({{10 * radius, 10 * radius, 11 * radius}, {3 * radius, 3 * radius, 12 * radius}}, {{0, 0, 0}, {0, 0, 0}});
  start.cell.boundary[2] = Boundary::wall;
  Smooth flow(start, {.gravity = {0, 0, -9.81}}, {0.5});
  EXPECT_THROW(flow.advance_to(1.0), WorkError);
  EXPECT_LT(flow.time(), 0.11);  // √(2h/g) (1 + e)/(1 − e) of the higher one
}

TEST(EventGravity, KeepsTheEnergyOfAnElasticBoxAndItsSpheresInside) {
  const System start = box(400, 0.2);
  const Eigen::Vector3d gravity(0.3, -0.2, -4);
  Smooth flow(start, {.gravity = gravity}, {1.0});
  const auto energy = [&](const System& system) {
    double sum = 0;
    for (std::size_t i = 0; i < system.count(); ++i)
      sum += system.mass[i] * (system.velocity[i].squaredNorm() / 2 - gravity.dot(system.position[i]));
    return sum;
  };
  double deepest = 0;
  for (int look = 0; look < 100; ++look) {
    flow.advance_collisions(1000);
    deepest = std::max(deepest, -least_gap_ratio(flow.system(), 0.0));
  }
  EXPECT_GT(flow.totals().wall_collisions, 10'000);
  EXPECT_LT(deepest, 1e-11);
  EXPECT_NEAR(energy(flow.system()) / energy(start), 1, 1e-11);
}

TEST(EventWalls, ThatMoveDoTheWorkThatTheFlowLoses) {
  System start = test::filled(800, 0.3, {radius}, speed, 0, Boundary::wall);
  start.cell.wall_speed = 0.2;
  Rough flow(start, {}, {0.9, 0.2});
  flow.advance_to(0.3);
  const System end = flow.system();
  const auto energy = [](const System& system) {
    double sum = 0;
    for (std::size_t i = 0; i < system.count(); ++i)
      sum += system.mass[i] / 2 * system.velocity[i].squaredNorm() + system.inertia(i) / 2 * system.spin[i].squaredNorm();
    return sum;
  };
  EXPECT_GT(flow.totals().wall_collisions, 500);
  EXPECT_GT(flow.totals().wall_work, 0);
  EXPECT_NEAR(energy(end) - energy(start), flow.totals().wall_work - flow.totals().dissipated, 1e-9 * flow.totals().dissipated);
  EXPECT_LT(-least_gap_ratio(end, 0.0), 1e-12);
  // The flow has been taken along: above to the right, below to the left.
  double sheared = 0;
  for (std::size_t i = 0; i < end.count(); ++i) sheared += end.velocity[i].x() * (end.position[i].z() / end.cell.size.z() - 0.5);
  EXPECT_GT(sheared, 0);
}

}  // namespace
}  // namespace scalebreak

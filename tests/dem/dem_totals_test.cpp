#include <gtest/gtest.h>

#include "dem/flows.hpp"
#include "dem/scenes.hpp"

// What the engine adds up on the way, against what its state says.

namespace scalebreak {
namespace {

TEST(Totals, AreTheSumsOverEveryStep) {
  for (const Boundary along_z : {Boundary::periodic, Boundary::wall}) {
    System start = test::filled(200, 0.4, {0.5e-3}, 0.2, along_z == Boundary::wall ? 0 : 100, along_z);
    if (along_z == Boundary::wall) start.cell.wall_speed = 0.5;
    const DemSetup setup = test::rough(1e7, 0.8, 0.15, 0.5e-3);
    Dem dem(start, setup);
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    double contact_time = 0, wall_work = 0;
    for (int step = 0; step < 400; ++step) {
      dem.advance(1);
      for (const ContactForce& contact : dem.contact_forces()) {
        const bool wall = contact.second < 0;
        moment -= setup.step * contact.force * contact.branch.transpose();
        contact_time += setup.step * (wall ? 0.5 : 1.0);
        if (wall) wall_work += setup.step * contact.force.x() * (contact.second == wall_number(2, true) ? 0.5 : -0.5);
      }
    }
    EXPECT_GT(contact_time, 100 * setup.step);
    EXPECT_NEAR(dem.totals().contact_time / contact_time, 1, 1e-10);
    EXPECT_LT((dem.totals().contact_moment - moment).norm(), 1e-9 * moment.norm());
    EXPECT_NEAR(dem.totals().wall_work, wall_work, 1e-9 * std::abs(wall_work));
    EXPECT_EQ(wall_work != 0, along_z == Boundary::wall);
  }
}

/// One sphere that falls on a wall which moves along x at ∓1 m/s.
System on_a_moving_wall() {
  System system;
  system.cell.size = Eigen::Vector3d::Constant(10e-3);
  system.cell.boundary[2] = Boundary::wall;
  system.cell.wall_speed = 1;
  system.radius = {0.5e-3};
  system.mass = {sphere_mass(0.5e-3, 2500)};
  system.material = {0};
  system.position = {{5e-3, 5e-3, 0.6e-3}};
  system.velocity = {{0, 0, -0.1}};
  system.spin = {{0, 300, 0}};
  return system;
}

TEST(MovingWall, DoesAsMuchWorkAsItGivesMomentum) {
  const System start = on_a_moving_wall();
  Dem dem(start, test::rough(1e7, 0.8, 0.05, 0.5e-3));
  const System end = test::after_contact(dem);
  const double momentum = end.mass[0] * end.velocity[0].x();  // all of it from the wall, which moves at −1 m/s
  EXPECT_LT(momentum, 0);
  EXPECT_NEAR(dem.totals().wall_work / (-1 * momentum), 1, 1e-10);
  EXPECT_EQ(dem.totals().contact_starts, 0.5);
}

TEST(MovingWall, WithoutSlipStopsSpins) {
  DemSetup setup = test::rough(1e7, 0.8, 0.05, 0.5e-3);
  EXPECT_NE(test::after_contact(*std::make_unique<Dem>(on_a_moving_wall(), setup)).spin[0].y(), 0);
  setup.wall_no_slip = true;
  EXPECT_EQ(test::after_contact(*std::make_unique<Dem>(on_a_moving_wall(), setup)).spin[0].y(), 0);
}

/// |e − the restitution put in| of a damped Hertz pair, the mean over where in a step it touches.
double restitution_error(Integrator integrator, double fraction) {
  Input input;
  input.contact = {NormalModel::hertz, AdhesionRange::touch, DampingOn::overlap};
  for (Material* material : {&input.material, &input.second}) material->surface_energy = 0, material->restitution = 0.5;
  DemSetup setup = test::setup_of(input, fraction);
  setup.integrator = integrator;
  double mean = 0;
  for (int k = 0; k < 20; ++k) {
    System start = bodies_start(input);
    start.position[0] -= k / 20.0 * setup.step * start.velocity[0];
    Dem dem(start, setup);
    const System end = test::after_contact(dem);
    mean += (end.velocity[0] - end.velocity[1]).z() / input.normal_speed / 20;
  }
  return std::abs(mean - 0.5);
}

TEST(SynchronizedVelocity, IsOfSecondOrderWhereTheLaggedOneIsOfFirst) {
  const double lagged = restitution_error(Integrator::verlet, 0.1), fresh = restitution_error(Integrator::verlet_synchronized, 0.1);
  EXPECT_NEAR(restitution_error(Integrator::verlet, 0.4) / lagged, 4, 1);
  EXPECT_NEAR(restitution_error(Integrator::verlet_synchronized, 0.4) / fresh, 16, 4);
  EXPECT_LT(fresh, lagged / 3);
}

}  // namespace
}  // namespace scalebreak

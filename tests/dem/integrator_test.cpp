#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dem/scenes.hpp"

// What a step makes of forces that depend on velocities, lagged and synchronized.

namespace scalebreak {
namespace {

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
  const double lagged = restitution_error(Integrator::verlet, 0.1), fresh = restitution_error(Integrator::synchronized, 0.1);
  EXPECT_NEAR(restitution_error(Integrator::verlet, 0.4) / lagged, 4, 1);
  EXPECT_NEAR(restitution_error(Integrator::synchronized, 0.4) / fresh, 16, 4);
  EXPECT_LT(fresh, lagged / 3);
}

/// A small sphere rolls around the waist of two large ones that touch and do not move, held by adhesion: it keeps its speed and its
/// distance from their axis for ever. This is the pocket of Vyas et al., Comput. Phys. Commun. 310 (2025) 109524, section 4, closed.
struct WaistRoller {
  double large = 5e-3, small;  ///< radii [m]
  double speed = 0.05;         ///< [m/s]
  DemSetup setup;
  double waist;  ///< distance of the small one from the axis [m]

  WaistRoller(double size_ratio, Integrator integrator) : small(large / size_ratio) {
    setup.contact = {NormalModel::jkr, AdhesionRange::full, DampingOn::contact_radius};
    setup.surface = {.tangential = TangentialModel::mindlin, .tangential_radius = DampingOn::contact_radius};
    for (Material* material : {&setup.material, &setup.second}) {
      material->young = 1e7, material->restitution = 0.5, material->sliding_friction = 0.5;
    }
    setup.second.density = 1e15;  // so that they stay where they are
    setup.step = 0.15 * rayleigh_step(setup, small);
    setup.integrator = integrator;
    const double apart = large + small - 3e-7;  // about where adhesion and elasticity balance
    waist = std::sqrt(apart * apart - large * large);
  }

  [[nodiscard]] System start() const {
    System system;
    system.cell.size = Eigen::Vector3d::Constant(6 * large);
    system.cell.boundary = {Boundary::open, Boundary::open, Boundary::open};
    const Eigen::Vector3d middle = system.cell.size / 2, along_axis(large, 0, 0);
    system.position = {middle - along_axis, middle + along_axis, middle + Eigen::Vector3d(0, 0, waist)};
    system.velocity = {{0, 0, 0}, {0, 0, 0}, {0, speed, 0}};
    system.spin = {{0, 0, 0}, {0, 0, 0}, {-speed * (large + small) / (waist * small), 0, 0}};
    system.radius = {large, large, small};
    system.material = {1, 1, 0};
    for (std::size_t i = 0; i < 3; ++i)
      system.mass.push_back(sphere_mass(system.radius[i], system.material[i] == 1 ? setup.second.density : setup.material.density));
    return system;
  }

  /// By how much it has come nearer to the axis over a turn, once it has settled for half of one [m].
  [[nodiscard]] double sinks_in_a_turn() const {
    Dem dem(start(), setup);
    const long turn = std::lround(2 * std::numbers::pi * waist / speed / setup.step);
    const auto distance = [&] {
      const System now = dem.system();
      const Eigen::Vector3d from_axis = now.position[2] - (now.position[0] + now.position[1]) / 2;
      return std::hypot(from_axis.y(), from_axis.z());
    };
    dem.advance(turn / 2);
    const double before = distance();
    dem.advance(turn);
    return before - distance();
  }
};

/// A step sees the contact turn by v dt/ρ and, lagged, the velocity before half of that turn: a creep v² dt/(2ρ) across the path that is
/// not there, which friction without slip turns into motion. Where the wedge is flatter than friction holds (waist / large radius < μ)
/// nothing pushes it out again. Over a turn that is π v dt.
TEST(SmallSphereBetweenLargeOnes, IsPulledInByALaggedVelocityAndNotByASynchronizedOne) {
  const WaistRoller lagged(10, Integrator::verlet), fresh(10, Integrator::synchronized);
  ASSERT_LT(lagged.waist / lagged.large, lagged.setup.material.sliding_friction);
  const double creep = std::numbers::pi * lagged.speed * lagged.setup.step;
  EXPECT_NEAR(lagged.sinks_in_a_turn() / creep, 1, 0.15);
  EXPECT_LT(std::abs(fresh.sinks_in_a_turn()), 1e-2 * creep);
}

TEST(SmallSphereBetweenLargeOnes, OfASteepWedgeSlidesBackOutInsteadOfSinking) {
  const WaistRoller lagged(2, Integrator::verlet);
  ASSERT_GT(lagged.waist / lagged.large, lagged.setup.material.sliding_friction);
  EXPECT_LT(std::abs(lagged.sinks_in_a_turn()), 0.2 * std::numbers::pi * lagged.speed * lagged.setup.step);
}

}  // namespace
}  // namespace scalebreak

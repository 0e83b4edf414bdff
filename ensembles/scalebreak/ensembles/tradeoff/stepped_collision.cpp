#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/dem/dem.hpp>
#include <scalebreak/dem/law_rows.hpp>
#include <scalebreak/ensembles/engine/bodies_start.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>

namespace scalebreak {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr double rounding = 1e-12;  ///< of a number of steps that is whole

/// After twice the time of the exact motion, and a few steps, something that acts still acts for ever.
long most_steps(long expected) { return 2 * expected + 10; }

/// How long ago two that have parted did, on the straight lines on which they fly [s].
double flown_since_separation(const System& end, const MappedLaws& laws, bool wall) {
  const double touch = end.radius[0] + (wall ? 0 : end.radius[1]) + dem::hold_of(laws);
  if (wall) return (end.position[0].z() - touch) / end.velocity[0].z();
  const Eigen::Vector3d apart = end.position[0] - end.position[1], speed = end.velocity[0] - end.velocity[1];
  const double along = apart.dot(speed), square = speed.squaredNorm();
  return (along - std::sqrt(along * along - square * (apart.squaredNorm() - touch * touch))) / square;
}

}  // namespace

double step_of(const CollisionScene& scene, double step_fraction) {
  double smallest = scene.moving.bodies.front().radius;
  for (const MovingBody& body : scene.moving.bodies) {
    if (!body.plane) smallest = std::min(smallest, body.radius);
  }
  return step_fraction * rayleigh_step(dem_setup(scene.input, 0, 1), smallest);
}

SteppedStart stepped_start(const CollisionScene& scene, Integrator integrator, double step, double phase) {
  const double time = scene.duration > 0 ? scene.duration : scene.reference.time;
  const long steps = std::max(1L, static_cast<long>(std::ceil(phase + time / step * (1 - rounding))));
  SteppedStart start{.system = bodies_start(scene.input), .setup = dem_setup(scene.input, step, 1), .steps = steps};
  if (scene.duration > 0) start.setup.step = time / (static_cast<double>(steps) - phase);
  start.setup.integrator = integrator;
  for (std::size_t i = 0; i < start.system.count(); ++i) start.system.position[i] -= phase * start.setup.step * start.system.velocity[i];
  return start;
}

CollisionOutcome step_collision(const CollisionScene& scene, Integrator integrator, double step, double phase) {
  const SteppedStart start = stepped_start(scene, integrator, step, phase);
  Dem dem(start.system, start.setup);
  dem.keep_sums(false);
  CollisionOutcome outcome{.bodies = scene.moving.bodies};
  const auto advance = [&](long by) {
    const auto began = Clock::now();
    dem.advance(by);
    outcome.seconds += seconds_since(began);
  };
  advance(start.steps);
  const auto acts = [&] { return !dem.contact_forces().empty(); };
  if (scene.duration == 0) {
    while (acts() && dem.steps() < most_steps(start.steps)) advance(1);
    outcome.parted = !acts();
  }
  const System end = dem.system();
  for (std::size_t i = 0; i < end.count(); ++i) outcome.bodies[i].velocity = end.velocity[i], outcome.bodies[i].spin = end.spin[i];
  const bool wall = scene.moving.bodies.back().plane;
  outcome.force_evaluations = std::round(dem.totals().contact_time / start.setup.step * (wall ? 2 : 1));
  const MappedLaws& laws = scene.moving.laws.front();
  if (scene.moving.bodies.size() == 2 && scene.duration == 0 && outcome.parted && !laws.laws.liquid.bridges())
    outcome.contact_time = dem.time() - flown_since_separation(end, laws, wall) - phase * start.setup.step - scene.reference.first_touch;
  return outcome;
}

CollisionOutcome move_collision(const CollisionScene& scene, double tolerance, Stepper stepper) {
  const auto began = Clock::now();
  const MotionOutcome end = scene.moving.move({.tolerance = tolerance, .stepper = stepper, .duration = scene.duration});
  CollisionOutcome outcome{.bodies = end.bodies, .force_evaluations = static_cast<double>(end.force_evaluations)};
  outcome.seconds = seconds_since(began);
  outcome.parted = scene.duration > 0 || end.open_contacts == 0;
  if (scene.moving.bodies.size() == 2 && end.last_separation > 0 && !scene.moving.laws.front().laws.liquid.bridges())
    outcome.contact_time = end.last_separation - end.first_touch;
  return outcome;
}

}  // namespace scalebreak

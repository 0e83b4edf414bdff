#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <scalebreak/ensembles/tradeoff/closed_form_collision.hpp>
#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>
#include <scalebreak/ensembles/tradeoff/tabulated_collision.hpp>

namespace scalebreak {
namespace {

constexpr double step_spread = 0.1;  ///< of the steps of the phases, from the shortest to the longest

CollisionMethod by_steps(Method word, Integrator integrator) {
  return {.word = word,
          .setting = "step_fraction",
          .steps = true,
          .settings = [](const TradeoffInput& input) { return input.step_fractions; },
          .prepare =
              [integrator](const CollisionScene& scene, double fraction, const TableStore&) {
                return PreparedCollision{.resolve = [integrator, &scene, step = step_of(scene, fraction)](double stretch, double phase) {
                  return step_collision(scene, integrator, stretch * step, phase);
                }};
              }};
}

std::vector<double> tolerances(const TradeoffInput& input) { return input.tolerances; }

CollisionMethod exactly(Method word, Stepper stepper) {
  return {.word = word,
          .setting = "tolerance",
          .settings = tolerances,
          .prepare = [stepper](const CollisionScene& scene, double tolerance, const TableStore&) {
            return PreparedCollision{
                .resolve = [stepper, tolerance, &scene](double, double) { return move_collision(scene, tolerance, stepper); }};
          }};
}

/// The k-th of numbers in [0, 1) that fill it evenly, whatever else is in order of k.
double scattered(int k) {
  const double x = k * std::numbers::phi;
  return x - std::floor(x);
}

/// Of runs that differ in nothing else, and of the one before them: few, if they take long [s].
double fastest(const PreparedCollision& prepared, double seconds) {
  constexpr int most_runs = 32;
  constexpr double enough = 0.1;
  double spent = seconds;
  for (int k = 1; k < most_runs && spent < enough; ++k) {
    const double again = prepared.resolve(1, 0).seconds;
    spent += again, seconds = std::min(seconds, again);
  }
  return seconds;
}

struct RootMeanSquare {
  double squares = 0, largest = 0;
  int count = 0;
  void add(double error) { squares += error * error, largest = std::max(largest, std::abs(error)), ++count; }
  [[nodiscard]] double value() const { return std::sqrt(squares / count); }
};

}  // namespace

const std::vector<CollisionMethod>& collision_methods() {
  static const std::vector<CollisionMethod> methods = {
      by_steps(Method::verlet, Integrator::verlet),
      by_steps(Method::synchronized, Integrator::synchronized),
      exactly(Method::exact, MotionOptions{}.stepper),
      exactly(Method::cash_karp54, Stepper::cash_karp54),
      exactly(Method::dopri5, Stepper::dopri5),
      exactly(Method::dopri5_dense, Stepper::dopri5_dense),
      exactly(Method::bulirsch_stoer, Stepper::bulirsch_stoer),
      {.word = Method::table, .setting = "tolerance", .settings = tolerances, .prepare = tabulated_collision},
      {.word = Method::closed_form,
       .setting = "",
       .settings = [](const TradeoffInput&) { return std::vector<double>{0}; },
       .prepare = [](const CollisionScene& scene, double, const TableStore&) { return closed_form_collision(scene); }},
  };
  return methods;
}

CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting,
                                 const PreparedCollision& prepared, int phases) {
  CollisionPoint point{
      .method = &method, .setting = setting, .step = method.steps ? step_of(scene, setting) : 0, .phases = method.steps ? phases : 1};
  RootMeanSquare motion, time;
  point.seconds = std::numeric_limits<double>::infinity();
  for (int k = 0; k < point.phases; ++k) {
    const CollisionOutcome outcome = prepared.resolve(1 + step_spread * (scattered(k) - 0.5), (k + 0.5) / point.phases);
    const CollisionError error = collision_error(scene, outcome);
    motion.add(error.motion);
    if (error.contact_time) time.add(*error.contact_time);
    point.unparted += !outcome.parted;
    point.energy_mean += error.energy / point.phases;
    point.force_evaluations += outcome.force_evaluations / point.phases;
    point.seconds = std::min(point.seconds, outcome.seconds);
  }
  if (!method.steps) point.seconds = fastest(prepared, point.seconds);
  point.motion_rms = motion.value(), point.motion_largest = motion.largest;
  if (time.count == point.phases) point.time_rms = time.value(), point.time_largest = time.largest;
  return point;
}

CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting, int phases) {
  return measure_collision(scene, method, setting, method.prepare(scene, setting, {}), phases);
}

}  // namespace scalebreak

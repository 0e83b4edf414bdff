#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>

namespace scalebreak {
namespace {

constexpr double step_spread = 0.1;  ///< of the steps of the phases, from the shortest to the longest

CollisionMethod by_steps(Method method, Integrator integrator) {
  return {method, "step_fraction", true, &TradeoffInput::step_fractions,
          [integrator](const CollisionScene& scene, double fraction, double phase) {
            return step_collision(scene, integrator, step_of(scene, fraction), phase);
          }};
}

/// The k-th of numbers in [0, 1) that fill it evenly, whatever else is in order of k.
double scattered(int k) {
  const double x = k * std::numbers::phi;
  return x - std::floor(x);
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
      {Method::exact, "tolerance", false, &TradeoffInput::tolerances,
       [](const CollisionScene& scene, double tolerance, double) { return move_collision(scene, tolerance); }},
  };
  return methods;
}

CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting, int phases) {
  CollisionPoint point{.method = method.method, .setting = setting, .step = method.steps ? step_of(scene, setting) : 0, .phases = phases};
  RootMeanSquare motion, time;
  point.seconds = std::numeric_limits<double>::infinity();
  for (int k = 0; k < phases; ++k) {
    const double stretched = method.steps ? setting * (1 + step_spread * (scattered(k) - 0.5)) : setting;
    const CollisionOutcome outcome = method.resolve(scene, stretched, (k + 0.5) / phases);
    const CollisionError error = collision_error(scene, outcome);
    motion.add(error.motion);
    if (error.contact_time) time.add(*error.contact_time);
    point.unparted += !outcome.parted;
    point.energy_mean += error.energy / phases;
    point.force_evaluations += outcome.force_evaluations / phases;
    point.seconds = std::min(point.seconds, outcome.seconds);
  }
  point.motion_rms = motion.value(), point.motion_largest = motion.largest;
  if (time.count == phases) point.time_rms = time.value(), point.time_largest = time.largest;
  return point;
}

}  // namespace scalebreak

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

CollisionMethod by_steps(const char* name, Method word, Integrator integrator) {
  return {.name = name,
          .word = word,
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
      by_steps("verlet", Method::verlet, Integrator::verlet),
      by_steps("synchronized", Method::synchronized, Integrator::synchronized),
      {.name = "exact",
       .word = Method::exact,
       .setting = "tolerance",
       .settings = tolerances,
       .prepare =
           [](const CollisionScene& scene, double tolerance, const TableStore&) {
             return PreparedCollision{.resolve = [tolerance, &scene](double, double) { return move_collision(scene, tolerance); }};
           }},
      {.name = "table", .word = {}, .setting = "tolerance", .settings = tolerances, .prepare = tabulated_collision},
      {.name = "closed_form",
       .word = {},
       .setting = "",
       .settings = [](const TradeoffInput&) { return std::vector<double>{0}; },
       .prepare = [](const CollisionScene& scene, double, const TableStore&) { return closed_form_collision(scene); }},
  };
  return methods;
}

CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting,
                                 const PreparedCollision& prepared, int phases) {
  CollisionPoint point{.method = &method, .setting = setting, .step = method.steps ? step_of(scene, setting) : 0, .phases = phases};
  RootMeanSquare motion, time;
  point.seconds = std::numeric_limits<double>::infinity();
  for (int k = 0; k < phases; ++k) {
    const CollisionOutcome outcome = prepared.resolve(1 + step_spread * (scattered(k) - 0.5), (k + 0.5) / phases);
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

CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting, int phases) {
  return measure_collision(scene, method, setting, method.prepare(scene, setting, {}), phases);
}

}  // namespace scalebreak

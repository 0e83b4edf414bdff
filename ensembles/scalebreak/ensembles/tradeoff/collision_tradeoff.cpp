#include <scalebreak/ensembles/tradeoff/collision_tradeoff.hpp>

#include <algorithm>

#include <scalebreak/ensembles/tradeoff/front.hpp>
#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>

namespace scalebreak {
namespace {

/// Errors below so many tolerances of the reference say nothing of the method.
constexpr double above_reference = 10;

std::vector<const CollisionMethod*> methods_of(const Input& input) {
  std::vector<const CollisionMethod*> chosen;
  const auto& asked = input.tradeoff.methods;
  for (const CollisionMethod& method : collision_methods()) {
    if (asked.empty() || std::find(asked.begin(), asked.end(), method.method) != asked.end()) chosen.push_back(&method);
  }
  return chosen;
}

CollisionConvergence convergence_of(Method method, const std::vector<CollisionPoint>& points) {
  std::vector<CollisionPoint> own;
  for (const CollisionPoint& point : points) {
    if (point.method == method && point.unparted == 0 && point.motion_rms > above_reference * reference_tolerance) own.push_back(point);
  }
  std::sort(own.begin(), own.end(), [](const CollisionPoint& a, const CollisionPoint& b) { return a.setting < b.setting; });
  own.resize((own.size() + 1) / 2);
  std::vector<double> settings, motion, timed_settings, times;
  for (const CollisionPoint& point : own) {
    settings.push_back(point.setting), motion.push_back(point.motion_rms);
    if (point.time_rms && *point.time_rms > 0) timed_settings.push_back(point.setting), times.push_back(*point.time_rms);
  }
  return {method, convergence_order(settings, motion), convergence_order(timed_settings, times)};
}

}  // namespace

CollisionTradeoff collision_tradeoff(const Input& input, const std::function<void(double)>& progress) {
  const CollisionScene scene = collision_scene(input);
  CollisionTradeoff study{.speed = scene.speed, .rayleigh_step = step_of(scene, 1)};
  if (scene.moving.bodies.size() == 2 && scene.reference.last_separation > 0)
    study.contact_time = scene.reference.last_separation - scene.reference.first_touch;
  const auto methods = methods_of(input);
  std::size_t count = 0;
  for (const CollisionMethod* method : methods) count += (input.tradeoff.*method->settings).size();
  for (const CollisionMethod* method : methods) {
    for (const double setting : input.tradeoff.*method->settings) {
      study.points.push_back(measure_collision(scene, *method, setting, static_cast<int>(input.tradeoff.phases)));
      if (progress) progress(static_cast<double>(study.points.size()) / static_cast<double>(count));
    }
  }
  std::vector<double> costs, errors;
  for (const CollisionPoint& point : study.points) costs.push_back(point.force_evaluations), errors.push_back(point.motion_rms);
  const std::vector<bool> front = on_front(costs, errors);
  for (std::size_t i = 0; i < front.size(); ++i) study.points[i].on_front = front[i];
  for (const CollisionMethod* method : methods) study.convergence.push_back(convergence_of(method->method, study.points));
  return study;
}

}  // namespace scalebreak

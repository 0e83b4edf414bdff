#include <scalebreak/ensembles/tradeoff/collision_tradeoff.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/base/error.hpp>
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
    const bool named = std::find(asked.begin(), asked.end(), method.word) != asked.end();
    if (asked.empty() || named) chosen.push_back(&method);
  }
  return chosen;
}

CollisionConvergence convergence_of(const CollisionMethod* method, const std::vector<CollisionPoint>& points) {
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

/// One sentence of each reason.
std::vector<std::string> sentences_of(const CollisionMethod& method, const std::vector<std::pair<double, std::string>>& refused) {
  std::vector<std::string> sentences;
  for (auto it = refused.begin(); it != refused.end();) {
    std::vector<double> settings;
    const std::string& reason = it->second;
    for (; it != refused.end() && it->second == reason; ++it) settings.push_back(it->first);
    sentences.push_back(method.has_setting() ? fmt::format("{} at {:g}: {}", method.name(), fmt::join(settings, ", "), reason)
                                             : fmt::format("{}: {}", method.name(), reason));
  }
  return sentences;
}

/// Of a stiff contact, in Rayleigh times.
constexpr double contact_time = 7;

/// Half an hour of a core.
constexpr double most_steps = 2e9;

}  // namespace

double soft_sphere_steps(const Input& input) {
  const CollisionScene scene{.input = input, .moving = moving_scene(input), .reference = {}, .duration = input.run.duration};
  double steps = 0;
  for (const CollisionMethod* method : methods_of(input)) {
    if (!method->steps) continue;
    for (const double fraction : method->settings(input.tradeoff))
      steps += input.run.duration > 0 ? input.run.duration / step_of(scene, fraction) : contact_time / fraction;
  }
  return steps * static_cast<double>(input.tradeoff.phases);
}

CollisionTradeoff collision_tradeoff(const Input& input, const TableStore& store, const std::function<void(double)>& progress) {
  if (const double steps = soft_sphere_steps(input); steps > most_steps)
    throw InputError(fmt::format(
        "run.duration: {:g} s are {:.2g} steps of all study.step_fractions at study.phases = {}; allowed: at most {:g}, by a shorter "
        "run.duration, larger steps or fewer phases",
        input.run.duration, steps, input.tradeoff.phases, most_steps));
  const CollisionScene scene = collision_scene(input);
  CollisionTradeoff study{.speed = scene.speed, .rayleigh_step = step_of(scene, 1)};
  if (scene.moving.bodies.size() == 2 && scene.reference.last_separation > 0)
    study.contact_time = scene.reference.last_separation - scene.reference.first_touch;
  const auto methods = methods_of(input);
  std::size_t count = 0, done = 0;
  for (const CollisionMethod* method : methods) count += method->settings(input.tradeoff).size();
  for (const CollisionMethod* method : methods) {
    std::vector<std::pair<double, std::string>> refused;
    for (const double setting : method->settings(input.tradeoff)) {
      try {
        const PreparedCollision prepared = method->prepare(scene, setting, store);
        if (prepared.resolve) {
          study.points.push_back(measure_collision(scene, *method, setting, prepared, static_cast<int>(input.tradeoff.phases)));
        } else {
          refused.emplace_back(setting, prepared.refusal);
        }
      } catch (const WorkError& failed) {
        refused.emplace_back(setting, failed.what());
      }
      if (progress) progress(static_cast<double>(++done) / static_cast<double>(count));
    }
    for (std::string& each : sentences_of(*method, refused)) study.refusals.push_back(std::move(each));
  }
  std::vector<double> costs, errors;
  for (const CollisionPoint& point : study.points) costs.push_back(point.force_evaluations), errors.push_back(point.motion_rms);
  const std::vector<bool> front = on_front(costs, errors);
  for (std::size_t i = 0; i < front.size(); ++i) study.points[i].on_front = front[i];
  for (const CollisionMethod* method : methods) {
    if (method->has_setting()) study.convergence.push_back(convergence_of(method, study.points));
  }
  return study;
}

}  // namespace scalebreak

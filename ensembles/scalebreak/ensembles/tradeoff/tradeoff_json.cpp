#include <scalebreak/ensembles/tradeoff/tradeoff_json.hpp>

#include <cmath>

namespace scalebreak {
namespace {

using nlohmann::json;

json number(double value) { return std::isfinite(value) ? json(value) : json(); }
json number(const std::optional<double>& value) { return value ? number(*value) : json(); }
const char* word(Method method) { return method_words[static_cast<std::size_t>(method)]; }

}  // namespace

json tradeoff_json(const CollisionTradeoff& study) {
  json points = json::array(), orders = json::array();
  for (const CollisionPoint& p : study.points)
    points.push_back({{"method", p.method->name()},
                      {"setting", p.setting},
                      {"step", p.step > 0 ? json(p.step) : json()},
                      {"phases", p.phases},
                      {"unparted", p.unparted},
                      {"motion_error_rms", number(p.motion_rms)},
                      {"motion_error_largest", number(p.motion_largest)},
                      {"energy_gain_mean", number(p.energy_mean)},
                      {"contact_time_error_rms", number(p.time_rms)},
                      {"contact_time_error_largest", number(p.time_largest)},
                      {"force_evaluations", p.force_evaluations},
                      {"wall_seconds", p.seconds},
                      {"on_front", p.on_front}});
  for (const CollisionConvergence& c : study.convergence)
    orders.push_back({{"method", c.method->name()},
                      {"order", number(c.motion.order)},
                      {"order_error", number(c.motion.error)},
                      {"contact_time_order", number(c.contact_time.order)},
                      {"contact_time_order_error", number(c.contact_time.error)}});
  return {{"speed", study.speed},
          {"contact_time", number(study.contact_time)},
          {"rayleigh_step", study.rayleigh_step},
          {"points", points},
          {"convergence", orders},
          {"refusals", study.refusals}};
}

json tradeoff_json(const FlowTradeoff& study) {
  json points = json::array();
  for (const FlowPoint& p : study.points) {
    json deviations = json::object();
    for (const Comparison& c : p.deviations)
      deviations[c.name] = {{"value", number(c.second.value)},
                            {"error", number(c.second.error)},
                            {"relative", number(c.relative.value)},
                            {"relative_error", number(c.relative.error)}};
    points.push_back({{"method", word(p.method)},
                      {"step_fraction", p.step_fraction},
                      {"step", p.step},
                      {"force_evaluations", number(p.force_evaluations)},
                      {"particle_steps", p.particle_steps},
                      {"wall_seconds", p.seconds},
                      {"largest_deviation", number(p.largest)},
                      {"largest_deviation_error", number(p.largest_error)},
                      {"deviations", deviations},
                      {"on_front", p.on_front}});
  }
  return {{"reference", study.reference}, {"points", points}};
}

json tradeoff_json(const MethodTradeoff& study) {
  json points = json::array();
  for (const WayPoint& p : study.points) {
    json deviations = json::object();
    for (const Comparison& c : p.deviations)
      deviations[c.name] = {{"value", number(c.second.value)},
                            {"error", number(c.second.error)},
                            {"relative", number(c.relative.value)},
                            {"relative_error", number(c.relative.error)}};
    points.push_back({{"engine", p.way.engine},
                      {"law", p.way.law},
                      {"factor", p.way.factor},
                      {"keep", p.way.keep.empty() ? json() : json(p.way.keep)},
                      {"step_fraction", p.way.step_fraction > 0 ? json(p.way.step_fraction) : json()},
                      {"automatic", p.way.automatic},
                      {"failure", p.failure.empty() ? json() : json(p.failure)},
                      {"in_reference", p.in_reference},
                      {"replicas", p.result.replicas},
                      {"particles", p.result.particles},
                      {"worst", p.worst.empty() ? json() : json(p.worst)},
                      {"largest_deviation", number(p.error)},
                      {"largest_deviation_error", number(p.error_error)},
                      {"told", p.told},
                      {"judged_error", number(p.judged)},
                      {"statistical_error", number(p.statistical_error)},
                      {"work", number(p.work)},
                      {"processor_seconds", number(p.seconds)},
                      {"run_evaluations", number(p.result.work.evaluations)},
                      {"run_lookups", number(p.result.work.lookups)},
                      {"run_sphere_steps", number(p.result.work.sphere_steps)},
                      {"run_wall_seconds", number(p.result.wall_seconds)},
                      {"on_work_front", p.on_work_front},
                      {"on_time_front", p.on_time_front},
                      {"deviations", deviations}});
  }
  return {{"points", points},
          {"resolution", study.resolution},
          {"skipped", study.skipped},
          {"complete", study.complete},
          {"sentences", sentences(study)}};
}

}  // namespace scalebreak

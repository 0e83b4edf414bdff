#include <scalebreak/ensembles/report/run_json.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/version.hpp>
#include <scalebreak/ensembles/engine/energy_account.hpp>
#include <scalebreak/ensembles/engine/engine_names.hpp>
#include <scalebreak/measure/flow_json.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

json or_null(double value) { return value > 0 ? json(value) : json(); }

json step_json(const RunRecord& run) {
  if (run.engine == "event") return {{"sample_interval", run.schedule.sample_interval()}};
  const ShortestContact& contact = run.step.contact;
  return {{"step", flies(run.engine) ? run.step.step : run.schedule.step},
          {"step_limit", run.step.limit},
          {"step_bound", run.step.bound},
          {"step_bound_seconds", run.step.bound_step},
          {"collision_speed", or_null(contact.meeting.speed)},
          {"collision_speed_of", contact.meeting.of},
          {"contact_time", or_null(contact.time)},
          {"contact_time_of", contact.of},
          {"contact_time_from", contact_time_source(contact)},
          {"steps_per_contact", or_null(contact.time / (flies(run.engine) ? run.step.step : run.schedule.step))},
          {"sample_interval", run.schedule.sample_interval()}};
}

/// Of the first replica.
json patches_json(const RunRecord& run) {
  const PatchTotals& patches = *run.patches;
  return {{"begun", patches.begun},
          {"collisions_taken_back", patches.taken_back},
          {"collisions_no_table_answered", patches.unresolved},
          {"sphere_steps", patches.sphere_steps},
          {"contact_starts", patches.contact_starts},
          {"time_share", patches.sphere_time / (static_cast<double>(run.particles) * run.time)},
          {"handovers", run.handovers}};
}

json why_no_drift(const RunRecord& run, const Input& input) {
  if (const auto open = why_account_is_open(input)) return *open;
  return run.handovers > 0 ? json("soft spheres ran some of the flow, and do not add up what is dissipated") : json();
}

}  // namespace

std::string contact_time_source(const ShortestContact& contact) {
  if (contact.time == 0) return "none";
  return contact.tabulated ? "table" : fmt::format("exact collision, as {}", contact.resolved);
}

std::string modelled(const Input& input) {
  const ContactKind kind = effective_kind(input.contact, input.colliding().pair().surface_energy);
  const bool spins = input.surface.spins();
  return fmt::format("contact law {}; {}; {}", to_string(kind), to_string(input.surface),
                     spins ? "spins, since these laws turn the spheres" : "no spins, since nothing turns the spheres");
}

json run_json(const Input& input, const RunOutcome& outcome) {
  const RunRecord& first = outcome.replicas.front();
  double particles = 0;
  long steps = 0, integrated = 0, delayed = 0;
  std::vector<std::string> warnings;
  for (const RunRecord& run : outcome.replicas) {
    particles += static_cast<double>(run.particles), steps += run.steps, integrated += run.integrated.value_or(0),
        delayed += run.delayed.value_or(0);
    for (const std::string& warning : run.warnings) {
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
    }
  }
  json j = {{"version", version()},
            {"engine", first.engine},
            {"modelled", modelled(input)},
            {"scaling_law", input.scaling_law},
            {"scaling_factor", input.scaling_factor},
            {"seed", input.run.seed},
            {"replicas", outcome.replicas.size()},
            {"particles", particles / static_cast<double>(outcome.replicas.size())},
            {"cell", {first.cell.x(), first.cell.y(), first.cell.z()}},
            {"time", first.time},
            {"warmup_time", first.schedule.time_of(first.schedule.warmup_samples)},
            {"steps", steps},
            {"events", first.events ? json(outcome.events()) : json()},
            {"integrated_collisions", first.integrated ? json(integrated) : json()},
            {"delayed_collisions", first.delayed ? json(delayed) : json()},
            {"threads", outcome.threads},
            {"wall_seconds", outcome.wall_seconds},
            {"particle_steps_per_second", or_null(outcome.wall_seconds > 0 ? outcome.particle_steps() / outcome.wall_seconds : 0)},
            {"events_per_second", or_null(outcome.wall_seconds > 0 ? static_cast<double>(outcome.events()) / outcome.wall_seconds : 0)},
            {"patch_fraction", first.patches ? json(first.patches->contact_starts / first.contact_starts) : json()},
            {"patches", first.patches ? patches_json(first) : json()},
            {"warnings", warnings}};
  if (outcome.replicas.size() == 1) j["particles"] = first.particles;
  j.update(step_json(first));
  j.update(flow_json(outcome.measured));
  j["energy_drift_missing"] = j["energy_drift"].is_null() ? why_no_drift(first, input) : json();
  return j;
}

}  // namespace scalebreak

#include <scalebreak/ensembles/run/run_estimate.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scalebreak/ensembles/engine/event_engine.hpp>
#include <scalebreak/ensembles/engine/flow_start.hpp>
#include <scalebreak/ensembles/engine/step_choice.hpp>
#include <scalebreak/ensembles/run/run_schedule.hpp>
#include <scalebreak/start/filling.hpp>

namespace scalebreak {
namespace {

/// Seconds of soft spheres for a sphere's step: of one that flies, and for what is in contact beside, over contact time × collision rate up to
/// what a crowd costs; docs/event_driven.md.
constexpr double flying_seconds = 5e-9, contact_seconds = 130e-9, crowd_seconds = 75e-9;
/// Seconds of the hybrid for a collision, for one in a patch beside, and how many there are of those over contact time × collision rate:
/// docs/event_driven.md.
constexpr double collision_seconds = 1e-5, patch_seconds = 4e-5, patched_share = 11;
constexpr double bytes_per_sphere = 2500, bytes_of_program = 20e6;

constexpr double densest = 0.6;  ///< up to which Enskog's theory is asked

/// Of a sphere in a frame with all fields.
double frame_bytes(ParticleFormat format) {
  switch (format) {
    case ParticleFormat::csv: return 250;
    case ParticleFormat::vtp: return 180;
    case ParticleFormat::xyz: return 255;
    case ParticleFormat::dump: return 243;
  }
  return 0;
}

}  // namespace

RunEstimate estimate_run(const Input& input, int threads) {
  RunEstimate estimate;
  StepScene scene;
  Cell cell;
  double volume_fraction = 0;
  if (input.particles.file.empty()) {
    const FlowPlan plan = plan_flow(input);
    estimate.particles = plan.count, cell.size = plan.size, volume_fraction = plan.volume_fraction;
    scene = expected_step_scene(input);
  } else {
    const FlowStart start = flow_start(input);
    estimate.particles = static_cast<double>(start.system.count()), cell = start.system.cell;
    volume_fraction = scalebreak::volume_fraction(cell, start.system.radius);
    scene = step_scene(input, start.system, start.speed);
  }
  if (input.cell.kind == CellKind::confined_shear)  // most of it is spent at about this height
    cell.size.z() *= volume_fraction / densest, volume_fraction = densest;
  const StepChoice step = choose_step(input, scene, nullptr);
  const RunSchedule schedule = run_schedule(run_times(input, cell), step.step);
  const auto replicas = static_cast<double>(input.run.replicas);
  const double radius = std::cbrt(volume_fraction * cell.volume() / estimate.particles / (4 * std::numbers::pi / 3));
  estimate.contact_time = step.contact.time;
  estimate.collision_rate =
      enskog_rate(estimate.particles / cell.volume() * 4 * radius * radius, std::min(volume_fraction, densest), scene.meeting.speed);
  const double busy = estimate.contact_time * estimate.collision_rate;
  estimate.steps = static_cast<double>(schedule.steps());
  estimate.seconds =
      replicas * estimate.particles * estimate.steps * (flying_seconds + std::min(contact_seconds * busy, crowd_seconds)) / threads;
  const double patched = std::min(1.0, patched_share * busy);
  estimate.hybrid_seconds = replicas * estimate.particles / 2 * estimate.collision_rate * schedule.time_of(schedule.samples) *
                            (collision_seconds + patched * patch_seconds);
  estimate.bytes = bytes_of_program + bytes_per_sphere * estimate.particles;
  for (const ParticleFormat format : input.output.formats)
    estimate.file_bytes += replicas * frame_bytes(format) * estimate.particles *
                           (1 + static_cast<double>(schedule.samples) / static_cast<double>(schedule.samples_per_row));
  return estimate;
}

}  // namespace scalebreak

#include <scalebreak/ensembles/run/run_estimate.hpp>

#include <scalebreak/ensembles/engine/flow_start.hpp>
#include <scalebreak/ensembles/engine/step_choice.hpp>
#include <scalebreak/ensembles/run/run_schedule.hpp>

namespace scalebreak {
namespace {

/// Spheres times steps per second and thread; measured on a busy machine: 2.6e7 at a volume fraction of 0.3, 6e7 at 0.1.
constexpr double particle_steps_per_second = 2e7;
constexpr double bytes_per_sphere = 2500, bytes_of_program = 20e6;

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
  if (input.particles.file.empty()) {
    const FlowPlan plan = plan_flow(input);
    estimate.particles = plan.count, cell.size = plan.size;
    scene = expected_step_scene(input);
  } else {
    const FlowStart start = flow_start(input);
    estimate.particles = static_cast<double>(start.system.count()), cell = start.system.cell;
    scene = step_scene(input, start.system, start.speed);
  }
  const RunSchedule schedule = run_schedule(run_times(input, cell), choose_step(input, scene, nullptr).step);
  const auto replicas = static_cast<double>(input.run.replicas);
  estimate.steps = static_cast<double>(schedule.steps());
  estimate.seconds = replicas * estimate.particles * estimate.steps / (particle_steps_per_second * threads);
  estimate.bytes = bytes_of_program + bytes_per_sphere * estimate.particles;
  for (const ParticleFormat format : input.output.formats)
    estimate.file_bytes += replicas * frame_bytes(format) * estimate.particles *
                           (1 + static_cast<double>(schedule.samples) / static_cast<double>(schedule.samples_per_row));
  return estimate;
}

}  // namespace scalebreak

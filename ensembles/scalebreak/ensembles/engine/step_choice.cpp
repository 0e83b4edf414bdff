#include <scalebreak/ensembles/engine/step_choice.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/scene/flow_scene.hpp>
#include <scalebreak/scene/sphere_sizes.hpp>

namespace scalebreak {
namespace {

constexpr double collision_tolerance = 1e-6;
/// A pair that sticks has no contact time; a little above its sticking speed it has.
constexpr double above_sticking = 2;

double speed_that_occurs(const CellInput& cell, const Eigen::Vector3d& size, double largest_radius, double speed) {
  const double passing = mean_shear_rate(cell, size.z()) * 2 * largest_radius;
  const double falling = std::sqrt(2 * cell.gravity.cwiseAbs().dot(size));
  return std::max({speed, passing, falling});
}

/// Of two of the smallest spheres of a material, exactly; 0 where every pair sticks.
double contact_time(const Input& input, const Material& material, double scaled_radius, double speed) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  const double radius = scaled_radius / size_factor(law, input.scaling_factor);
  const ScaledContact contact(input.contact, {material, material, input.wall, {radius, radius}}, law, input.scaling_factor);
  const double at = std::max(speed, above_sticking * contact.sticking_speed(collision_tolerance).value_or(0));
  return contact.collide(at, collision_tolerance).contact_time.value_or(0);
}

}  // namespace

StepScene step_scene(const Input& input, const System& start, double speed) {
  StepScene scene;
  for (std::size_t i = 0; i < start.count(); ++i) {
    double& smallest = scene.smallest[start.material[i]];
    smallest = smallest == 0 ? start.radius[i] : std::min(smallest, start.radius[i]);
  }
  const double largest = *std::max_element(start.radius.begin(), start.radius.end());
  scene.speed = speed_that_occurs(input.cell, start.cell.size, largest, speed);
  return scene;
}

StepScene expected_step_scene(const Input& input) {
  const FlowPlan plan = plan_flow(input);
  const double factor = size_factor(*find_scaling_law(input.scaling_law), input.scaling_factor);
  const SizeRange range = size_range(input.particles, {input.material.density, input.second.density});
  StepScene scene{.smallest = {factor * range.least, 0},
                  .speed = speed_that_occurs(input.cell, plan.size, plan.largest, input.particles.speed)};
  if (input.particles.size == SizeKind::bidisperse) scene.smallest[1] = factor * input.particles.large_radius;
  return scene;
}

StepChoice choose_step(const Input& input, const StepScene& scene) {
  StepChoice choice{.speed = scene.speed};
  const DemSetup setup = dem_setup(input, 0, 1);
  double smallest = 0;
  for (const std::size_t k : {0, 1}) {
    if (scene.smallest[k] == 0) continue;
    smallest = smallest == 0 ? scene.smallest[k] : std::min(smallest, scene.smallest[k]);
    if (scene.speed == 0) continue;
    const double time = contact_time(input, k == 0 ? input.material : input.second, scene.smallest[k], scene.speed);
    if (time > 0 && (choice.contact_time == 0 || time < choice.contact_time)) choice.contact_time = time;
  }
  const StepBound bound = critical_steps(setup, smallest, choice.contact_time).front();
  choice.bound = bound.name, choice.bound_step = bound.step;
  choice.asked = input.run.step_fraction * rayleigh_step(setup, smallest);
  const bool beyond = choice.asked > bound.step, bounded = beyond && input.run.step_bounds;
  choice.step = bounded ? bound.step : choice.asked;
  choice.limit = bounded ? bound.name : "step_fraction";
  if (beyond)
    choice.warning = fmt::format(
        "run.step_fraction = {:g} of the Rayleigh time is a step of {:.3g} s, beyond the bound of the {}, {:.3g} s, {}",
        input.run.step_fraction, choice.asked, bound.name, bound.step,
        bounded ? "which is taken instead" : "and is taken all the same, as run.step_bounds = false has it");
  return choice;
}

}  // namespace scalebreak

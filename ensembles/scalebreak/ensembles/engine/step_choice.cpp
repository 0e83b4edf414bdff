#include <scalebreak/ensembles/engine/step_choice.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/scene/flow_scene.hpp>
#include <scalebreak/scene/sphere_sizes.hpp>

namespace scalebreak {
namespace {

double least_density(const Input& input, bool second) {
  return second ? std::min(input.material.density, input.second.density) : input.material.density;
}

bool has_walls(const CellInput& cell) { return std::count(cell.boundary.begin(), cell.boundary.end(), Boundary::wall) > 0; }

}  // namespace

StepScene step_scene(const Input& input, const System& start, double speed) {
  StepScene scene{.walls = has_walls(input.cell)};
  for (std::size_t i = 0; i < start.count(); ++i) {
    double& smallest = scene.smallest[start.material[i]];
    smallest = smallest == 0 ? start.radius[i] : std::min(smallest, start.radius[i]);
  }
  const double largest = *std::max_element(start.radius.begin(), start.radius.end());
  scene.meeting = fastest_meeting(input.cell, start.cell.size, largest, speed, least_density(input, scene.smallest[1] > 0));
  return scene;
}

StepScene expected_step_scene(const Input& input) {
  const FlowPlan plan = plan_flow(input);
  const double factor = size_factor(*find_scaling_law(input.scaling_law), input.scaling_factor);
  const SizeRange range = size_range(input.particles, {input.material.density, input.second.density});
  StepScene scene{.smallest = {factor * range.least, 0},
                  .meeting = fastest_meeting(input.cell, plan.size, plan.largest, input.particles.speed,
                                             least_density(input, input.particles.size == SizeKind::bidisperse)),
                  .walls = has_walls(input.cell)};
  if (input.particles.size == SizeKind::bidisperse) scene.smallest[1] = factor * input.particles.large_radius;
  return scene;
}

StepChoice choose_step(const Input& input, const StepScene& scene, const TableStore* tables) {
  StepChoice choice{.contact = shortest_contact(input, scene.smallest, scene.walls, scene.meeting, tables)};
  const DemSetup setup = dem_setup(input, 0, 1);
  double smallest = 0;
  for (const double radius : scene.smallest) {
    if (radius > 0) smallest = smallest == 0 ? radius : std::min(smallest, radius);
  }
  const StepBound bound = critical_steps(setup, smallest, choice.contact.time).front();
  choice.bound = bound.name, choice.bound_step = bound.step;
  choice.asked = input.run.step_fraction * rayleigh_step(setup, smallest);
  const bool beyond = choice.asked > bound.step, bounded = beyond && input.run.step_bounds;
  choice.step = bounded ? bound.step : choice.asked;
  choice.limit = bounded ? bound.name : "step_fraction";
  if (beyond)
    choice.warning =
        fmt::format("run.step_fraction = {:g} of the Rayleigh time is a step of {:.3g} s, beyond the bound of the {}, {:.3g} s, {}",
                    input.run.step_fraction, choice.asked, bound.name, bound.step,
                    bounded ? "which is taken instead" : "and is taken all the same, as run.step_bounds = false has it");
  return choice;
}

}  // namespace scalebreak

#include <scalebreak/ensembles/stability/criteria.hpp>

#include <scalebreak/ensembles/stability/rolling_left.hpp>

namespace scalebreak {
namespace {

/// Of the limit: what moves more slowly is at rest.
constexpr double at_rest = 0.1;

}  // namespace

std::span<const StabilityCriterion> stability_criteria(bool flow) {
  static constexpr StabilityCriterion of_flows[] = {
      {"energy_growth", "-", "growth of the energy of an elastic flow, relative, per collision of each sphere",
       "Growth of energy over the step", "growth per collision of each sphere [-]",
       [](const StepTrial& trial) { return trial.energy_growth; }, &Input::study_energy_growth}};
  static constexpr StabilityCriterion of_collisions[] = {
      {"motion_error", "-",
       "largest error of a body's velocity or surface speed after a collision, over its speed, whenever in a step it begins",
       "Error of a collision over the step", "largest error over the speed [-]", [](const StepTrial& trial) { return trial.motion_error; },
       &Input::study_motion_error},
      {"rolling_left", "-",
       "largest rolling speed of bodies that should not roll on each other any more, over its speed, whenever in a step it begins",
       "Rolling that is left over the step", "rolling speed over the speed [-]", [](const StepTrial& trial) { return trial.rolling_left; },
       &Input::study_motion_error, true}};
  return flow ? std::span<const StabilityCriterion>(of_flows) : std::span<const StabilityCriterion>(of_collisions);
}

std::vector<StabilityCriterion> stability_criteria(const Input& input) {
  std::vector<StabilityCriterion> all;
  for (const StabilityCriterion& criterion : stability_criteria(input.flow)) {
    if (!criterion.at_rest || comes_to_rest(collision_scene(input), at_rest * input.*criterion.limit)) all.push_back(criterion);
  }
  return all;
}

}  // namespace scalebreak

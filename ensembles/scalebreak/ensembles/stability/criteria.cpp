#include <scalebreak/ensembles/stability/criteria.hpp>

namespace scalebreak {

std::span<const StabilityCriterion> stability_criteria(bool flow) {
  static constexpr StabilityCriterion of_flows[] = {
      {"energy_growth", "-", "growth of the energy of an elastic flow, relative, per collision of each sphere",
       [](const StepTrial& trial) { return trial.energy_growth; }, &Input::study_energy_growth}};
  static constexpr StabilityCriterion of_collisions[] = {
      {"motion_error", "-",
       "largest error of a body's velocity or surface speed after a collision, over its speed, whenever in a step it begins",
       [](const StepTrial& trial) { return trial.motion_error; }, &Input::study_motion_error}};
  return flow ? std::span<const StabilityCriterion>(of_flows) : std::span<const StabilityCriterion>(of_collisions);
}

}  // namespace scalebreak

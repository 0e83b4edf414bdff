#include <scalebreak/ensembles/stability/criteria.hpp>

namespace scalebreak {

std::span<const StabilityCriterion> stability_criteria() {
  static constexpr StabilityCriterion criteria[] = {
      {"energy_growth", "-", "growth of the energy of an elastic flow, relative, per collision of each sphere",
       [](const StepTrial& trial) { return trial.energy_growth; }, &Input::study_energy_growth}};
  return criteria;
}

}  // namespace scalebreak

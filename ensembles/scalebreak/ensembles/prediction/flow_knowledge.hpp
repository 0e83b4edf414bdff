#pragma once

#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/model_fit.hpp>

namespace scalebreak {

/// What is expected of a quantity of a scaled flow.
struct Expectation {
  std::string quantity;
  Measured deviation;     ///< value / claim − 1
  std::string mechanism;  ///< what moves it most
};

/// By how much cohesion moves the shear stress of a slow flow under a pressure: ln(stress), beside what the inertial number does, over ln(pull-off force /
/// (pressure × d²)).
struct CohesionSlope {
  Measured slope;
  double at = 0;  ///< the original's pull-off force over pressure × d² where it was measured
};
/// From the rows of a study of a confined flow, those whose original is cohesive. Throws WorkError where there is none.
[[nodiscard]] CohesionSlope cohesion_slope(const TrainingRows& confined);

/// What a scaled flow is expected to do, by its kind. Collisional shear goes by the fitted model, a cooling gas by theory (cooling_prediction.hpp). In
/// slow shear under a pressure it is the stress and the volume fraction: by the inertial number (Jop, Forterre & Pouliquen, Nature 441 (2006) 727, glass
/// beads), by pull-off force over pressure × d² (`slope`) and by how soft spheres are pressed into each other. Of what rests it is the volume fraction.
struct FlowKnowledge {
  const DeviationModel& model;
  FlowRegime regime = FlowRegime::collisional;
  CohesionSlope slope;

  [[nodiscard]] std::vector<Expectation> expected(const ScaleGroups& original, const ScaleGroups& scaled) const;
  /// Above 0 where something is beyond what contact laws, the model, or `tolerance` of what must be kept allow.
  [[nodiscard]] double beyond(const ScaleGroups& original, const ScaleGroups& scaled, double tolerance) const;
};

/// Reads data/reference/confined where the scene needs it.
[[nodiscard]] FlowKnowledge knowledge_of(const ScaleGroups& original, const DeviationModel& model);

/// "keeps pull-off force over pressure × d²; inertial number × 2": of the numbers that matter to the kind of flow.
[[nodiscard]] std::string kept_groups(const ScaleGroups& original, const ScaleGroups& scaled);

/// The deviation and its error.
[[nodiscard]] inline double with_error(const Expectation& e) { return std::abs(e.deviation.value) + e.deviation.error; }

}  // namespace scalebreak

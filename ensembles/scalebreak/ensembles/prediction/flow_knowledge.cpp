#include <scalebreak/ensembles/prediction/flow_knowledge.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/ensembles/prediction/cooling_prediction.hpp>
#include <scalebreak/scene/materials.hpp>

namespace scalebreak {
namespace {

constexpr double own_share = 0.5;  ///< of an estimate that no study was fitted to, its error

/// The term that moves a prediction most, and the others that go the same way do not.
std::string mechanism_of(const Prediction& prediction) {
  double largest = std::abs(prediction.size);
  std::string mechanism = "size";
  std::vector<std::pair<std::string, double>> sums;  // terms of one mechanism act together
  for (std::size_t i = 0; i < term_count; ++i) {
    const std::string name = deviation_terms[i].mechanism;
    const auto at = std::find_if(sums.begin(), sums.end(), [&](const auto& each) { return each.first == name; });
    at == sums.end() ? void(sums.emplace_back(name, prediction.parts[i])) : void(at->second += prediction.parts[i]);
  }
  for (const auto& [name, sum] : sums) {
    if (std::abs(sum) > largest) largest = std::abs(sum), mechanism = name;
  }
  return mechanism;
}

/// Shear stress over pressure, μ(I) = μ₁ + (μ₂ − μ₁)/(1 + I₀/I).
double friction_of_flow(double inertial_number) {
  constexpr double slow = 0.382, fast = 0.643, at = 0.279;  // tan 20.9°, tan 32.76°, I₀
  return slow + (fast - slow) / (1 + at / inertial_number);
}

/// What the inertial number does to ln(stress).
double of_inertia(const ScaleGroups& original, const ScaleGroups& scaled) {
  return std::log(friction_of_flow(scaled.inertial_number) / friction_of_flow(original.inertial_number));
}

double ln_ratio(double scaled, double original) { return original > 0 && scaled > 0 ? std::log(scaled / original) : 0; }

/// As e^logarithm − 1.
Measured relative(double logarithm, double error) { return {std::expm1(logarithm), std::exp(logarithm) * error}; }

/// Spheres pressed into each other bring centres nearer by the overlap: 3 δ/d of the volume, d = 4 R*.
Expectation pressed_together(const ScaleGroups& original, const ScaleGroups& scaled) {
  const double nearer = 3.0 / 4 * (scaled.pressed_overlap - original.pressed_overlap);
  return {"volume_fraction", relative(nearer, own_share * std::abs(nearer)), "overlap"};
}

Expectation slow_shear_stress(const CohesionSlope& slope, const ScaleGroups& original, const ScaleGroups& scaled) {
  const double inertia = of_inertia(original, scaled);
  const double bond = ln_ratio(scaled.bond, original.bond);
  // What cohesion adds to the stress grows with it, from nothing.
  const double share = slope.at > 0 ? std::min(1.0, std::max(original.bond, scaled.bond) / slope.at) : 0;
  const double cohesion = slope.slope.value * share * bond;
  const double error = std::hypot(own_share * inertia, slope.slope.error * bond * share);
  return {"stress_xz", relative(inertia + cohesion, error), std::abs(cohesion) > std::abs(inertia) ? "adhesion" : "size"};
}

}  // namespace

CohesionSlope cohesion_slope(const TrainingRows& confined) {
  double weight = 0, sum = 0, at = 0, squares = 0;
  int rows = 0;
  const auto each = [&](auto&& use) {
    for (const TrainingRow& row : confined.rows) {
      const double bond = ln_ratio(row.scaled.bond, row.original.bond);
      if (row.quantity == "stress_xz" && std::abs(bond) > 0.1)
        use(row, bond, std::log1p(row.deviation.value) - of_inertia(row.original, row.scaled));
    }
  };
  each([&](const TrainingRow& row, double bond, double stress) {
    weight += bond * bond, sum += bond * stress, at += row.original.bond, ++rows;
  });
  if (rows < 2) throw WorkError("the study of a confined flow has no cohesive original and scaled flows whose cohesion is another");
  const double slope = sum / weight;
  each([&](const TrainingRow&, double bond, double stress) { squares += std::pow(stress - slope * bond, 2); });
  return {{slope, std::sqrt(squares / (rows - 1) / weight * rows)},
          at / rows};  // the error of one row: laws differ by more than they are uncertain
}

std::vector<Expectation> FlowKnowledge::expected(const ScaleGroups& original, const ScaleGroups& scaled) const {
  if (regime == FlowRegime::pressed) return {slow_shear_stress(slope, original, scaled), pressed_together(original, scaled)};
  if (regime == FlowRegime::resting) return {pressed_together(original, scaled)};
  std::vector<Expectation> list;
  for (const QuantityModel& quantity : model.quantities) {
    if (regime == FlowRegime::cooling && quantity.quantity == "stress_xz") continue;
    const Prediction p = predicted(model.quantities, quantity.quantity, original, scaled);
    list.push_back({quantity.quantity, p.deviation, mechanism_of(p)});
  }
  return list;
}

double FlowKnowledge::beyond(const ScaleGroups& original, const ScaleGroups& scaled, double tolerance) const {
  if (regime == FlowRegime::collisional || regime == FlowRegime::cooling) return beyond_model(original, scaled);
  const double deep = scaled.pressed_overlap / deep_overlap - 1;
  if (regime == FlowRegime::pressed) return deep;
  return std::max(deep, std::abs(ln_ratio(scaled.bond, original.bond)) / tolerance - 1);
}

FlowKnowledge knowledge_of(const ScaleGroups& original, const DeviationModel& model) {
  FlowKnowledge knowledge{.model = model, .regime = original.regime, .slope = {}};
  if (original.regime != FlowRegime::pressed || original.bond == 0) return knowledge;
  TrainingRows confined;
  add_study(confined, data_folder() / "reference" / "confined");
  knowledge.slope = cohesion_slope(confined);
  return knowledge;
}

std::string kept_groups(const ScaleGroups& original, const ScaleGroups& scaled) {
  struct Group {
    const char* name;
    double from, to;
  };
  std::vector<Group> groups;
  const bool gas = original.regime == FlowRegime::collisional || original.regime == FlowRegime::cooling;
  if (gas) {
    groups.push_back({"contact time × collision rate", original.busy, scaled.busy});
    groups.push_back({"sticking speed over impact speed", 1 / original.impact_over_sticking, 1 / scaled.impact_over_sticking});
  } else {
    const bool weight = original.regime == FlowRegime::resting;
    groups.push_back({weight ? "pull-off force over weight" : "pull-off force over pressure × d²", original.bond, scaled.bond});
    if (!weight) groups.push_back({"inertial number", original.inertial_number, scaled.inertial_number});
    groups.push_back({"overlap under the load", original.pressed_overlap, scaled.pressed_overlap});
  }
  groups.push_back({"diameter", 1, scaled.size});
  std::string kept, changed;
  for (const Group& group : groups) {
    if (group.from == 0) continue;
    const double ratio = group.to / group.from;
    constexpr double same = 1e-3;
    if (std::abs(ratio - 1) < same)
      kept += fmt::format("{}{}", kept.empty() ? "keeps " : ", ", group.name);
    else
      changed += fmt::format("{}{} × {:.3g}", changed.empty() ? "changes " : ", ", group.name, ratio);
  }
  return kept + (kept.empty() || changed.empty() ? "" : "; ") + changed;
}

}  // namespace scalebreak

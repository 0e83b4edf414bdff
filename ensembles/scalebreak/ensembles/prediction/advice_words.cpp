#include <scalebreak/ensembles/prediction/advice_words.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/output/known.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

constexpr double a_little = 1.02;
constexpr double range_margin = 1.05;  ///< of a fitted range that counts as inside

std::string size_reason(const ScaleGroups& original, const ScaleGroups& there) {
  switch (original.regime) {
    case FlowRegime::pressed:
      return fmt::format("the inertial number goes from {:.2g} to {:.2g}, as shear rate × diameter", original.inertial_number,
                         there.inertial_number);
    case FlowRegime::cooling: return fmt::format("spheres {:.3g} times larger meet more rarely, and cool later by as much", there.size);
    default:
      return fmt::format(
          "spheres {:.3g} times larger in a flow whose pressure collisions carry, in which temperature and stress grow as size²",
          there.size);
  }
}

std::string reason_of(const std::string& mechanism, const ScaleGroups& original, const ScaleGroups& there) {
  if (mechanism == "size") return size_reason(original, there);
  if (mechanism == "adhesion" && original.regime == FlowRegime::pressed)
    return fmt::format("pull-off force over pressure × d² goes from {:.3g} to {:.3g}", original.bond, there.bond);
  if (mechanism == "adhesion")
    return fmt::format("sticking speed over impact speed goes from {:.3g} to {:.3g}", 1 / original.impact_over_sticking,
                       1 / there.impact_over_sticking);
  if (mechanism == "overlap")
    return fmt::format("spheres are pressed into each other by {:.2g} of R*, {:.2g} before", there.pressed_overlap,
                       original.pressed_overlap);
  if (mechanism == "contact time")
    return fmt::format("contact time × collision rate goes from {:.2g} to {:.2g}", original.busy, there.busy);
  return "the torques of a direct-force law fall short at the larger radius";
}

/// What is beyond the contact laws, the model, or a number that must be kept: the mechanism and a sentence, or nothing.
std::pair<std::string, std::string> broken_bound(const FlowKnowledge& knowledge, const ScaleGroups& original, const ScaleGroups& there,
                                                 double tolerance) {
  const bool gas = knowledge.regime == FlowRegime::collisional || knowledge.regime == FlowRegime::cooling;
  if (knowledge.beyond(original, there, tolerance) <= 0) return {};
  if ((gas ? there.overlap : there.pressed_overlap) > deep_overlap)
    return {"overlap", fmt::format("overlaps would exceed {:g} of R*, more than the contact laws are meant for", deep_overlap)};
  if (gas)
    return {"adhesion",
            fmt::format("spheres would stick below more than {:g} of the impact speed, where a flow gathers into lumps", lumps_beyond)};
  return {"adhesion", fmt::format("pull-off force over weight goes from {:.3g} to {:.3g}, and what that does has not been measured",
                                  original.bond, there.bond)};
}

json groups_json(const ScaleGroups& groups) {
  json object = json::object();
  for (const auto& [name, value] : named_groups(groups)) object[name] = known_number(value);
  object["temperature"] = groups.temperature, object["impact_speed"] = groups.impact_speed;
  object["overlap_under_load"] = groups.pressed_overlap, object["cooled"] = groups.cooled;
  object["contact_time"] = groups.contact_time, object["collision_rate"] = groups.collision_rate;
  return object;
}

json law_json(const LawAdvice& advice) {
  json errors = json::object();
  for (const Expectation& each : advice.predictions)
    errors[each.quantity] = {{"deviation", known_number(each.deviation.value)}, {"uncertainty", known_number(each.deviation.error)}};
  const Measured expected = advice.expected_error();
  return {{"law", advice.law},
          {"factor", advice.factor},
          {"engine", advice.engine},
          {"engine_reason", advice.engine_reason},
          {"expected_error", known_number(expected.value)},
          {"expected_error_uncertainty", known_number(expected.error)},
          {"expected_error_of", advice.worst},
          {"speedup", known_number(advice.speedup)},
          {"limiting_mechanism", advice.limiting_mechanism},
          {"limit", advice.limit},
          {"keeps", advice.keeps},
          {"warnings", advice.warnings},
          {"predictions", errors},
          {"groups", groups_json(advice.groups)}};
}

}  // namespace

double beyond(double factor, double end) { return end < 1 ? std::max(factor / a_little, end / a_little) : factor * a_little; }

void describe_limit(LawAdvice& advice, const FlowKnowledge& knowledge, const ScaleGroups& original, const ScaleGroups& there,
                    double tolerance, double end) {
  if (auto [mechanism, limit] = broken_bound(knowledge, original, there, tolerance); !mechanism.empty()) {
    advice.limiting_mechanism = std::move(mechanism), advice.limit = std::move(limit);
    return;
  }
  Expectation worst;
  double most = -1;
  for (const Expectation& each : knowledge.expected(original, there)) {
    if (with_error(each) > most) most = with_error(each), worst = each;
  }
  if (advice.factor == end || most <= tolerance) {
    advice.limiting_mechanism = "none";
    advice.limit = fmt::format("nothing up to {:g}, the farthest that was asked for", end);
    return;
  }
  advice.limiting_mechanism = worst.mechanism;
  advice.limit = fmt::format("{}: beyond it {} is expected to be off by {:+.1f} % ± {:.1f} %", reason_of(worst.mechanism, original, there),
                             study_quantity(worst.quantity).what, 100 * worst.deviation.value, 100 * worst.deviation.error);
}

namespace {

/// Where groups lie outside what the model was fitted to. Of a gas that cools, those of shear say nothing.
void warn_of_ranges(std::vector<std::string>& warnings, const DeviationModel& model, const ScaleGroups& scaled) {
  for (const auto& [name, value] : named_groups(scaled)) {
    const auto at = model.ranges.find(name);
    const bool of_shear = name == "collisional_share" || name == "inertial_number";
    if (at == model.ranges.end() || !std::isfinite(value) || (of_shear && !scaled.sheared)) continue;
    const GroupRange& range = at->second;
    const double slack = range_margin - 1;
    if (value > range.largest + slack * std::abs(range.largest) || value < range.least - slack * std::abs(range.least))
      warnings.push_back(fmt::format("{} is {:.3g}, outside {:.3g} to {:.3g}, to which the prediction was fitted", name, value, range.least,
                                     range.largest));
  }
}

void warn_of_terms(std::vector<std::string>& warnings, const DeviationModel& model, const ScaleGroups& original,
                   const ScaleGroups& scaled) {
  const Terms terms = terms_of(original, scaled);
  for (std::size_t i = 0; i < term_count; ++i) {
    const bool fitted = std::all_of(model.quantities.begin(), model.quantities.end(), [&](const QuantityModel& q) { return q.fitted[i]; });
    if (!fitted && std::abs(terms[i]) > 1e-6)
      warnings.push_back(
          fmt::format("{} matters here, and no study that the prediction was fitted to shows how much", deviation_terms[i].mechanism));
  }
}

}  // namespace

std::vector<std::string> warnings_of(const Input& scene, const FlowKnowledge& knowledge, const ScaleGroups& original,
                                     const ScaleGroups& scaled) {
  std::vector<std::string> warnings;
  switch (knowledge.regime) {
    case FlowRegime::collisional:
      warn_of_ranges(warnings, knowledge.model, scaled), warn_of_terms(warnings, knowledge.model, original, scaled);
      if (scene.cell.kind != CellKind::shear)
        warnings.emplace_back("the prediction was fitted to homogeneous shear; walls and their distance are not in it");
      break;
    case FlowRegime::cooling:
      warnings.emplace_back(
          "nothing is sheared here: laws are compared at one and the same time, by what kinetic theory says of a gas that starts without spin; "
          "that contacts which last make collisions rarer is taken from sheared flows");
      if (original.cooled == 0) warnings.emplace_back("run.duration is not given, so that this is the gas at its start");
      break;
    case FlowRegime::pressed:
      warnings.emplace_back(
          "lasting contacts carry the pressure, and the prediction was fitted to collisions: a law is held to shear stress and volume fraction, by "
          "inertial number, cohesion and overlap under the load; temperature and collision rate are not kept, and softer spheres were not measured");
      if (original.bond > 0)
        warnings.push_back(fmt::format(
            "cohesion over pressure goes from {:.3g} to {:.3g}: its effect on the stress was measured at {:.2g}, twice and half of it",
            original.bond, scaled.bond, knowledge.slope.at));
      break;
    case FlowRegime::resting:
      warnings.emplace_back(
          "nothing is sheared and gravity pulls: the prediction knows nothing of such a flow; a law is held to what the load does to its "
          "contacts and to pull-off force over weight, and how it comes to rest is not looked at");
      break;
  }
  if (original.jammed && knowledge.regime == FlowRegime::collisional)
    warnings.emplace_back("the volume fraction is that of a jammed packing, and the prediction is that of the densest flow");
  return warnings;
}

json advice_json(const Advice& advice, const DeviationModel& model, double tolerance) {
  json result = law_json(advice.laws[advice.recommended]);
  result["tolerance"] = tolerance;
  result["original"] = groups_json(advice.original);
  result["prediction"] = {{"studies", model.studies}, {"rows_fitted", model.rows_fitted}, {"cells_off_held_back", model.cells_off}};
  result["laws"] = json::array();
  for (const LawAdvice& law : advice.laws) result["laws"].push_back(law_json(law));
  return result;
}

std::string sentence(const LawAdvice& advice) {
  const Measured error = advice.expected_error();
  return fmt::format("{} to {:.3g}: {:.3g} times fewer sphere steps, by {}; {} off by {:.1f} % ± {:.1f} %; limited by {}", advice.law,
                     advice.factor, advice.speedup, advice.engine, study_quantity(advice.worst).what, 100 * error.value, 100 * error.error,
                     advice.limiting_mechanism == "none" ? "nothing" : advice.limit);
}

}  // namespace scalebreak

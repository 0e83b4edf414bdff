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

std::string reason_of(const std::string& mechanism, const ScaleGroups& original, const ScaleGroups& there) {
  if (mechanism == "size")
    return fmt::format(
        "spheres {:.3g} times larger in a flow whose pressure collisions carry, in which temperature and stress grow as size²", there.size);
  if (mechanism == "adhesion")
    return fmt::format("sticking speed over impact speed goes from {:.3g} to {:.3g}", 1 / original.impact_over_sticking,
                       1 / there.impact_over_sticking);
  if (mechanism == "contact time")
    return fmt::format("contact time × collision rate goes from {:.2g} to {:.2g}", original.busy, there.busy);
  return "the torques of a direct-force law fall short at the larger radius";
}

json groups_json(const ScaleGroups& groups) {
  json object = json::object();
  for (const auto& [name, value] : named_groups(groups)) object[name] = known_number(value);
  object["temperature"] = groups.temperature, object["impact_speed"] = groups.impact_speed;
  object["contact_time"] = groups.contact_time, object["collision_rate"] = groups.collision_rate;
  return object;
}

json law_json(const LawAdvice& advice) {
  json errors = json::object();
  for (const auto& [name, p] : advice.predictions)
    errors[name] = {{"deviation", known_number(p.deviation.value)}, {"uncertainty", known_number(p.deviation.error)}};
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
          {"warnings", advice.warnings},
          {"predictions", errors},
          {"groups", groups_json(advice.groups)}};
}

}  // namespace

double beyond(double factor, double end) { return end < 1 ? std::max(factor / a_little, end / a_little) : factor * a_little; }

void describe_limit(LawAdvice& advice, const DeviationModel& model, const ScaleGroups& original, const ScaleGroups& there, double tolerance,
                    double end) {
  if (there.overlap > deep_overlap) {
    advice.limiting_mechanism = "overlap";
    advice.limit = fmt::format("overlaps would exceed {:g} of R*, more than the contact laws are meant for", deep_overlap);
    return;
  }
  if (beyond_model(there) > 0) {
    advice.limiting_mechanism = "adhesion";
    advice.limit =
        fmt::format("spheres would stick below more than {:g} of the impact speed, where a flow gathers into lumps", lumps_beyond);
    return;
  }
  const QuantityModel* worst = nullptr;
  Prediction off{.deviation = {0, 0}};
  double most = -1;
  for (const QuantityModel& quantity : model.quantities) {
    const Prediction p = predict(quantity, original, there);
    const double size = std::abs(p.deviation.value) + p.deviation.error;
    if (size > most) most = size, worst = &quantity, off = p;
  }
  if (advice.factor == end || most <= tolerance) {
    advice.limiting_mechanism = "none";
    advice.limit = fmt::format("nothing up to {:g}, the farthest that was asked for", end);
    return;
  }
  advice.limiting_mechanism = mechanism_of(off);
  advice.limit =
      fmt::format("{}: beyond it {} is expected to be off by {:+.1f} % ± {:.1f} %", reason_of(advice.limiting_mechanism, original, there),
                  study_quantity(worst->quantity).what, 100 * off.deviation.value, 100 * off.deviation.error);
}

std::vector<std::string> warnings_of(const Input& scene, const DeviationModel& model, const ScaleGroups& original,
                                     const ScaleGroups& scaled) {
  std::vector<std::string> warnings;
  for (const auto& [name, value] : named_groups(scaled)) {
    const auto at = model.ranges.find(name);
    if (at == model.ranges.end() || !std::isfinite(value)) continue;
    const GroupRange& range = at->second;
    const double slack = range_margin - 1;
    if (value > range.largest + slack * std::abs(range.largest) || value < range.least - slack * std::abs(range.least))
      warnings.push_back(fmt::format("{} is {:.3g}, outside {:.3g} to {:.3g}, to which the prediction was fitted", name, value, range.least,
                                     range.largest));
  }
  const Terms terms = terms_of(original, scaled);
  for (std::size_t i = 0; i < term_count; ++i) {
    const bool fitted = std::all_of(model.quantities.begin(), model.quantities.end(), [&](const QuantityModel& q) { return q.fitted[i]; });
    if (!fitted && std::abs(terms[i]) > 1e-6)
      warnings.push_back(
          fmt::format("{} matters here, and no study that the prediction was fitted to shows how much", deviation_terms[i].mechanism));
  }
  if (!original.sheared) warnings.emplace_back("nothing is sheared here, and the prediction was fitted to sheared flows");
  if (scene.cell.kind != CellKind::shear && original.sheared)
    warnings.emplace_back("the prediction was fitted to homogeneous shear; walls and their distance are not in it");
  if (original.jammed)
    warnings.emplace_back("the volume fraction is that of a jammed packing, and the prediction is that of the densest flow");
  if (original.bond > 0 && original.collisional_share < 0.5)
    warnings.push_back(fmt::format(
        "cohesion over pressure goes from {:.3g} to {:.3g}, which matters where contacts last; no study of that has been fitted",
        original.bond, scaled.bond));
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

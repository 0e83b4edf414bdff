#include <scalebreak/ensembles/prediction/deviation_model.hpp>

#include <algorithm>
#include <cmath>

#include <scalebreak/collisions/normal/pair_collision.hpp>

namespace scalebreak {
namespace {

/// Spheres stick below their sticking speed. Of impacts at random speeds a share that grows as its square does so, but what comes of it in a flow
/// grows as its first power (docs/prediction.md).
double sticking(const ScaleGroups& groups) { return 1 / groups.impact_over_sticking; }

}  // namespace

double beyond_model(const ScaleGroups& original, const ScaleGroups& scaled) {
  constexpr double more = 1.01;
  const double deep = scaled.overlap / deep_overlap, lumps = sticking(scaled) / lumps_beyond;
  const bool as_before = original.regime == FlowRegime::cooling && sticking(scaled) <= more * sticking(original);
  return (as_before ? deep : std::max(deep, lumps)) - 1;
}

Terms terms_of(const ScaleGroups& original, const ScaleGroups& scaled) {
  return {std::log((1 + scaled.busy) / (1 + original.busy)), scaled.jamming_share * std::log((1 + scaled.busy) / (1 + original.busy)),
          scaled.torque_lack * std::log(scaled.size), std::log((1 + sticking(scaled)) / (1 + sticking(original)))};
}

const std::vector<std::string>& predicted_quantities() {
  static const std::vector<std::string> names = {"temperature", "rotational_energy", "collision_rate", "pressure", "stress_xz"};
  return names;
}

double size_excess(const std::string& quantity) { return quantity == "collision_rate" ? 1 : 2; }

double size_term(double excess, const ScaleGroups& scaled) { return excess * scaled.collisional_share * std::log(scaled.size); }

Prediction predict(const QuantityModel& model, const ScaleGroups& original, const ScaleGroups& scaled) {
  const Terms terms = terms_of(original, scaled);
  Prediction prediction{.size = size_term(size_excess(model.quantity), scaled)};
  double logarithm = prediction.size, variance = 0, squares = prediction.size * prediction.size;
  for (std::size_t i = 0; i < term_count; ++i) {
    prediction.parts[i] = model.coefficients[i] * terms[i];
    logarithm += prediction.parts[i], squares += prediction.parts[i] * prediction.parts[i];
    for (std::size_t j = 0; j < term_count; ++j) variance += terms[i] * model.covariance[i][j] * terms[j];
  }
  variance += model.scatter * model.scatter * squares;
  prediction.deviation = {std::expm1(logarithm), std::exp(logarithm) * std::sqrt(variance)};
  return prediction;
}

}  // namespace scalebreak

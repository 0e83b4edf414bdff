#include <scalebreak/ensembles/prediction/cooling_prediction.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

constexpr double of_contact_time = 0.5;  ///< of what shear tells of contacts that last, its error in a gas that cools

/// Of what theory alone says of size and torque, its error (docs/prediction.md).
double of_theory(const std::string& quantity) { return quantity == "rotational_energy" ? 0.2 : 0.1; }

const QuantityModel& model_of(const std::vector<QuantityModel>& models, const std::string& quantity) {
  const auto at = std::find_if(models.begin(), models.end(), [&](const QuantityModel& each) { return each.quantity == quantity; });
  if (at == models.end()) throw WorkError(fmt::format("the prediction has no model of {}", quantity));
  return *at;
}

/// The power of 1 + contact time × collision rate by which a quantity ∝ T^n moves in shear at the same temperature.
double at_one_temperature(const std::vector<QuantityModel>& models, const std::string& quantity, double power) {
  return model_of(models, quantity).coefficients[0] - power * model_of(models, "temperature").coefficients[0];
}

std::size_t term(const char* name) {
  return static_cast<std::size_t>(std::find_if(std::begin(deviation_terms), std::end(deviation_terms),
                                               [&](const DeviationTerm& each) { return std::strcmp(each.name, name) == 0; }) -
                                  std::begin(deviation_terms));
}

/// ln of what is compared; a rotational energy that has not begun is left out.
double logarithm_of(const CooledGas& gas, const std::string& quantity) {
  if (quantity == "rotational_energy") return gas.mean.rotational > 0 ? std::log(gas.mean.rotational) : 0;
  return std::log(quantity == "collision_rate" ? gas.collision_rate : gas.mean.translational);
}

}  // namespace

Prediction predict_cooling(const std::vector<QuantityModel>& models, const std::string& quantity, const ScaleGroups& original,
                           const ScaleGroups& scaled) {
  const double rarer = at_one_temperature(models, "collision_rate", 0.5);
  const auto value = [&](const CoolingGas& gas) { return logarithm_of(cool(gas, rarer), quantity); };
  // From the original to the scaled gas in steps of one mechanism each.
  CoolingGas gas = original.gas;
  double last = value(gas);
  const auto step_to = [&] {
    const double before = std::exchange(last, value(gas));
    return last - before;
  };
  Prediction prediction;
  gas.collision_rate = scaled.gas.collision_rate, gas.collision.restitution = scaled.gas.collision.restitution;
  gas.busy = original.gas.busy;
  const double claim = quantity == "collision_rate" ? -std::log(scaled.size) : 0;
  prediction.size = step_to() - claim;
  gas.collision.inertia = scaled.gas.collision.inertia;
  // The energy of a sphere's spin has its true inertia, that of `mean.rotational` the one that torques meet.
  const double true_inertia = quantity == "rotational_energy" ? std::log(original.gas.collision.inertia / scaled.gas.collision.inertia) : 0;
  prediction.parts[term("torque")] = step_to() + true_inertia;
  gas.collision.sticking_speed = scaled.gas.collision.sticking_speed;
  const double adhesion = prediction.parts[term("sticking")] = step_to();
  gas = scaled.gas;
  double contact = step_to();
  if (quantity == "pressure") {
    const auto busy = [&](const CoolingGas& each) { return std::log1p(cool(each, rarer).busy); };
    contact += at_one_temperature(models, "pressure", 1) * (busy(scaled.gas) - busy(original.gas));
  }
  prediction.parts[term("contact_time")] = contact;
  const double logarithm = prediction.size + prediction.parts[term("torque")] + adhesion + contact;
  const double stick = sticking_share(scaled.gas.collision.sticking_speed, cool(scaled.gas, rarer).last_temperature) -
                       sticking_share(original.gas.collision.sticking_speed, cool(original.gas, rarer).last_temperature);
  const double error = std::hypot(std::hypot(of_theory(quantity) * prediction.size, of_theory(quantity) * prediction.parts[term("torque")]),
                                  of_contact_time * contact, std::abs(adhesion) + std::abs(stick));
  prediction.deviation = {std::expm1(logarithm), std::exp(logarithm) * error};
  return prediction;
}

Prediction predicted(const std::vector<QuantityModel>& models, const std::string& quantity, const ScaleGroups& original,
                     const ScaleGroups& scaled) {
  return original.regime == FlowRegime::cooling ? predict_cooling(models, quantity, original, scaled)
                                                : predict(model_of(models, quantity), original, scaled);
}

}  // namespace scalebreak

#pragma once

#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/deviation_model.hpp>

namespace scalebreak {

/// What a gas that cools under a scaling law does beside its original at one and the same time, by `cool` (cooling_gas.hpp), not by a fit to such gases: what larger
/// spheres, torques that fall short, impacts that stick and fewer collisions do. The last goes as in shear at the same temperature: of the collision rate
/// a₁(collision rate) − a₁(temperature)/2, of the pressure a₁(pressure) − a₁(temperature). `models` are those of all quantities.
[[nodiscard]] Prediction predict_cooling(const std::vector<QuantityModel>& models, const std::string& quantity, const ScaleGroups& original,
                                         const ScaleGroups& scaled);

/// The prediction of a quantity by the kind of flow: of a gas that cools `predict_cooling`, of others the fitted model.
[[nodiscard]] Prediction predicted(const std::vector<QuantityModel>& models, const std::string& quantity, const ScaleGroups& original,
                                   const ScaleGroups& scaled);

}  // namespace scalebreak

#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/measure/flow_result.hpp>

namespace scalebreak {

/// Each quantity by its name and `…_error`, the stresses as 3 × 3 rows; null where there is nothing to tell. `measured_time` [s] is what
/// the means are over, `outside` the mean number of spheres beyond open ends.
[[nodiscard]] nlohmann::json flow_json(const FlowResult& result);

/// What can be compared in such an object: its quantities, then the entries of its stresses ("stress_xz"), as far as they are there, in
/// the order of FlowResult. Null reads as NaN. WorkError where a value is neither a number nor null.
[[nodiscard]] std::vector<Quantity> quantities_of(const nlohmann::json& result);

/// Quantities and the entries of the stresses.
[[nodiscard]] std::vector<Quantity> all_quantities(const FlowResult& result);

}  // namespace scalebreak

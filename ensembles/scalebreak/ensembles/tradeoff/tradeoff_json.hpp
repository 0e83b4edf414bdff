#pragma once

#include <nlohmann/json.hpp>

#include <scalebreak/ensembles/tradeoff/collision_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/flow_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/method_tradeoff.hpp>

namespace scalebreak {

/// What `scalebreak tradeoff --json` prints; null where there is no number.
[[nodiscard]] nlohmann::json tradeoff_json(const CollisionTradeoff& study);
[[nodiscard]] nlohmann::json tradeoff_json(const FlowTradeoff& study);
[[nodiscard]] nlohmann::json tradeoff_json(const MethodTradeoff& study);

}  // namespace scalebreak

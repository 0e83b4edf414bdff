#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/tradeoff/collision_tradeoff.hpp>

namespace scalebreak {

/// Of those considered the one of least cost whose motion_rms is at most `error` and all of whose runs parted; none: null.
[[nodiscard]] const CollisionPoint* cheapest(const std::vector<CollisionPoint>& points, double error, double CollisionPoint::*cost,
                                             const std::function<bool(const CollisionPoint&)>& considered);

/// What to choose for which error, by wall time, a sentence each without its stop; beside a lookup or a formula what integrates, and what does so with
/// fewer evaluations.
[[nodiscard]] std::vector<std::string> choices(const CollisionTradeoff& study);

}  // namespace scalebreak

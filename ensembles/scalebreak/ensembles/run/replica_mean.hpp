#pragma once

#include <vector>

#include <scalebreak/measure/flow_result.hpp>

namespace scalebreak {

/// Means over replicas of one flow and their standard errors (pooled_mean.hpp); of a single run its own result. A quantity is a mean over
/// those replicas that have it.
[[nodiscard]] FlowResult replica_mean(const std::vector<FlowResult>& replicas);

}  // namespace scalebreak

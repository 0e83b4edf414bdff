#pragma once

#include <vector>

#include <Eigen/Core>

#include <scalebreak/measure/flow_result.hpp>
#include <scalebreak/measure/sums/velocity_profile.hpp>

namespace scalebreak {

/// What sums over successive blocks of a run (flow_sums.hpp) say of it; everything NaN and empty without blocks.
///
/// Every quantity is a ratio of sums. Fluctuations are about one profile of the whole run. Where it is fitted it minimises their
/// square, so that its own error moves the temperature's not at all to first order.
[[nodiscard]] FlowResult evaluate_flow(const std::vector<Eigen::ArrayXd>& blocks, ProfileKind kind, double shear_rate);

}  // namespace scalebreak

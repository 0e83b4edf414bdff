#pragma once

#include <scalebreak/measure/flow_result.hpp>
#include <scalebreak/measure/sums/block_ratios.hpp>

namespace scalebreak {

/// The quantities of each slab, with the sums of the whole run, the profile of its velocity, and the rate of homogeneous shear, or 0 [1/s]. Volume fraction by the spheres' exact
/// volume within the slab, contact stress by the share of each branch within it, the rest by the centres.
[[nodiscard]] FlowProfile evaluate_profile(const Blocks& blocks, const Eigen::ArrayXd& run, const VelocityProfile& profile,
                                           double shear_rate);

}  // namespace scalebreak

#pragma once

#include <vector>

#include <Eigen/Core>

#include <scalebreak/measure/sums/flow_sums.hpp>
#include <scalebreak/measure/sums/velocity_profile.hpp>
#include <scalebreak/statistics/standard_error.hpp>

namespace scalebreak {

using Blocks = std::vector<Eigen::ArrayXd>;

/// The mean and error of a quantity whose numerator and denominator are functions of a block's sums.
template <class Numerator, class Denominator>
[[nodiscard]] Measured ratio(const Blocks& blocks, Numerator numerator, Denominator denominator) {
  std::vector<double> numerators, denominators;
  for (const Eigen::ArrayXd& block : blocks) {
    numerators.push_back(numerator(block));
    denominators.push_back(denominator(block));
  }
  return ratio_of_sums(numerators, denominators);
}

/// Σ w (v − u)(v − u)ᵀ of a slab about a profile.
[[nodiscard]] inline Eigen::Matrix3d fluctuation(const Eigen::ArrayXd& sums, Eigen::Index slab, slab_entry::Entry weight,
                                                 const VelocityProfile& profile) {
  const auto k = static_cast<std::size_t>(slab);
  return spread(velocity_moments(sums, slab, weight), profile.edges[k], profile.edges[k + 1]);
}

/// The same of all slabs.
[[nodiscard]] inline Eigen::Matrix3d fluctuation(const Eigen::ArrayXd& sums, slab_entry::Entry weight, const VelocityProfile& profile) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (Eigen::Index k = 0; k < slab_count(sums); ++k) sum += fluctuation(sums, k, weight, profile);
  return sum;
}

}  // namespace scalebreak

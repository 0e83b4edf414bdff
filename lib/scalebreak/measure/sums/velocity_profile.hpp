#pragma once

#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// About which profile velocities count as fluctuations (W eq. 104: the mean at each particle's own height).
enum class ProfileKind {
  uniform,  ///< the mean velocity of all spheres
  imposed,  ///< of homogeneous shear, as the images impose it: the sums are about it already, each state's in its own cell
  fitted,   ///< between walls: linear across each slab, continuous, with the least squares of the whole measurement
};

[[nodiscard]] ProfileKind profile_kind(const Cell& cell);

struct VelocityProfile {
  std::vector<Eigen::Vector3d> edges;  ///< at the faces of the slabs, from below [m/s]
  Eigen::Index fitted_parameters = 0;  ///< of each component of the velocity
};

/// `sums` of a state or of a run (flow_sums.hpp).
[[nodiscard]] VelocityProfile velocity_profile(ProfileKind kind, const Eigen::ArrayXd& sums);

}  // namespace scalebreak

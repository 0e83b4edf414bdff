#include <scalebreak/measure/sums/velocity_profile.hpp>

#include <Eigen/QR>

#include <scalebreak/measure/sums/flow_state.hpp>
#include <scalebreak/measure/sums/flow_sums.hpp>

namespace scalebreak {
namespace {

using Components = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Least squares over hat functions with their nodes at the slabs' faces. Nodes that no sphere tells of are left at the least norm.
VelocityProfile fitted(const Eigen::ArrayXd& sums) {
  const Eigen::Index slabs = slab_count(sums);
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(slabs + 1, slabs + 1);
  Components flow = Components::Zero(slabs + 1, 3);
  for (Eigen::Index k = 0; k < slabs; ++k) {
    const VelocityMoments m = velocity_moments(sums, k, slab_entry::number);
    const Eigen::RowVector3d sum = m.segment<3>(3), placed = m.segment<3>(6);
    weights(k, k) += m[0] - 2 * m[1] + m[2];
    weights(k, k + 1) += m[1] - m[2];
    weights(k + 1, k) += m[1] - m[2];
    weights(k + 1, k + 1) += m[2];
    flow.row(k) += sum - placed;
    flow.row(k + 1) += placed;
  }
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(weights);
  const Components nodes = solver.solve(flow);
  VelocityProfile profile;
  for (const auto& node : nodes.rowwise()) profile.edges.emplace_back(node.transpose());
  profile.fitted_parameters = solver.rank();
  return profile;
}

}  // namespace

ProfileKind profile_kind(const Cell& cell) {
  if (homogeneous_shear(cell)) return ProfileKind::imposed;
  return cell.walled(2) ? ProfileKind::fitted : ProfileKind::uniform;
}

VelocityProfile velocity_profile(ProfileKind kind, const Eigen::ArrayXd& sums) {
  if (kind == ProfileKind::fitted) return fitted(sums);
  const Eigen::Index slabs = slab_count(sums);
  VelocityProfile profile;
  if (kind == ProfileKind::imposed) {
    profile.edges.assign(static_cast<std::size_t>(slabs + 1), Eigen::Vector3d::Zero());
    return profile;
  }
  double spheres = 0;
  Eigen::Vector3d flow = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < slabs; ++k) {
    const VelocityMoments m = velocity_moments(sums, k, slab_entry::number);
    spheres += m[0];
    flow += m.segment<3>(3).matrix();
  }
  if (spheres > 0) flow /= spheres;
  profile.edges.assign(static_cast<std::size_t>(slabs + 1), flow);
  return profile;
}

}  // namespace scalebreak

#pragma once

#include <Eigen/Core>

#include <scalebreak/measure/sums/velocity_moments.hpp>

namespace scalebreak {

/// What a flow is measured by, as sums in one array: first the whole cell's, then those of each slab of the gap, from below.
/// Of a state they are sums at an instant; of an interval, their integrals over time and what running totals gained.
namespace flow_entry {
enum Entry : Eigen::Index {
  contact_starts,
  work,         ///< by walls, gravity and homogeneous shear; of a state, the power of the latter through the kinetic stress
  energy_gain,  ///< of kinetic and elastic energy, about the imposed profile in homogeneous shear; of intervals alone
  dissipated,   ///< by the laws, as handed over; NaN where not
  duration,     ///< of a state 1, so that it integrates to time
  volume,
  gap,  ///< size of the cell along z
  solid,
  kinetic_energy,
  rotational_energy,
  in_contact,  ///< spheres with a contact
  crowded,     ///< spheres with more than one
  outside,     ///< spheres beyond the cell along z: in no slab
  spheres,
  contact_ends,    ///< spheres that contacts have: two, at a wall one
  contact_stress,  ///< nine, −Σ force branchᵀ, column by column [N m]
  count = contact_stress + 9
};
}  // namespace flow_entry

namespace slab_entry {
enum Entry : Eigen::Index {
  number,                                              ///< VelocityMoments of weight 1, in homogeneous shear about its profile
  mass = number + VelocityMoments::SizeAtCompileTime,  ///< VelocityMoments weighted by mass
  solid = mass + VelocityMoments::SizeAtCompileTime,
  rotational_energy,
  spin,
  contact_stress = spin + 3,  ///< nine, −Σ force branchᵀ, each contact by the share of its branch that lies in the slab
  count = contact_stress + 9
};
}  // namespace slab_entry

[[nodiscard]] inline Eigen::Index slab_count(const Eigen::ArrayXd& sums) { return (sums.size() - flow_entry::count) / slab_entry::count; }

/// Where an entry of a slab lies.
[[nodiscard]] inline Eigen::Index slab_index(Eigen::Index slab, Eigen::Index entry) {
  return flow_entry::count + slab * slab_entry::count + entry;
}

/// Of a slab; `weight` is slab_entry::number or mass.
[[nodiscard]] inline VelocityMoments velocity_moments(const Eigen::ArrayXd& sums, Eigen::Index slab, slab_entry::Entry weight) {
  return sums.segment<VelocityMoments::SizeAtCompileTime>(slab_index(slab, weight));
}

}  // namespace scalebreak

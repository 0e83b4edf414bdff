#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include <scalebreak/measure/contact_force.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// What an engine hands over to be measured at one instant. Running totals count from the start of the run; those that an engine
/// does not keep are left out, and what they are for is then taken from the samples, or not given.
struct Sample {
  const System& system;
  std::span<const ContactForce> contacts;
  double contact_starts = 0;  ///< total; of a sphere at a wall ½, as it happens to one sphere
  double work = 0;            ///< total, done on the spheres by walls and gravity, not by homogeneous shear [J]
  double elastic_energy = 0;  ///< of all contacts, now [J]

  /// Of contacts that are told without them the stress is from `contact_moment`, and that of the slabs is not known.
  bool forces_known = true;
  std::optional<double> shear_work;    ///< total, by homogeneous shear, −γ̇ ∫P_xz dt V [J]; else from the stress at samples
  std::optional<double> dissipated;    ///< total, taken by the laws [J]; without it there is no energy drift
  std::optional<double> contact_time;  ///< total over contacts, of a sphere at a wall ½ [s]; else from contacts at samples
  std::optional<Eigen::Matrix3d> contact_moment;  ///< total of −∫Σ force branchᵀ dt [N m s]; else from contacts at samples
};

}  // namespace scalebreak

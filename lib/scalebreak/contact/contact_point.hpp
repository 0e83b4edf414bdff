#pragma once

#include <Eigen/Core>

namespace scalebreak {

/// Where a contact stands: what tangential, rolling and liquid laws are functions of. The same fields hold the rates of
/// change, where a law asks for them.
template <class T>
struct ContactPointOf {
  T overlap = 0;       ///< δ [m]
  T root = 0;          ///< √a [m^{1/2}]; 0 of a linear contact
  T overlap_root = 0;  ///< (R*δ)^{1/4}, 0 for δ ≤ 0 [m^{1/2}]
  T load = 0;          ///< F_N, what friction is a share of [N]
};
using ContactPoint = ContactPointOf<double>;

/// A vector in the contact plane: one number where all motion is in one plane, else three.
template <int D>
using Tangent = Eigen::Matrix<double, D, 1>;

}  // namespace scalebreak

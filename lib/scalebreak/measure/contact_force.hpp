#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace scalebreak {

/// A contact as measurements see it.
struct ContactForce {
  std::int32_t first = 0, second = 0;  ///< as in ContactMemory
  bool touching = true;                ///< else only a liquid bridge holds them
  Eigen::Vector3d branch{0, 0, 0};     ///< from the first centre to the second's nearest image; to the wall's plane [m]
  Eigen::Vector3d force{0, 0, 0};      ///< on the first [N]
};

}  // namespace scalebreak

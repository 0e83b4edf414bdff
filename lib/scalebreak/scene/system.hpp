#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// What a contact remembers: histories of sliding and rolling as its laws keep them; under a direct-force law, the original pair's.
struct ContactMemory {
  std::int32_t first = 0, second = 0;  ///< indices of spheres; `second` below 0: the wall −1 − 2·axis (lower face) or −2 − 2·axis (upper)
  bool touching = true;                ///< else only a liquid bridge holds them
  double begun = 0;                    ///< time of first touch [s]
  Eigen::Vector3d sliding{0, 0, 0};  ///< of the first past the second: the spring's displacement [m]
  Eigen::Vector3d rolling{0, 0, 0};  ///< the spring's angle [rad], or its torque [N m], as the law keeps it
};

/// The number of the wall at a face, as `second` of a contact has it.
[[nodiscard]] constexpr std::int32_t wall_number(int axis, bool upper) { return -1 - 2 * axis - (upper ? 1 : 0); }

/// The state of a flow, what engines hand over to each other and files hold, SI. One entry a sphere in every list, in an order
/// that never changes.
struct System {
  double time = 0;
  Cell cell;
  std::vector<double> radius;          ///< [m]
  std::vector<double> mass;            ///< [kg]
  std::vector<std::uint8_t> material;  ///< 0: of [material], 1: of [second]
  std::vector<Eigen::Vector3d> position, velocity, spin;
  std::vector<ContactMemory> contacts;

  [[nodiscard]] std::size_t count() const { return position.size(); }
  /// Of a solid sphere about its centre [kg m²].
  [[nodiscard]] double inertia(std::size_t i) const { return 0.4 * mass[i] * radius[i] * radius[i]; }
};

}  // namespace scalebreak

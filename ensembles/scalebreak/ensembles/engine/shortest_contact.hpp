#pragma once

#include <array>
#include <string>

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// A speed at which spheres of a flow meet, and what makes them.
struct MeetingSpeed {
  std::string
      of;  ///< "speed at the start", "shear rate x diameter", "wall speed", "fall through the cell", "pressure"; empty: nothing moves
  double speed = 0;  ///< [m/s]
};

/// The fastest of what occurs in a cell of the scaled system, `size` its edges [m], whose spheres move at `speed` about the mean flow
/// [m/s]: that, what shear gives two of the largest spheres that pass each other, a moving wall, a fall through the cell, and what the pressure of a cell whose height follows it gives spheres of the
/// least density [kg/m³], √(P/ρ).
[[nodiscard]] MeetingSpeed fastest_meeting(const CellInput& cell, const Eigen::Vector3d& size, double largest_radius, double speed,
                                           double density);

/// Of the contacts that occur in a flow of the scaled system, the one that lasts least.
struct ShortestContact {
  MeetingSpeed meeting;
  double time = 0;  ///< [s]; 0: none, as nothing moves or every pair sticks
  std::string of;   ///< who meets: "[material] with [second]", "[material] with [wall]"
  bool tabulated = false;
  std::string resolved;  ///< why it is no table's, in words; empty if it is
};

/// The normal contacts of the smallest spheres of each material (`smallest` [m], of [material] and of [second], scaled; 0: none) with
/// each other and, if there are `walls`, with a wall: by the collision table of their kind, at the damping and the reduced speed of each.
/// A pair that sticks at the meeting's speed is looked at at twice its sticking speed, where it has a contact time. The collision is
/// resolved exactly, to 1e-6, where there are no tables (null), under a direct-force law, and where the table does not reach.
[[nodiscard]] ShortestContact shortest_contact(const Input& input, const std::array<double, 2>& smallest, bool walls,
                                               const MeetingSpeed& meeting, const TableStore* tables);

}  // namespace scalebreak

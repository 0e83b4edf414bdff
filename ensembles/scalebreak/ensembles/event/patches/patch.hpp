#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/dem/group/dem_group.hpp>
#include <scalebreak/ensembles/event/near/images.hpp>

namespace scalebreak {

/// The last collision of a sphere that was put as an instant, as it was at first touch: what it is taken back to where a third body comes
/// before the contact ends. Times are relative ones.
struct Encounter {
  double begin = 0;
  double end = -std::numeric_limits<double>::infinity();  ///< of the contact; since then the sphere has been on its present path
  std::uint32_t partner = 0;                              ///< a sphere, or a wall as no_neighbour has it
  Eigen::Vector3d position{0, 0, 0}, velocity{0, 0, 0}, spin{0, 0, 0};  ///< at `begin`
};

/// How a group sees one of its spheres that may be beyond a periodic face: moved by a vector of the cell, and by a velocity along x.
struct Offset {
  Eigen::Vector3d shift{0, 0, 0};  ///< at the group's time [m]
  double drift = 0;                ///< [m/s]
};

/// Spheres in contact with each other that an event-driven flow leaves to be integrated, one number a sphere of the group in each list.
struct Patch {
  DemGroup group;
  std::vector<std::uint32_t> sphere;  ///< in the flow
  std::vector<Offset> offset;
  double stretch = 0;        ///< time from one look at it to the next [s]
  std::vector<double> push;  ///< by how much others may change its velocity: what they have done of late, or are about to [m/s]

  void add(std::uint32_t number, const GroupSphere& sphere, const Offset& offset);
  /// The group's clock, with all that goes with it. `forget`: the time in which half of a push is forgotten [s].
  void advance_to(double time, double forget);
  /// How long it may go on unseen: `most` at most, less where spheres would come a noticeable part of their radius on.
  [[nodiscard]] double best_stretch(double most) const;
  /// Takes in another patch of the same time.
  void absorb(const Patch& other, const Offset& by);
  [[nodiscard]] Patch part(const std::vector<std::uint32_t>& which) const;
};

}  // namespace scalebreak

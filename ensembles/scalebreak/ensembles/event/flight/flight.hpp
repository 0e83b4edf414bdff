#pragma once

#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>
#include <scalebreak/ensembles/event/flight/flying_sphere.hpp>
#include <scalebreak/base/large_list.hpp>
#include <scalebreak/ensembles/event/near/images.hpp>
#include <scalebreak/ensembles/event/near/reference_bins.hpp>

namespace scalebreak {

/// What is next for a sphere: a neighbour that it meets, or one of these.
namespace no_neighbour {
inline constexpr std::uint32_t list_ends = most_flying_spheres;  ///< it may come near to spheres that are not in its list
inline constexpr std::uint32_t first_wall = list_ends + 1;       ///< and 2 · axis + (upper) more
}  // namespace no_neighbour

/// Beside its path, what a sphere knows of its surroundings: one cache line.
struct alignas(64) Agenda {
  Eigen::Vector3d reference{0, 0, 0};  ///< where it was when its list was made, carried by the flow to time 0 [m]
  double made = 0;                     ///< when
  double reach = 0;                    ///< radius and how far it may go from its reference [m]
  std::uint32_t start = 0;             ///< of its list in the pool
  std::uint16_t count = 0, capacity = 0;
  Neighbour partner{no_neighbour::list_ends, 0};  ///< of its next event
  std::uint32_t partner_changes = 0;              ///< of that one's path, when the event was foreseen
  std::uint32_t changes = 0;                      ///< of its own path
};
static_assert(sizeof(Agenda) == 64);

/// Spheres that fly freely, and who is near to whom. Times are relative: the cell is as it is at time 0.
///
/// Near are two spheres whose references are closer than the sum of their reaches. References move with the mean flow, so that a list lasts
/// as long in a sheared cell as in one at rest, but for what the flow itself brings them nearer: at most a share of rate/2 per time.
struct Flight {
  Cell cell;
  Images images{cell};
  Eigen::Vector3d gravity{0, 0, 0};
  double flow_rate = 0;                       ///< of the references along x with z [1/s]
  double allowance = 0;                       ///< how far a sphere may go from its reference [m]
  double least_reach = 0, largest_reach = 0;  ///< [m]
  LargeList<FlyingSphere> sphere;
  LargeList<Agenda> agenda;
  LargeList<Neighbour> pool;  ///< lists, each with room to grow
  ReferenceBins bins;

  [[nodiscard]] bool falls() const { return !gravity.isZero(0); }
  [[nodiscard]] Eigen::Vector3d position(std::uint32_t i, double now) const { return position_at<true>(sphere[i], now, gravity); }
  [[nodiscard]] Eigen::Vector3d velocity(std::uint32_t i, double now) const { return velocity_at<true>(sphere[i], now, gravity); }
  /// Of a reference, along x.
  [[nodiscard]] double flow_at(double height) const { return flow_rate * (height - cell.size.z() / 2); }
  /// How fast the flow may bring references within reach together, for each of two spheres.
  [[nodiscard]] double shrinking(const Agenda& agenda_of) const { return std::abs(flow_rate) * agenda_of.reach / 2; }
};

/// Brings a sphere to `now` on its path.
inline void bring_up(Flight& flight, std::uint32_t i, double now) {
  FlyingSphere& sphere = flight.sphere[i];
  sphere.position = flight.position(i, now);
  sphere.velocity = flight.velocity(i, now);
  sphere.time = now;
}

}  // namespace scalebreak

#include <scalebreak/ensembles/event/flight/foresee.hpp>

#include <scalebreak/ensembles/event/flight/instants.hpp>
#include <scalebreak/ensembles/event/flight/see_neighbours.hpp>

namespace scalebreak {
namespace {

/// When a sphere may have come to the end of its list; under gravity not later than that.
double list_end(const Flight& flight, const Agenda& own, const Eigen::Vector3d& position, const Eigen::Vector3d& velocity, double now) {
  const double flow = flight.flow_at(own.reference.z()), shrinking = flight.shrinking(own);
  const double allowance = flight.allowance - shrinking * (now - own.made);
  const Eigen::Vector3d away = position - own.reference - Eigen::Vector3d(flow * now, 0, 0);
  const Eigen::Vector3d relative = velocity - Eigen::Vector3d(flow, 0, 0);
  if (!flight.falls()) return time_to_leave(away, relative, allowance, shrinking);
  // A quarter of what is left is for the fall, the rest for the line.
  const double fall = std::max(0.0, allowance - away.norm()) / 4;
  return std::min(std::sqrt(2 * fall / flight.gravity.norm()), time_to_leave(away, relative, allowance - fall, shrinking));
}

void see_walls(const Flight& flight, const Eigen::Vector3d& position, const Eigen::Vector3d& velocity, double radius, Foreseen& next) {
  for (const int axis : {0, 1, 2}) {
    if (!flight.cell.walled(axis)) continue;
    for (const bool upper : {false, true}) {
      const double side = upper ? -1 : 1, height = upper ? flight.cell.size[axis] - position[axis] : position[axis];
      const double wait = time_to_wall(height, side * velocity[axis], side * flight.gravity[axis], radius);
      if (wait < next.wait) next = {wait, {no_neighbour::first_wall + static_cast<std::uint32_t>(2 * axis + upper), 0}};
    }
  }
}

}  // namespace

Foreseen foresee(const Flight& flight, std::uint32_t i, double now) {
  const Agenda& own = flight.agenda[i];
  const FlyingSphere here{flight.position(i, now), now, flight.velocity(i, now), flight.sphere[i].radius};
  Foreseen next{list_end(flight, own, here.position, here.velocity, now), {no_neighbour::list_ends, 0}};
  see_walls(flight, here.position, here.velocity, here.radius, next);
  const std::span<const Neighbour> list{flight.pool.data() + own.start, own.count};
  for (const Neighbour neighbour : list) __builtin_prefetch(&flight.sphere[neighbour.sphere()]);
  static const bool by_fours = can_see_by_fours();
  (by_fours ? see_neighbours_by_fours : see_neighbours)(flight, list, here, next);
  return next;
}

}  // namespace scalebreak

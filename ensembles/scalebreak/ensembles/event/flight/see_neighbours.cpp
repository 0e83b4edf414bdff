#include <scalebreak/ensembles/event/flight/see_neighbours.hpp>

#include <scalebreak/ensembles/event/flight/instants.hpp>

namespace scalebreak {
namespace {

template <bool falls>
void see(const Flight& flight, std::span<const Neighbour> list, const FlyingSphere& here, Foreseen& next) {
  for (const Neighbour neighbour : list) {
    const FlyingSphere& other = flight.sphere[neighbour.sphere()];
    const Images::Image& image = flight.images[neighbour.image()];
    const Eigen::Vector3d apart = position_at<falls>(other, here.time, flight.gravity) + image.shift_at(here.time) - here.position;
    Eigen::Vector3d relative = velocity_at<falls>(other, here.time, flight.gravity) - here.velocity;
    relative.x() += image.drift;
    const double wait = time_to_meet(apart, relative, here.radius + other.radius);
    if (wait < next.wait) next = {wait, neighbour};
  }
}

}  // namespace

void see_neighbours(const Flight& flight, std::span<const Neighbour> list, const FlyingSphere& here, Foreseen& next) {
  (flight.falls() ? see<true> : see<false>)(flight, list, here, next);
}

}  // namespace scalebreak

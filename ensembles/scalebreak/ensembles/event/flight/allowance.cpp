#include <scalebreak/ensembles/event/flight/allowance.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/event/near/images.hpp>
#include <scalebreak/start/filling.hpp>

namespace scalebreak {
namespace {

double largest_radius(const System& system) { return *std::max_element(system.radius.begin(), system.radius.end()); }

double shortest_periodic_edge(const Cell& cell) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const int axis : {0, 1, 2}) {
    if (cell.periodic(axis)) shortest = std::min(shortest, cell.size[axis]);
  }
  return shortest;
}

}  // namespace

double fast_allowance(const System& system) {
  double mean = 0;
  for (const double radius : system.radius) mean += radius / static_cast<double>(system.count());
  const double dense = volume_fraction(system.cell, system.radius);
  const double fast = mean * std::clamp(0.32 * std::pow(dense, -0.7), 0.3, 2.0);
  // Lists reach at most half of a periodic edge.
  return std::min(fast, 0.999 * (shortest_periodic_edge(system.cell) / 4 - largest_radius(system)));
}

void check_room_for_lists(const System& system, double allowance) {
  if (system.count() > most_flying_spheres)
    throw InputError(
        fmt::format("particles.count: found {}; allowed: at most {} in an event-driven run", system.count(), most_flying_spheres));
  constexpr double least_share = 0.02;  // of the radius: below, a sphere would hardly do anything but look for neighbours
  const double radius = largest_radius(system), edge = shortest_periodic_edge(system.cell);
  if (edge < 4 * (radius + std::max(allowance, least_share * radius)))
    throw InputError(
        fmt::format("cell.size: found a periodic edge of {:g} m; allowed: at least {:g} m in an event-driven run, so that lists of "
                    "neighbours end before half of it",
                    edge, 4 * (1 + least_share) * radius));
}

}  // namespace scalebreak

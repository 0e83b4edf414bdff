#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/queue/reference_queue.hpp>
#include <scalebreak/ensembles/event/rules/constant_restitution.hpp>
#include <scalebreak/start/filling.hpp>

// Speed of the event-driven engine in collisions per second of processor time:
//
//     scalebreak_event_speed                      20 000 spheres at volume fractions of 0.1, 0.3 and 0.5, both queues
//     scalebreak_event_speed sizes                queue operations and time a collision from 10³ to 10⁶ spheres
//     scalebreak_event_speed SPHERES FRACTION [ALLOWANCE/DIAMETER [COLLISIONS]]

namespace {

using namespace scalebreak;

System gas(std::size_t spheres, double volume_fraction) {
  Filling filling;
  filling.radius.assign(spheres, 0.5);
  filling.mass.assign(spheres, 1);
  filling.material.assign(spheres, 0);
  filling.cell.size = Eigen::Vector3d::Constant(std::cbrt(static_cast<double>(spheres) * std::numbers::pi / 6 / volume_fraction));
  filling.speed = std::sqrt(3.0);
  return fill(filling);
}

/// After five collisions a sphere, so that the gas has forgotten its filling.
template <class Queue, class Rule>
void measure(const char* what, const System& start, double volume_fraction, const Rule& rule, double allowance, long collisions) {
  EventSpheres<Queue, Rule> flow(start, {.allowance = allowance}, rule);
  flow.advance_collisions(5 * static_cast<long>(start.count()));
  const EventTotals before = flow.totals();
  const std::uint64_t operations = flow.queue_operations();
  const std::clock_t began = std::clock();
  flow.advance_collisions(collisions);
  const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, each = 1 / static_cast<double>(collisions);
  fmt::print("{:>8} {:>5g}  {:<24}{:>10.3g}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}\n", start.count(), volume_fraction, what, 1 / (each * seconds),
             each * static_cast<double>(flow.totals().lists - before.lists), each * static_cast<double>(flow.totals().stale - before.stale),
             flow.mean_neighbours(), each * static_cast<double>(flow.queue_operations() - operations));
}

void print_header() {
  fmt::print("{:>8} {:>5}  {:<24}{:>10}{:>9}{:>9}{:>9}{:>9}\n", "spheres", "phi", "", "coll./s", "lists", "stale", "near", "queue");
}

}  // namespace

int main(int count, char** words) {
  print_header();
  if (count > 2) {
    const System start = gas(std::strtoul(words[1], nullptr, 10), std::atof(words[2]));
    measure<CalendarQueue>("elastic", start, std::atof(words[2]), SmoothRule{1.0}, count > 3 ? std::atof(words[3]) : 0.0,
                           count > 4 ? std::atol(words[4]) : 1'000'000);
    return 0;
  }
  if (count == 2 && std::string(words[1]) == "sizes") {
    for (const std::size_t spheres : {1'000ul, 10'000ul, 100'000ul, 1'000'000ul})
      measure<CalendarQueue>("elastic", gas(spheres, 0.3), 0.3, SmoothRule{1.0}, 0, std::max(500'000l, static_cast<long>(spheres)));
    return 0;
  }
  for (const double volume_fraction : {0.1, 0.3, 0.5}) {
    const System start = gas(20'000, volume_fraction);
    measure<CalendarQueue>("elastic", start, volume_fraction, SmoothRule{1.0}, 0, 1'000'000);
    measure<CalendarQueue>("rough", start, volume_fraction, RoughRule{1.0, 1.0}, 0, 1'000'000);
    measure<ReferenceQueue>("elastic, sorted tree", start, volume_fraction, SmoothRule{1.0}, 0, 1'000'000);
  }
  return 0;
}

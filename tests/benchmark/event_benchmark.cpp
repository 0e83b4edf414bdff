#include <algorithm>
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
#include <scalebreak/ensembles/event/rules/table_rule.hpp>
#include <scalebreak/start/check_overlap.hpp>
#include <scalebreak/start/filling.hpp>

#include "lib/resolving.hpp"

// Speed of the event-driven engine in collisions per second of processor time:
//
//     scalebreak_event_speed                      20 000 spheres at volume fractions of 0.1, 0.3 and 0.5, both queues
//     scalebreak_event_speed sizes                queue operations and time a collision from 10³ to 10⁶ spheres
//     scalebreak_event_speed tables               smooth elastic spheres and rough ones by table in turns, and the ratio
//     scalebreak_event_speed overlaps [SPHERES [FRACTION [COLLISIONS]]]      the deepest overlap that ever was
//     scalebreak_event_speed SPHERES FRACTION [ALLOWANCE/DIAMETER [COLLISIONS]]

namespace {

using namespace scalebreak;

System gas(std::size_t spheres, double volume_fraction, double radius = 0.5, double mass = 1, double speed = std::sqrt(3.0)) {
  Filling filling;
  filling.radius.assign(spheres, radius);
  filling.mass.assign(spheres, mass);
  filling.material.assign(spheres, 0);
  filling.cell.size =
      Eigen::Vector3d::Constant(2 * radius * std::cbrt(static_cast<double>(spheres) * std::numbers::pi / 6 / volume_fraction));
  filling.speed = speed;
  return fill(filling);
}

/// After five collisions a sphere, so that the gas has forgotten its filling.
template <class Queue, class Rule>
double measure(const char* what, const System& start, double volume_fraction, Rule rule, double allowance, long collisions) {
  EventSpheres<Queue, Rule> flow(start, {.allowance = allowance}, std::move(rule));
  flow.advance_collisions(5 * static_cast<long>(start.count()));
  const EventTotals before = flow.totals();
  const std::uint64_t operations = flow.queue_operations();
  const std::clock_t began = std::clock();
  flow.advance_collisions(collisions);
  const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, each = 1 / static_cast<double>(collisions);
  fmt::print("{:>8} {:>5g}  {:<24}{:>10.3g}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}\n", start.count(), volume_fraction, what, 1 / (each * seconds),
             each * static_cast<double>(flow.totals().lists - before.lists), each * static_cast<double>(flow.totals().stale - before.stale),
             flow.mean_neighbours(), each * static_cast<double>(flow.queue_operations() - operations));
  if constexpr (requires { flow.rule().integrated(); })
    fmt::print("{:>16}{:.2g} of them integrated, as no table answered\n", "",
               static_cast<double>(flow.rule().integrated()) / static_cast<double>(flow.totals().collisions));
  return 1 / (each * seconds);
}

void print_header() {
  fmt::print("{:>8} {:>5}  {:<24}{:>10}{:>9}{:>9}{:>9}{:>9}\n", "spheres", "phi", "", "coll./s", "lists", "stale", "near", "queue");
}

/// Washino et al. 2024, Table 9, without adhesion: Hertz and Mindlin by table as `run --engine event` has them, beside smooth elastic spheres from the same
/// start. A gas that cools: after five collisions a sphere, ten more; in turns, as the machine may be shared.
void compare_with_tables() {
  const Input input = tests::resolved(
      "[material]\nyoung = 10e9\npoisson = 0.25\ndensity = 2500\nrestitution = 0.81\nsliding_friction = 0.3\nsurface_energy = 0\n"
      "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\n[particles]\ncount = 1000\n[cell]\nkind = \"cooling\"\n");
  const TableStore store{.folder = default_table_folder()};
  constexpr std::size_t spheres = 20'000;
  constexpr double radius = 0.5e-3, speed = 0.1;
  constexpr long collisions = 10 * spheres;
  for (const double volume_fraction : {0.1, 0.3, 0.5}) {
    const System start = gas(spheres, volume_fraction, radius, sphere_mass(radius, input.material.density), speed);
    std::vector<double> ratios;
    for (int turn = 0; turn < 5; ++turn) {
      const double smooth = measure<CalendarQueue>("smooth, elastic", start, volume_fraction, SmoothRule{1.0}, 0, collisions);
      const double rough = measure<CalendarQueue>("rough, by table", start, volume_fraction,
                                                  TableRule(input, kinds_of(start), store, {.turning = 1e-2}), 0, collisions);
      ratios.push_back(rough / smooth);
    }
    std::sort(ratios.begin(), ratios.end());
    fmt::print("{:>16}ratio {:.2f} ({:.2f} to {:.2f})\n", "", ratios[ratios.size() / 2], ratios.front(), ratios.back());
  }
}

/// Of elastic spheres, looked at after each half collision a sphere.
void look_for_overlaps(std::size_t spheres, double volume_fraction, long collisions) {
  const System start = gas(spheres, volume_fraction);
  EventSpheres<CalendarQueue, SmoothRule> flow(start, {}, SmoothRule{1.0});
  const auto energy = [](const System& system) {
    double sum = 0;
    for (const Eigen::Vector3d& velocity : system.velocity) sum += velocity.squaredNorm();
    return sum;
  };
  double deepest = 0;
  long looks = 0;
  while (flow.totals().collisions < collisions) {
    flow.advance_collisions(std::min(static_cast<long>(spheres) / 2, collisions - flow.totals().collisions));
    deepest = std::max(deepest, -least_gap_ratio(flow.system(), 0.0)), ++looks;
  }
  const EventTotals& totals = flow.totals();
  fmt::print(
      "{} spheres at {:g}: {} collisions, {} lists, {} events overtaken, {} renewals; the deepest overlap in {} looks is {:.2g} of the radii, energy "
      "changed by {:.2g}\n",
      spheres, volume_fraction, totals.collisions, totals.lists, totals.stale, totals.renewals, looks, deepest,
      energy(flow.system()) / energy(start) - 1);
}

}  // namespace

int main(int count, char** words) {
  const std::string what = count > 1 ? words[1] : "";
  if (what == "overlaps") {
    look_for_overlaps(count > 2 ? std::strtoul(words[2], nullptr, 10) : 4000, count > 3 ? std::atof(words[3]) : 0.3,
                      count > 4 ? std::atol(words[4]) : 10'000'000);
    return 0;
  }
  print_header();
  if (what == "tables") {
    compare_with_tables();
    return 0;
  }
  if (count > 2) {
    const System start = gas(std::strtoul(words[1], nullptr, 10), std::atof(words[2]));
    measure<CalendarQueue>("elastic", start, std::atof(words[2]), SmoothRule{1.0}, count > 3 ? std::atof(words[3]) : 0.0,
                           count > 4 ? std::atol(words[4]) : 1'000'000);
    return 0;
  }
  if (what == "sizes") {
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

#include <scalebreak/ensembles/engine/event_engine.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/ensembles/event/saved_list.hpp>
#include <scalebreak/start/filling.hpp>

namespace scalebreak {
namespace {

/// Of a collision's velocities, over its normal speed: what the turning of a contact may leave out before it is integrated. A flow forgets
/// errors of single collisions that lean to no side; a pair's own collision is asked for with a hundredth of it.
constexpr PairTolerance flow_tolerance{.turning = 1e-2};

TableRule saved_rule(std::string_view& saved, const Input& input, const TableStore& store) {
  std::vector<SphereKind> kinds;
  take_list(saved, kinds);
  TableRule rule(input, std::move(kinds), store, flow_tolerance);
  rule.load(saved);
  return rule;
}

/// The rule takes its part off the front first.
EventSpheres<CalendarQueue, TableRule> saved_spheres(std::string_view saved, const Input& input, const TableStore& store) {
  TableRule rule = saved_rule(saved, input, store);
  return {saved, {.gravity = input.cell.gravity}, std::move(rule)};
}

}  // namespace

EventEngine::EventEngine(const System& start, const Input& input, const TableStore& store)
    : spheres_(start, {.gravity = input.cell.gravity}, TableRule(input, kinds_of(start), store, flow_tolerance)) {}

EventEngine::EventEngine(std::string_view saved, const Input& input, const TableStore& store) : spheres_(saved_spheres(saved, input, store)) {}

EngineTotals EventEngine::totals() const {
  const EventTotals& totals = spheres_.totals();
  const long events = totals.collisions + totals.wall_collisions;
  return {.contact_starts = static_cast<double>(totals.collisions) + static_cast<double>(totals.wall_collisions) / 2,
          .wall_work = totals.wall_work,
          .shear_work = {},  // its kinetic part is taken at samples
          .dissipated = totals.dissipated,
          .contact_time = totals.contact_time,
          .contact_moment = totals.contact_moment,
          .events = events,
          .integrated = spheres_.rule().integrated(),
          .delayed = spheres_.rule().delayed()};
}

std::string EventEngine::save() const {
  std::string bytes;
  put_list(bytes, spheres_.rule().kinds());
  spheres_.rule().save(bytes);
  return bytes + spheres_.save();
}

double event_sample_interval(const System& start, double speed) {
  constexpr double collisions_each = 4;
  if (speed == 0) return std::numeric_limits<double>::infinity();
  double square = 0;
  for (const double radius : start.radius) square += 4 * radius * radius;  // n d² V
  const double dense = volume_fraction(start.cell, start.radius), contact_value = (1 - dense / 2) / std::pow(1 - dense, 3);
  const double rate = 4 * square / start.cell.volume() * contact_value * std::sqrt(std::numbers::pi / 3) * speed;
  return collisions_each / rate;
}

}  // namespace scalebreak

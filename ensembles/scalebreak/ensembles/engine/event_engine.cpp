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

Unanswered unanswered(const GroupLaws* groups) { return groups ? Unanswered::leave : Unanswered::integrate; }

std::unique_ptr<GroupLaws> group_laws(const std::optional<DemSetup>& setup, const Cell& cell, const SphereKinds& kinds) {
  if (!setup) return nullptr;
  std::vector<dem::LawRows::Kind> of_groups;
  for (const SphereKind& kind : kinds.kinds) of_groups.push_back({kind.radius, kind.material});
  return std::make_unique<GroupLaws>(*setup, cell, of_groups, kinds.many);
}

/// What is saved before all else, taken off the front.
std::pair<Cell, SphereKinds> take_head(std::string_view& saved) {
  std::vector<Cell> cell;
  SphereKinds kinds;
  take_list(saved, cell), take_list(saved, kinds.kinds), take_bytes(saved, kinds.many);
  return {cell.front(), kinds};
}

std::unique_ptr<GroupLaws> saved_group_laws(const std::optional<DemSetup>& setup, std::string_view saved) {
  const auto [cell, kinds] = take_head(saved);
  return group_laws(setup, cell, kinds);
}

/// The rule takes its part off the front first.
EventSpheres<CalendarQueue, TableRule> saved_spheres(std::string_view saved, const Input& input, const TableStore& store,
                                                     const GroupLaws* groups) {
  TableRule rule(input, take_head(saved).second, store, flow_tolerance, unanswered(groups));
  rule.load(saved);
  return {saved, {.gravity = input.cell.gravity, .groups = groups}, std::move(rule)};
}

}  // namespace

EventEngine::EventEngine(const System& start, const Input& input, const TableStore& store, const std::optional<DemSetup>& groups)
    : groups_(group_laws(groups, start.cell, kinds_of(start))),
      spheres_(start, {.gravity = input.cell.gravity, .groups = groups_.get()},
               TableRule(input, kinds_of(start), store, flow_tolerance, unanswered(groups_.get()))) {}

EventEngine::EventEngine(std::string_view saved, const Input& input, const TableStore& store, const std::optional<DemSetup>& groups)
    : groups_(saved_group_laws(groups, saved)), spheres_(saved_spheres(saved, input, store, groups_.get())) {}

EngineTotals EventEngine::totals() const {
  const EventTotals& totals = spheres_.totals();
  const long events = totals.collisions + totals.wall_collisions;
  return {.contact_starts = static_cast<double>(totals.collisions) + static_cast<double>(totals.wall_collisions) / 2 + totals.patch_starts,
          .wall_work = totals.wall_work,
          .shear_work = {},  // its kinetic part is taken at samples
          .dissipated = totals.dissipated,
          .contact_time = totals.contact_time,
          .contact_moment = totals.contact_moment,
          .evaluations = totals.patch_evaluations,
          .events = events,
          .integrated = groups_ ? 0 : spheres_.rule().integrated(),
          .delayed = spheres_.rule().delayed(),
          .patches = groups_ ? std::optional(PatchTotals{.begun = totals.patches,
                                                         .taken_back = totals.taken_back,
                                                         .unresolved = spheres_.rule().integrated(),
                                                         .sphere_steps = totals.patch_steps,
                                                         .contact_starts = totals.patch_starts,
                                                         .sphere_time = totals.patch_time})
                             : std::nullopt};
}

System EventEngine::soft_system() {
  spheres_.open_contacts();
  return spheres_.system();
}

std::string EventEngine::save() const {
  std::string bytes;
  put_list(bytes, std::vector<Cell>{spheres_.cell()});
  put_list(bytes, spheres_.rule().kinds().kinds), put_bytes(bytes, spheres_.rule().kinds().many);
  spheres_.rule().save(bytes);
  return bytes + spheres_.save();
}

double enskog_rate(double crowd, double volume_fraction, double speed) {
  const double contact_value = (1 - volume_fraction / 2) / std::pow(1 - volume_fraction, 3);
  return 4 * crowd * contact_value * std::sqrt(std::numbers::pi / 3) * speed;
}

double event_sample_interval(const System& start, double speed) {
  constexpr double collisions_each = 4;
  if (speed == 0) return std::numeric_limits<double>::infinity();
  double square = 0;
  for (const double radius : start.radius) square += 4 * radius * radius;
  return collisions_each / enskog_rate(square / start.cell.volume(), volume_fraction(start.cell, start.radius), speed);
}

}  // namespace scalebreak

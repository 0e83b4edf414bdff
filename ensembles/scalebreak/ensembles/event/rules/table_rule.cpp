#include <scalebreak/ensembles/event/rules/table_rule.hpp>

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>
#include <scalebreak/scaling/scaling_law.hpp>

namespace scalebreak {
namespace {

constexpr const char* other_engine = "--engine dem, which integrates every contact";

/// The scene of two spheres of a flow, or of one and its wall, original system.
Input pair_input(const Input& flow, const std::vector<std::pair<double, std::uint8_t>>& spheres) {
  Input pair = flow;
  pair.flow = false;
  pair.bodies.clear();
  pair.against_wall = spheres.size() == 1;
  const double size = size_factor(*find_scaling_law(flow.scaling_law), flow.scaling_factor);
  pair.radius.clear();
  for (const auto& [radius, material] : spheres) pair.radius.push_back(radius / size);
  const auto material = [&](std::size_t k) { return spheres[k].second == 0 ? flow.material : flow.second; };
  pair.material = material(0);
  if (!pair.against_wall) pair.second = material(1);
  return pair;
}

/// Tables of a pair, or of all its sizes. Null where none can serve and what is not answered is left.
template <class Tables, class... Ranges>
std::unique_ptr<Tables> tables_of(const Input& pair, const TableStore& store, const PairTolerance& tolerance, Unanswered unanswered,
                                  const Ranges&... ranges) {
  const bool leaves = unanswered == Unanswered::leave;
  if (leaves && (find_scaling_law(pair.scaling_law)->direct_force || pair.surface.attraction != Attraction::none)) return nullptr;
  auto tables = std::make_unique<Tables>(pair, ranges..., store, tolerance);
  if (const Refusal refusal = tables->standing_refusal(); refusal != Refusal::none) {
    if (leaves) return nullptr;
    throw InputError(
        fmt::format("contact: between spheres of radii {} m no collision table can serve ({}); allowed in an event-driven run: laws and "
                    "sizes that have one, or {}",
                    fmt::join(pair.radius, " and "), to_string(refusal), other_engine));
  }
  return tables;
}

/// Of the kinds of one material.
std::optional<RadiusRange> range_of(const std::vector<SphereKind>& kinds, std::uint8_t material) {
  std::optional<RadiusRange> range;
  for (const SphereKind& kind : kinds) {
    if (kind.material != material) continue;
    if (!range) range = {kind.radius, kind.radius};
    range = {std::min(range->least, kind.radius), std::max(range->largest, kind.radius)};
  }
  return range;
}

}  // namespace

void refuse_height_that_follows(const Input& input) {
  if (input.cell.kind == CellKind::confined_shear)
    throw InputError(
        fmt::format("cell.kind: found \"confined_shear\", whose height follows the stress of every step, which collisions as instants do "
                    "not have; allowed in an event-driven or hybrid run: \"shear\", \"couette\", \"cooling\" or \"box\", or {}",
                    other_engine));
}

void refuse_laws_without_tables(const Input& input) {
  if (find_scaling_law(input.scaling_law)->direct_force)
    throw InputError(
        fmt::format("scaling.law: found \"{}\", which maps forces and has no collision tables; allowed in an event-driven run: laws "
                    "that scale the material, or {}",
                    input.scaling_law, other_engine));
  if (input.surface.attraction != Attraction::none)
    throw InputError(
        fmt::format("contact.attraction: found a liquid, which acts at a distance and has no collision tables; allowed in an "
                    "event-driven run: \"none\", or {}",
                    other_engine));
}

std::string why_no_tables(const Input& input) {
  const double size = size_factor(*find_scaling_law(input.scaling_law), input.scaling_factor), radius = size * input.particles.radius;
  const Input pair = pair_input(input, {{radius, 0}, {radius, 0}});
  const bool many = input.particles.size != SizeKind::mono && input.particles.size != SizeKind::bidisperse;
  if (pair.surface.tangential != TangentialModel::none) {
    const ObliqueKeyOrReason oblique = oblique_key(pair, 1e-4);
    if (!oblique.key) return oblique.reason;
    if (many && !sizes_share_oblique(oblique.key->kind, pair.surface, false))
      return pair.surface.torque_arm == TorqueArm::contact ? "torque arms that end at the contact are other ones for every two radii"
                                                           : "a linear tangential spring beside adhesion is another one at every size";
  }
  if (pair.surface.rolling == RollingModel::none) return "";
  return rolling_key(pair, 1e-4).reason;
}

SphereKinds kinds_of(const System& system) {
  SphereKinds found;
  std::vector<SphereKind>& kinds = found.kinds;
  for (std::size_t i = 0; i < system.count() && kinds.size() <= TableRule::most_kinds; ++i) {
    const SphereKind kind{system.radius[i], system.material[i]};
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  if (kinds.size() <= TableRule::most_kinds) return found;
  found.many = true;
  kinds.clear();
  for (const std::uint8_t material : {std::uint8_t{0}, std::uint8_t{1}}) {
    const SphereKind none{};
    SphereKind least = none, largest = none;
    for (std::size_t i = 0; i < system.count(); ++i) {
      if (system.material[i] != material) continue;
      const SphereKind kind{system.radius[i], material};
      if (least.radius == 0 || kind.radius < least.radius) least = kind;
      if (kind.radius > largest.radius) largest = kind;
    }
    if (largest.radius > 0) kinds.push_back(least), kinds.push_back(largest);
  }
  return found;
}

TableRule::TableRule(const Input& input, SphereKinds kinds, const TableStore& store, const PairTolerance& tolerance, Unanswered unanswered)
    : kinds_(std::move(kinds)), unanswered_(unanswered), wall_no_slip_(input.cell.wall_no_slip) {
  refuse_height_that_follows(input);
  if (unanswered == Unanswered::integrate) refuse_laws_without_tables(input);
  const auto& boundary = input.cell.boundary;
  // While it touches a wall that stops spins a sphere has none: it is braked as if it could not turn, which no table tells.
  const bool turns = input.surface.tangential != TangentialModel::none || input.surface.rolling != RollingModel::none;
  const bool walls = std::find(boundary.begin(), boundary.end(), Boundary::wall) != boundary.end(),
             is_left = walls && wall_no_slip_ && turns, walled = walls && !is_left;
  if (is_left && unanswered == Unanswered::integrate)
    throw InputError(fmt::format(
        "cell.wall_no_slip: found true beside friction or rolling resistance: a sphere that cannot turn while it touches has no "
        "collision table; allowed in an event-driven run: false, or --engine hybrid, or {}",
        other_engine));
  if (kinds_.many) {
    obtain_shared(input, store, tolerance, walled);
    return;
  }
  for (const SphereKind& first : kinds_.kinds) {
    for (const SphereKind& second : kinds_.kinds)
      pairs_.push_back(tables_of<PairResolver>(pair_input(input, {{first.radius, first.material}, {second.radius, second.material}}), store,
                                               tolerance, unanswered));
    if (walled)
      walls_.push_back(tables_of<PairResolver>(pair_input(input, {{first.radius, first.material}}), store, tolerance, unanswered));
  }
}

void TableRule::obtain_shared(const Input& input, const TableStore& store, const PairTolerance& tolerance, bool walled) {
  for (const std::uint8_t first : {std::uint8_t{0}, std::uint8_t{1}}) {
    const std::optional<RadiusRange> own = range_of(kinds_.kinds, first);
    if (!own) continue;
    for (const std::uint8_t second : {std::uint8_t{0}, std::uint8_t{1}}) {
      const std::optional<RadiusRange> other = range_of(kinds_.kinds, second);
      if (!other) continue;
      const Input pair = pair_input(input, {{own->least, first}, {other->largest, second}});
      shared_[2 * first + second] = tables_of<SizeTables>(pair, store, tolerance, unanswered_, *own, *other);
    }
    if (walled)
      shared_walls_[first] =
          tables_of<SizeTables>(pair_input(input, {{own->least, first}}), store, tolerance, unanswered_, *own, RadiusRange{});
  }
}

std::size_t TableRule::kind_of(const Meeting::Body& body) const {
  std::size_t kind = 0;
  while (kinds_.kinds[kind] != SphereKind{body.radius, body.material}) ++kind;
  return kind;
}

TableRule::Answerer TableRule::answerer(const Meeting& meeting) const {
  if (kinds_.many) {
    const std::size_t first = meeting.first.material;
    return {.shared = (meeting.wall ? shared_walls_[first] : shared_[2 * first + meeting.second.material]).get()};
  }
  if (meeting.wall && walls_.empty()) return {};
  const std::size_t first = kind_of(meeting.first);
  return {.own = (meeting.wall ? walls_[first] : pairs_[first * kinds_.kinds.size() + kind_of(meeting.second)]).get()};
}

Parting TableRule::collide(const Meeting& meeting) { return answer(meeting, 1); }

Parting TableRule::take_back(const Meeting& meeting) { return answer(meeting, -1); }

Parting TableRule::answer(const Meeting& meeting, int count) {
  const double normal_speed = meeting.velocity().dot(meeting.normal);
  if (normal_speed <= 0)  // by rounding, of two that only just touch
    return {.velocity = {meeting.first.velocity, meeting.second.velocity}, .spin = {meeting.first.spin, meeting.second.spin}};
  const auto [own, shared] = answerer(meeting);
  const auto counted = [&](Refusal refusal) -> long& { return counts_[static_cast<std::size_t>(refusal)]; };
  const Parting unresolved{
      .velocity = {meeting.first.velocity, meeting.second.velocity}, .spin = {meeting.first.spin, meeting.second.spin}, .unresolved = true};
  if (!own && !shared) {
    counted(Refusal::no_table) += count;
    return unresolved;
  }
  const bool loses_spin = meeting.wall && wall_no_slip_;
  const Eigen::Vector3d still = meeting.wall ? meeting.second.velocity : Eigen::Vector3d::Zero();  // the engine's wall rests
  PairImpact impact{.normal = meeting.normal,
                    .velocity = {meeting.first.velocity - still, meeting.second.velocity - still},
                    .spin = {loses_spin ? Eigen::Vector3d::Zero() : meeting.first.spin, meeting.second.spin}};
  const double radius1 = meeting.first.radius, radius2 = meeting.wall ? 0.0 : meeting.second.radius;
  PairOutcome outcome = own ? own->look_up(impact) : shared->look_up(radius1, radius2, impact);
  counted(outcome.refusal) += count;
  if (outcome.refusal != Refusal::none) {
    if (unanswered_ == Unanswered::leave) return unresolved;
    outcome = own ? own->integrate(impact) : shared->integrate(radius1, radius2, impact);
  }
  if (outcome.stuck)
    throw WorkError(
        fmt::format("{} met at {:.3g} m/s and stick together, which an event cannot say; allowed: a flow that is faster or adheres "
                    "less, or {}",
                    meeting.wall ? "a sphere and a wall" : "two spheres", normal_speed, other_engine));
  Parting parting{
      .velocity = {outcome.velocity[0] + still, outcome.velocity[1] + still}, .spin = outcome.spin, .contact_time = outcome.contact_time};
  if (loses_spin) parting.spin[0].setZero();
  // Where they parted, and from there back along their new paths to now, or until just before they are nearest.
  const Eigen::Vector3d parted = outcome.displacement - meeting.distance * meeting.normal,
                        velocity = outcome.velocity[0] - outcome.velocity[1];
  double back = outcome.contact_time;
  constexpr double almost = 0.9;
  if (const double nearest = almost * parted.dot(velocity) / velocity.squaredNorm(); !meeting.wall && nearest < back) {
    back = std::max(nearest, 0.0);
    delayed_ += count;
  }
  const Eigen::Vector3d shift = outcome.displacement - back * velocity;
  const double share = meeting.wall ? 1 : meeting.second.mass / (meeting.first.mass + meeting.second.mass);
  parting.shift = {share * shift, (share - 1) * shift};
  return parting;
}

long TableRule::integrated() const { return std::accumulate(counts_.begin(), counts_.end(), 0L) - count(Refusal::none); }

void TableRule::save(std::string& bytes) const {
  for (const long count : counts_) put_bytes(bytes, count);
  put_bytes(bytes, delayed_);
}

void TableRule::load(std::string_view& bytes) {
  for (long& count : counts_) take_bytes(bytes, count);
  take_bytes(bytes, delayed_);
}

}  // namespace scalebreak

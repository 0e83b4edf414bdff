#include <scalebreak/ensembles/event/rules/table_rule.hpp>

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>
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

std::unique_ptr<PairResolver> resolver_of(const Input& pair, const TableStore& store, const PairTolerance& tolerance,
                                          Unanswered unanswered) {
  const bool leaves = unanswered == Unanswered::leave;
  if (leaves && (find_scaling_law(pair.scaling_law)->direct_force || pair.surface.attraction != Attraction::none)) return nullptr;
  auto resolver = std::make_unique<PairResolver>(pair, store, tolerance);
  if (const Refusal refusal = resolver->standing_refusal(); refusal != Refusal::none) {
    if (leaves) return nullptr;
    throw InputError(
        fmt::format("contact: between spheres of radii {} m no collision table can serve ({}); allowed in an event-driven run: laws and "
                    "sizes that have one, or {}",
                    fmt::join(pair.radius, " and "), to_string(refusal), other_engine));
  }
  return resolver;
}

[[noreturn]] void refuse_sizes() {
  throw InputError(
      fmt::format("particles.size: found spheres of more than {} radii; allowed in an event-driven run: \"mono\" or \"bidisperse\", "
                  "or {}",
                  TableRule::most_kinds, other_engine));
}

}  // namespace

void refuse_sizes_without_tables(const Input& input) {
  if (input.particles.file.empty() && input.particles.size != SizeKind::mono && input.particles.size != SizeKind::bidisperse)
    refuse_sizes();
}

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

std::vector<SphereKind> kinds_of(const System& system) {
  std::vector<SphereKind> kinds;
  for (std::size_t i = 0; i < system.count() && kinds.size() <= TableRule::most_kinds; ++i) {
    const SphereKind kind{system.radius[i], system.material[i]};
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  return kinds;
}

TableRule::TableRule(const Input& input, std::vector<SphereKind> kinds, const TableStore& store, const PairTolerance& tolerance,
                     Unanswered unanswered)
    : kinds_(std::move(kinds)), unanswered_(unanswered), wall_no_slip_(input.cell.wall_no_slip) {
  refuse_height_that_follows(input);
  if (unanswered == Unanswered::integrate) refuse_laws_without_tables(input);
  if (kinds_.size() > most_kinds) refuse_sizes();
  const auto& boundary = input.cell.boundary;
  const bool walled = std::find(boundary.begin(), boundary.end(), Boundary::wall) != boundary.end();
  for (const SphereKind& first : kinds_) {
    for (const SphereKind& second : kinds_)
      pairs_.push_back(
          resolver_of(pair_input(input, {{first.radius, first.material}, {second.radius, second.material}}), store, tolerance, unanswered));
    if (walled) walls_.push_back(resolver_of(pair_input(input, {{first.radius, first.material}}), store, tolerance, unanswered));
  }
}

std::size_t TableRule::kind_of(const Meeting::Body& body) const {
  std::size_t kind = 0;
  while (kinds_[kind] != SphereKind{body.radius, body.material}) ++kind;
  return kind;
}

const PairResolver* TableRule::resolver(const Meeting& meeting) const {
  const std::size_t first = kind_of(meeting.first);
  return (meeting.wall ? walls_[first] : pairs_[first * kinds_.size() + kind_of(meeting.second)]).get();
}

Parting TableRule::collide(const Meeting& meeting) { return answer(meeting, 1); }

Parting TableRule::take_back(const Meeting& meeting) { return answer(meeting, -1); }

Parting TableRule::answer(const Meeting& meeting, int count) {
  const double normal_speed = meeting.velocity().dot(meeting.normal);
  if (normal_speed <= 0)  // by rounding, of two that only just touch
    return {.velocity = {meeting.first.velocity, meeting.second.velocity}, .spin = {meeting.first.spin, meeting.second.spin}};
  const PairResolver* const pair = resolver(meeting);
  const auto counted = [&](Refusal refusal) -> long& { return counts_[static_cast<std::size_t>(refusal)]; };
  const Parting unresolved{
      .velocity = {meeting.first.velocity, meeting.second.velocity}, .spin = {meeting.first.spin, meeting.second.spin}, .unresolved = true};
  if (!pair) {
    counted(Refusal::no_table) += count;
    return unresolved;
  }
  const bool loses_spin = meeting.wall && wall_no_slip_;
  const Eigen::Vector3d still = meeting.wall ? meeting.second.velocity : Eigen::Vector3d::Zero();  // the engine's wall rests
  PairImpact impact{.normal = meeting.normal,
                    .velocity = {meeting.first.velocity - still, meeting.second.velocity - still},
                    .spin = {loses_spin ? Eigen::Vector3d::Zero() : meeting.first.spin, meeting.second.spin}};
  PairOutcome outcome = pair->look_up(impact);
  counted(outcome.refusal) += count;
  if (outcome.refusal != Refusal::none) {
    if (unanswered_ == Unanswered::leave) return unresolved;
    outcome = pair->integrate(impact);
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

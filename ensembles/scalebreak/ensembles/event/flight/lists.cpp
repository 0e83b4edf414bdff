#include <scalebreak/ensembles/event/flight/lists.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <vector>

#include <scalebreak/ensembles/event/flight/instants.hpp>
#include <scalebreak/ensembles/event/flight/list_difference.hpp>

namespace scalebreak {
namespace {

constexpr std::uint16_t least_capacity = 12;

std::span<Neighbour> list_of(Flight& flight, std::uint32_t i) {
  const Agenda& agenda = flight.agenda[i];
  return {flight.pool.data() + agenda.start, agenda.count};
}

/// 0, or the crossing of a periodic face that brings a difference below half of the edge.
int nearest_crossing(double difference, double edge) { return difference > edge / 2 ? -1 : difference < -edge / 2 ? 1 : 0; }

/// The same of any difference, over the edge.
int crossings(double difference) { return std::abs(difference) <= 0.5 ? 0 : -static_cast<int>(std::lround(difference)); }

/// Of candidates those that are near, each with the image that is.
void resolve_images(const Flight& flight, std::uint32_t i, double strain, std::span<const Neighbour> candidates,
                    std::vector<Neighbour>& found) {
  const Agenda& own = flight.agenda[i];
  const Cell& cell = flight.cell;
  const bool periodic[] = {cell.periodic(0), cell.periodic(1), cell.periodic(2)};
  for (const Neighbour k : candidates) __builtin_prefetch(&flight.agenda[k.sphere()]);
  for (const Neighbour k : candidates) {
    if (k.sphere() == i) continue;
    const Agenda& other = flight.agenda[k.sphere()];
    const double distance = own.reach + other.reach;
    Eigen::Vector3d apart = other.reference - own.reference;
    const int z = periodic[2] ? nearest_crossing(apart.z(), cell.size.z()) : 0;
    const int y = periodic[1] ? nearest_crossing(apart.y(), cell.size.y()) : 0;
    apart.z() += z * cell.size.z();
    apart.y() += y * cell.size.y();
    apart.x() += z * cell.shear_offset + strain * apart.z();
    const int x = periodic[0] ? crossings(apart.x() / cell.size.x()) : 0;
    apart.x() += x * cell.size.x();
    if (apart.squaredNorm() >= distance * distance) continue;
    assert(std::abs(x) <= Images::most_along_x);
    found.emplace_back(k.sphere(), Images::code(x, y, z));
  }
}

/// Neighbours of a sphere by the references.
void find_near(const Flight& flight, std::uint32_t i, double now, std::vector<Neighbour>& found) {
  static thread_local ReferenceBins::Space space;
  const Agenda& own = flight.agenda[i];
  const double strain = flight.flow_rate * now;
  const auto [candidates, exact] = flight.bins.find_near(own.reference, own.reach + flight.largest_reach, strain, space);
  found.clear();
  // Where all reach alike and nothing flows, the bins are right about images, and a few that are too far do no harm.
  if (!exact || flight.flow_rate != 0 || flight.least_reach != flight.largest_reach)
    return resolve_images(flight, i, strain, candidates, found);
  for (const Neighbour k : candidates) {
    if (k.sphere() == i) continue;
    __builtin_prefetch(&flight.sphere[k.sphere()]);
    found.push_back(k);
  }
}

/// Room for `count` entries and some more; the old place is lost until all lists are made anew.
void move_list(Flight& flight, Agenda& agenda, std::size_t count) {
  const std::size_t capacity = std::max<std::size_t>(least_capacity, count + count / 2);
  const std::size_t start = flight.pool.size();
  flight.pool.resize(start + capacity);
  std::copy_n(flight.pool.begin() + agenda.start, agenda.count, flight.pool.begin() + static_cast<std::ptrdiff_t>(start));
  agenda.start = static_cast<std::uint32_t>(start);
  agenda.capacity = static_cast<std::uint16_t>(capacity);
}

void add_to(Flight& flight, std::uint32_t i, Neighbour neighbour) {
  Agenda& agenda = flight.agenda[i];
  if (agenda.count == agenda.capacity) move_list(flight, agenda, agenda.count + 1u);
  flight.pool[agenda.start + agenda.count++] = neighbour;
}

void remove_from(Flight& flight, std::uint32_t i, Neighbour neighbour) {
  const auto list = list_of(flight, i);
  const auto found = std::find(list.begin(), list.end(), neighbour);
  assert(found != list.end());
  *found = list.back();
  --flight.agenda[i].count;
}

void set_list(Flight& flight, std::uint32_t i, const std::vector<Neighbour>& list) {
  Agenda& agenda = flight.agenda[i];
  agenda.count = 0;
  if (list.size() > agenda.capacity) move_list(flight, agenda, list.size());
  std::copy(list.begin(), list.end(), flight.pool.begin() + agenda.start);
  agenda.count = static_cast<std::uint16_t>(list.size());
}

bool has_left(const Cell& cell, const Eigen::Vector3d& position) {
  for (const int axis : {0, 1, 2}) {
    if (cell.periodic(axis) && (position[axis] < 0 || position[axis] >= cell.size[axis])) return true;
  }
  return false;
}

void set_reference(Flight& flight, std::uint32_t i, double now) {
  Agenda& agenda = flight.agenda[i];
  agenda.reference = flight.position(i, now);
  agenda.reference.x() -= flight.flow_at(agenda.reference.z()) * now;
  agenda.made = now;
}

}  // namespace

void make_lists(Flight& flight) {
  flight.least_reach = never, flight.largest_reach = 0;
  for (std::size_t i = 0; i < flight.sphere.size(); ++i) {
    const double reach = flight.agenda[i].reach = flight.sphere[i].radius + flight.allowance;
    flight.least_reach = std::min(flight.least_reach, reach), flight.largest_reach = std::max(flight.largest_reach, reach);
  }
  flight.bins = ReferenceBins(flight.cell, flight.sphere.size());
  flight.pool.clear();
  for (std::uint32_t i = 0; i < flight.sphere.size(); ++i) {
    flight.agenda[i].start = 0, flight.agenda[i].count = 0, flight.agenda[i].capacity = 0;
    set_reference(flight, i, 0);
    flight.bins.insert(i, flight.agenda[i].reference);
  }
  std::vector<Neighbour> found;
  for (std::uint32_t i = 0; i < flight.sphere.size(); ++i) {
    find_near(flight, i, 0, found);
    move_list(flight, flight.agenda[i], found.size());
    set_list(flight, i, found);
  }
}

void renew_list(Flight& flight, std::uint32_t i, double now) {
  static thread_local std::vector<Neighbour> found;
  static thread_local ListDifference difference;
  if (has_left(flight.cell, flight.position(i, now))) {
    bring_up(flight, i, now);
    wrap(advanced(flight.cell, now), flight.sphere[i].position, flight.sphere[i].velocity);
    ++flight.agenda[i].changes;
    for (const Neighbour& old : list_of(flight, i)) remove_from(flight, old.sphere(), {i, Images::opposite(old.image())});
    flight.agenda[i].count = 0;
  }
  set_reference(flight, i, now);
  flight.bins.move(i, flight.agenda[i].reference);
  find_near(flight, i, now, found);
  // First told apart, then fetched, then told to.
  static const bool by_eights = can_find_by_eights();
  (by_eights && found.size() <= most_by_eights ? find_difference_by_eights : find_difference)(list_of(flight, i), found, difference);
  const auto& [lost, gained] = difference;
  for (const auto* const changed : {&lost, &gained}) {
    for (const Neighbour neighbour : *changed) __builtin_prefetch(&flight.agenda[neighbour.sphere()]);
  }
  for (const auto* const changed : {&lost, &gained}) {
    for (const Neighbour neighbour : *changed) __builtin_prefetch(flight.pool.data() + flight.agenda[neighbour.sphere()].start);
  }
  for (const Neighbour neighbour : lost) remove_from(flight, neighbour.sphere(), {i, Images::opposite(neighbour.image())});
  for (const Neighbour neighbour : gained) add_to(flight, neighbour.sphere(), {i, Images::opposite(neighbour.image())});
  set_list(flight, i, found);
}

double share_of_allowance(const Flight& flight, std::uint32_t i, double now) {
  const Agenda& agenda = flight.agenda[i];
  Eigen::Vector3d away = flight.position(i, now) - agenda.reference;
  away.x() -= flight.flow_at(agenda.reference.z()) * now;
  return (away.norm() + flight.shrinking(agenda) * (now - agenda.made)) / flight.allowance;
}

}  // namespace scalebreak

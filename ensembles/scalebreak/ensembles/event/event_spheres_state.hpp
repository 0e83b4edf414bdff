#pragma once

#include <algorithm>
#include <type_traits>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/cell/cell_grid.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/flight/allowance.hpp>
#include <scalebreak/ensembles/event/flight/instants.hpp>
#include <scalebreak/ensembles/event/flight/lists.hpp>
#include <scalebreak/ensembles/event/saved_list.hpp>

// How a flow starts, is renewed and handed over; included where EventSpheres is instantiated.

namespace scalebreak {

template <class Queue, class Rule>
EventSpheres<Queue, Rule>::EventSpheres(const System& start, const EventSetup& setup, Rule rule)
    : rule_(std::move(rule)), groups_(setup.groups) {
  flight_.cell = start.cell;
  flight_.gravity = setup.gravity;
  flight_.allowance = setup.allowance > 0 ? setup.allowance : fast_allowance(start);
  check_room_for_lists(start, flight_.allowance);
  flight_.flow_rate = start.cell.periodic(2) ? start.cell.shear_rate : 2 * start.cell.wall_speed / start.cell.size.z();
  base_ = watched_from_ = start.time;
  for (std::uint32_t i = 0; i < start.count(); ++i) {
    flight_.sphere.push_back({start.position[i], 0, start.velocity[i], start.radius[i]});
    body_.push_back({start.mass[i], i, start.material[i]});
  }
  spin_ = start.spin;
  if (groups_) encounter_.resize(start.count()), patch_of_.assign(start.count(), no_patch);
  flight_.agenda.resize(start.count());
  queue_.reset(start.count());
  renew();
  if (groups_) adopt(start.contacts), settle_all();
  totals_.renewals = 0;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::renew() {
  if (groups_) bring_up_patches();
  flight_.cell = advanced(flight_.cell, now_);
  for (std::uint32_t i = 0; i < count(); ++i) {
    bring_up(flight_, i, now_);
    const Eigen::Vector3d position = flight_.sphere[i].position, velocity = flight_.sphere[i].velocity;
    wrap(flight_.cell, flight_.sphere[i].position, flight_.sphere[i].velocity);
    if (groups_) carry_encounter(i, position, velocity);
    flight_.sphere[i].time = 0;
  }
  base_ += now_;
  if (groups_) carry_patches(now_);
  now_ = 0;
  flight_.images = Images(flight_.cell);
  reorder();
  make_lists(flight_);
  queue_operations_ += queue_.operations();
  queue_.reset(count());
  for (std::uint32_t i = 0; i < count(); ++i) {
    if (!patched(i)) look_ahead(i);
  }
  if (groups_) settle_all();
  // Before the cell's images have moved on by half of its length, and references by a quarter: the images that are told apart suffice.
  const double passing = std::abs(flight_.flow_rate) * flight_.cell.size.z();
  renew_at_ = passing > 0 ? flight_.cell.size.x() / 2 / passing : never;
  constexpr long collisions_each = 200;
  collisions_left_ = collisions_each * static_cast<long>(count());
  ++totals_.renewals;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::reorder() {
  std::vector<Eigen::Vector3d> position;
  for (const FlyingSphere& sphere : flight_.sphere) position.push_back(sphere.position);
  const std::vector<double> points(count(), 0.0);
  const double spacing = std::cbrt(flight_.cell.volume() / static_cast<double>(count()));
  const std::vector<std::uint32_t> order = CellGrid(flight_.cell, position, points, 2 * spacing).order();
  const auto apply = [&](auto& list) {
    auto sorted = list;
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = list[order[i]];
    list = std::move(sorted);
  };
  apply(flight_.sphere);
  apply(body_);
  apply(spin_);
  if (!groups_) return;
  apply(encounter_);
  renumber_patches(order);
}

template <class Queue, class Rule>
System EventSpheres<Queue, Rule>::system() const {
  System system;
  const std::size_t n = count();
  system.time = time();
  system.cell = advanced(flight_.cell, now_);
  system.radius.resize(n), system.mass.resize(n), system.material.resize(n);
  system.position.resize(n), system.velocity.resize(n), system.spin.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = body_[i].identity;
    system.radius[k] = flight_.sphere[i].radius;
    system.mass[k] = body_[i].mass;
    system.material[k] = body_[i].material;
    system.position[k] = flight_.position(i, now_);
    system.velocity[k] = flight_.velocity(i, now_);
    system.spin[k] = spin_[i];
    wrap(system.cell, system.position[k], system.velocity[k]);
  }
  for (const auto& patch : patch_) {
    if (patch) tell_patch(*patch, system);
  }
  return system;
}

template <class Queue, class Rule>
template <class Numbers>
void EventSpheres<Queue, Rule>::go_through_numbers(Numbers&& number) {
  for (const int axis : {0, 1, 2}) number(flight_.cell.size[axis]);
  for (Boundary& boundary : flight_.cell.boundary) number(reinterpret_cast<std::underlying_type_t<Boundary>&>(boundary));
  number(flight_.cell.shear_rate), number(flight_.cell.shear_offset), number(flight_.cell.wall_speed);
  number(flight_.flow_rate), number(flight_.allowance), number(flight_.least_reach), number(flight_.largest_reach);
  number(base_), number(now_), number(renew_at_), number(collisions_left_);
  number(watched_), number(watched_from_), number(longest_watch_);
  number(totals_.collisions), number(totals_.wall_collisions), number(totals_.stale), number(totals_.lists), number(totals_.renewals);
  number(totals_.patches), number(totals_.taken_back), number(totals_.patch_steps), number(totals_.patch_starts),
      number(totals_.patch_time), number(totals_.patch_evaluations);
  number(totals_.wall_work), number(totals_.dissipated), number(totals_.contact_time);
  for (const Eigen::Index i : {0, 1, 2, 3, 4, 5, 6, 7, 8}) number(totals_.contact_moment(i));
}

template <class Queue, class Rule>
std::string EventSpheres<Queue, Rule>::save() const {
  std::string bytes;
  const_cast<EventSpheres*>(this)->go_through_numbers([&](const auto& value) { put_bytes(bytes, value); });
  put_list(bytes, flight_.sphere), put_list(bytes, flight_.agenda), put_list(bytes, flight_.pool);
  put_list(bytes, body_), put_list(bytes, spin_);
  flight_.bins.save(bytes);
  for (std::uint32_t i = 0; i < count(); ++i) put_bytes(bytes, queue_.time_of(i));
  if (groups_) save_patches(bytes);
  return bytes;
}

template <class Queue, class Rule>
EventSpheres<Queue, Rule>::EventSpheres(std::string_view saved, const EventSetup& setup, Rule rule)
    : rule_(std::move(rule)), groups_(setup.groups) {
  flight_.gravity = setup.gravity;
  go_through_numbers([&](auto& value) { take_bytes(saved, value); });
  take_list(saved, flight_.sphere), take_list(saved, flight_.agenda), take_list(saved, flight_.pool);
  take_list(saved, body_), take_list(saved, spin_);
  flight_.images = Images(flight_.cell);
  flight_.bins = ReferenceBins(flight_.cell, count());
  flight_.bins.load(saved);
  queue_.reset(count());
  for (std::uint32_t i = 0; i < count(); ++i) {
    double time = 0;
    take_bytes(saved, time);
    queue_.schedule(i, time);
  }
  if (groups_) load_patches(saved);
}

template <class Queue, class Rule>
double EventSpheres<Queue, Rule>::mean_neighbours() const {
  double sum = 0;
  for (const Agenda& agenda : flight_.agenda) sum += agenda.count;
  return sum / static_cast<double>(count());
}

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <limits>

#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/flight/instants.hpp>
#include <scalebreak/ensembles/event/flight/lists.hpp>

// Patches: spheres that are integrated while the rest flies; included where EventSpheres is instantiated.

namespace scalebreak {

template <class Queue, class Rule>
double EventSpheres<Queue, Rule>::longest_stretch() const {
  constexpr double steps = 32;  // long beside what showing a patch costs, short beside a contact of stiff spheres
  return steps * groups_->step();
}

template <class Queue, class Rule>
GroupSphere EventSpheres<Queue, Rule>::group_sphere(std::uint32_t i, double time) const {
  return {flight_.position(i, time), flight_.velocity(i, time), spin_[i], flight_.sphere[i].radius, body_[i].mass, body_[i].material};
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::keep_encounter(std::uint32_t i, std::uint32_t partner, double contact_time) {
  const FlyingSphere& sphere = flight_.sphere[i];  // brought up to now
  encounter_[i] = {now_, now_ + contact_time, partner, sphere.position, sphere.velocity, spin_[i]};
}

template <class Queue, class Rule>
bool EventSpheres<Queue, Rule>::disturbed(std::uint32_t i, std::uint32_t partner, const Parting& parting) const {
  const double horizon = parting.contact_time;
  // While in contact the two are off their lines by not more than they are shifted.
  const double off = 2 * std::max(parting.shift[0].norm(), parting.shift[1].norm());
  const bool with_wall = partner >= most_flying_spheres;
  const auto sees = [&](std::uint32_t one, std::uint32_t other, const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) {
    const Agenda& own = flight_.agenda[one];
    for (std::uint32_t k = own.start; k < own.start + own.count; ++k) {
      const Neighbour neighbour = flight_.pool[k];
      if (neighbour.sphere() == other) continue;
      const FlyingSphere& there = flight_.sphere[neighbour.sphere()];
      const Images::Image& image = flight_.images[neighbour.image()];
      const Eigen::Vector3d apart = flight_.position(neighbour.sphere(), now_) + image.shift_at(now_) - position;
      const Eigen::Vector3d relative = flight_.velocity(neighbour.sphere(), now_) + Eigen::Vector3d(image.drift, 0, 0) - velocity;
      const double reach = flight_.sphere[one].radius + there.radius + off;
      // Most are too far for that to be a question: (a + b)² ≤ 2a² + 2b².
      if (dot(apart, apart) > 2 * (reach * reach + horizon * horizon * dot(relative, relative))) continue;
      if (least_square_distance(apart, relative, horizon) < reach * reach) return true;
    }
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
      const int axis = static_cast<int>(wall / 2);
      if (!flight_.cell.walled(axis) || other == no_neighbour::first_wall + wall) continue;
      const double height = wall % 2 == 1 ? flight_.cell.size[axis] - position[axis] : position[axis];
      const double speed = wall % 2 == 1 ? -velocity[axis] : velocity[axis];
      if (height + std::min(0.0, speed * horizon) < flight_.sphere[one].radius + off) return true;
    }
    return false;
  };
  const FlyingSphere& first = flight_.sphere[i];
  if (sees(i, partner, first.position + parting.shift[0], parting.velocity[0])) return true;
  if (with_wall) return false;
  // The second in its own image.
  const FlyingSphere& second = flight_.sphere[partner];
  const Neighbour seen = flight_.agenda[i].partner;
  const double drift = seen.sphere() == partner ? flight_.images[seen.image()].drift : 0;
  return sees(partner, i, second.position + parting.shift[1], parting.velocity[1] - Eigen::Vector3d(drift, 0, 0));
}

template <class Queue, class Rule>
Patch EventSpheres<Queue, Rule>::take_back(std::uint32_t i) {
  const Encounter& first = encounter_[i];
  const double begin = first.begin;
  Patch patch{DemGroup(*groups_, begin), {}, {}, 0, {}};
  const auto put = [&](std::uint32_t k, const Offset& offset) {
    GroupSphere sphere = group_sphere(k, now_);
    sphere.position = encounter_[k].position + offset.shift, sphere.velocity = encounter_[k].velocity, sphere.spin = encounter_[k].spin;
    sphere.velocity.x() += offset.drift;
    patch.add(k, sphere, offset);
  };
  put(i, {});
  const auto body = [&](std::uint32_t k) {
    const GroupSphere sphere = patch.group.sphere(k);
    return Meeting::Body{sphere.mass, sphere.radius, sphere.material, sphere.velocity, sphere.spin};
  };
  Meeting meeting;
  if (first.partner >= most_flying_spheres) {
    meeting = wall_meeting(first.partner - no_neighbour::first_wall, body(0));
  } else {
    const Cell cell = advanced(flight_.cell, begin);
    const Eigen::Vector3d apart = encounter_[first.partner].position - first.position;
    put(first.partner, {nearest_image(cell, apart) - apart, image_velocity(cell, apart).x()});
    const Eigen::Vector3d branch = patch.group.position(1) - patch.group.position(0);
    meeting = {branch.normalized(), body(0), body(1), branch.norm()};
  }
  if constexpr (Rule::lasts) account(meeting, rule_.take_back(meeting), -1);
  ++totals_.taken_back;
  return patch;
}

template <class Queue, class Rule>
Patch EventSpheres<Queue, Rule>::take_out(std::uint32_t i, double earliest) {
  if (const std::uint32_t slot = patch_of_[i]; slot != no_patch) {
    Patch patch = std::move(*patch_[slot]);
    patch_[slot].reset();
    free_slot_.push_back(slot);
    for (const std::uint32_t k : patch.sphere) patch_of_[k] = no_patch;
    return patch;
  }
  if (busy(i)) return take_back(i);
  const double since = std::clamp(encounter_[i].end, earliest, now_);
  Patch patch{DemGroup(*groups_, since), {}, {}, 0, {}};
  patch.add(i, group_sphere(i, since), {});
  return patch;
}

template <class Queue, class Rule>
Patch EventSpheres<Queue, Rule>::merged(std::uint32_t i, Neighbour partner) {
  const bool with_sphere = partner.sphere() < most_flying_spheres;
  const std::uint32_t j = partner.sphere();
  // What is in contact is from before now; what is free then comes to it in time.
  const auto since = [&](std::uint32_t k) {
    return patched(k) ? patch_[patch_of_[k]]->group.time() : busy(k) ? encounter_[k].begin : now_;
  };
  const double earliest = with_sphere ? std::min(since(i), since(j)) : since(i);
  // Of patches that were settled at this very instant: a stretch that grew again would let in again what a shorter one has left out.
  double longest = std::numeric_limits<double>::infinity();
  const auto settled = [&](const Patch& patch) {
    if (patch.stretch > 0 && patch.group.time() == now_) longest = std::min(longest, patch.stretch);
  };
  Patch patch = take_out(i, earliest);
  settled(patch);
  bool has_both = !with_sphere || std::find(patch.sphere.begin(), patch.sphere.end(), j) != patch.sphere.end();
  if (!has_both) {
    Patch other = take_out(j, earliest);
    settled(other);
    std::uint32_t here = i, there = j;
    if (other.group.time() < patch.group.time()) std::swap(patch, other), std::swap(here, there);
    const double time = other.group.time();
    advance(patch, time);
    const auto place = [](const Patch& in, std::uint32_t sphere) {
      const auto at = static_cast<std::uint32_t>(std::find(in.sphere.begin(), in.sphere.end(), sphere) - in.sphere.begin());
      return in.group.position(at);
    };
    const Eigen::Vector3d apart = place(other, there) - place(patch, here);
    const Cell cell = advanced(flight_.cell, time);
    patch.absorb(other, {nearest_image(cell, apart) - apart, image_velocity(cell, apart).x()});
  }
  for (const std::uint32_t k : patch.sphere) encounter_[k].end = now_;
  ++totals_.patches;
  advance(patch, now_);
  patch.stretch = std::min(patch.best_stretch(longest_stretch()), longest);
  return patch;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::crowd(std::uint32_t i, Neighbour partner) {
  settle(merged(i, partner));
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::advance(Patch& patch, double time) {
  const double span = time - patch.group.time();
  if (span <= 0) return;
  DemGroup& group = patch.group;
  const auto energy = [&] {
    double sum = group.kinetic_energy() + group.elastic_energy();
    if (flight_.falls()) {
      for (std::uint32_t k = 0; k < group.count(); ++k) sum -= group.sphere(k).mass * flight_.gravity.dot(group.position(k));
    }
    return sum;
  };
  const double before = energy();
  patch.advance_to(time, 2 * longest_stretch());
  const GroupTotals gained = group.take_totals();
  totals_.dissipated += before - energy() + gained.wall_work;
  totals_.wall_work += gained.wall_work;
  totals_.contact_moment += gained.contact_moment;
  totals_.contact_time += gained.contact_time;
  totals_.patch_starts += gained.contact_starts;
  totals_.patch_steps += gained.steps;
  totals_.patch_evaluations += gained.evaluations;
  totals_.patch_time += span * group.count();
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::open_contacts() {
  for (std::uint32_t i = 0; i < count(); ++i) {
    if (!patched(i) && busy(i)) crowd(i, {encounter_[i].partner, 0});
  }
}

template <class Queue, class Rule>
std::vector<ContactForce> EventSpheres<Queue, Rule>::touching() const {
  std::vector<ContactForce> touching;
  for (std::uint32_t i = 0; i < encounter_.size(); ++i) {
    if (patched(i) || !busy(i)) continue;
    const std::uint32_t partner = encounter_[i].partner;
    const bool wall = partner >= most_flying_spheres;
    if (!wall && partner < i) continue;  // it has the same contact
    touching.push_back(
        {.first = static_cast<std::int32_t>(body_[i].identity), .second = wall ? -1 : static_cast<std::int32_t>(body_[partner].identity)});
  }
  for (const ContactMemory& contact : system().contacts)
    touching.push_back({.first = contact.first, .second = contact.second, .touching = contact.touching});
  return touching;
}

template <class Queue, class Rule>
std::size_t EventSpheres<Queue, Rule>::patched() const {
  return static_cast<std::size_t>(std::count_if(patch_of_.begin(), patch_of_.end(), [](std::uint32_t slot) { return slot != no_patch; }));
}

template <class Queue, class Rule>
double EventSpheres<Queue, Rule>::elastic_energy() const {
  double energy = 0;
  for (const auto& patch : patch_) {
    if (!patch) continue;
    Patch now = *patch;
    now.advance_to(now_, 2 * longest_stretch());
    energy += now.group.elastic_energy();
  }
  return energy;
}

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <optional>

#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/flight/instants.hpp>
#include <scalebreak/ensembles/event/flight/lists.hpp>
#include <scalebreak/ensembles/event/patches/linked_parts.hpp>

// How patches are put into the flow as balls about their spheres' paths, and what comes into these; included where EventSpheres is instantiated.

namespace scalebreak {

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::put_members(const Patch& patch, double horizon) {
  for (std::uint32_t k = 0; k < patch.group.count(); ++k) {
    const std::uint32_t i = patch.sphere[k];
    const GroupSphere sphere = patch.group.sphere(k);
    flight_.sphere[i] = {sphere.position - patch.offset[k].shift, patch.group.time(), sphere.velocity,
                         sphere.radius + patch.push[k] * horizon};
    flight_.sphere[i].velocity.x() -= patch.offset[k].drift;
    spin_[i] = sphere.spin;
    ++flight_.agenda[i].changes;
  }
}

template <class Queue, class Rule>
std::uint32_t EventSpheres<Queue, Rule>::open_slot(Patch&& patch) {
  std::uint32_t slot = static_cast<std::uint32_t>(patch_.size());
  if (free_slot_.empty()) {
    patch_.emplace_back();
  } else {
    slot = free_slot_.back();
    free_slot_.pop_back();
  }
  for (const std::uint32_t k : patch.sphere) patch_of_[k] = slot;
  patch_[slot] = std::move(patch);
  return slot;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::settle(Patch&& patch) {
  std::vector<std::uint32_t> to_show = put_down(std::move(patch));
  while (!to_show.empty()) {
    const std::uint32_t slot = to_show.back();
    to_show.pop_back();
    if (!patch_[slot]) continue;  // merged with another since
    const std::optional<Entering> entering = show(slot);
    if (!entering) continue;
    const auto more = put_down(merged(entering->sphere, entering->partner));
    to_show.insert(to_show.end(), more.begin(), more.end());
  }
}

template <class Queue, class Rule>
std::vector<std::uint32_t> EventSpheres<Queue, Rule>::put_down(Patch&& patch) {
  const LinkedParts linked = linked_parts(patch, patch.stretch);
  put_members(patch, 0);
  std::vector<std::uint32_t> slots, alone;
  for (const std::uint32_t k : linked.alone) {
    alone.push_back(patch.sphere[k]);
    encounter_[patch.sphere[k]].end = now_;
  }
  if (linked.parts.size() == 1 && linked.alone.empty()) {
    slots.push_back(open_slot(std::move(patch)));
  } else {
    for (const auto& part : linked.parts) slots.push_back(open_slot(patch.part(part)));
  }
  for (const std::uint32_t slot : slots) put_members(*patch_[slot], patch_[slot]->stretch);
  for (const std::uint32_t i : alone) look_ahead(i);
  std::reverse(slots.begin(), slots.end());
  return slots;
}

template <class Queue, class Rule>
auto EventSpheres<Queue, Rule>::show(std::uint32_t slot) -> std::optional<Entering> {
  Patch& patch = *patch_[slot];
  for (std::uint32_t k = 0; k < patch.sphere.size(); ++k) {
    const std::uint32_t i = patch.sphere[k];
    constexpr double far_enough = 0.6;
    if (share_of_allowance(flight_, i, now_) > far_enough) {
      list_anew(i);
      // It may have been brought back into the cell.
      patch.offset[k] = {patch.group.position(k) - flight_.sphere[i].position,
                         patch.group.velocity(k).x() - flight_.sphere[i].velocity.x()};
    }
  }
  for (const std::uint32_t i : patch.sphere) {
    const Agenda& own = flight_.agenda[i];
    for (std::uint32_t n = own.start; n < own.start + own.count; ++n) {
      const Neighbour neighbour = flight_.pool[n];
      const std::uint32_t j = neighbour.sphere();
      if (patch_of_[j] == slot) continue;
      const Eigen::Vector3d apart =
          flight_.position(j, now_) + flight_.images[neighbour.image()].shift_at(now_) - flight_.position(i, now_);
      const double reach = flight_.sphere[i].radius + flight_.sphere[j].radius;
      // It is in the ball already. What is at its edge and leaves stays out.
      if (apart.squaredNorm() < reach * reach * (1 - 1e-12)) return Entering{i, neighbour};
    }
  }
  for (const std::uint32_t i : patch.sphere) schedule(i, foresee_in_patch(i));
  return {};
}

template <class Queue, class Rule>
Foreseen EventSpheres<Queue, Rule>::foresee_in_patch(std::uint32_t i) const {
  const std::uint32_t slot = patch_of_[i];
  Foreseen next{patch_[slot]->group.time() + patch_[slot]->stretch - now_, {no_neighbour::list_ends, 0}};
  const Agenda& own = flight_.agenda[i];
  for (std::uint32_t n = own.start; n < own.start + own.count; ++n) {
    const Neighbour neighbour = flight_.pool[n];
    const std::uint32_t j = neighbour.sphere();
    if (patch_of_[j] == slot) continue;
    const Images::Image& image = flight_.images[neighbour.image()];
    const Eigen::Vector3d apart = flight_.position(j, now_) + image.shift_at(now_) - flight_.position(i, now_);
    const Eigen::Vector3d velocity = flight_.velocity(j, now_) + Eigen::Vector3d(image.drift, 0, 0) - flight_.velocity(i, now_);
    const double wait = time_to_meet(apart, velocity, flight_.sphere[i].radius + flight_.sphere[j].radius);
    if (wait < next.wait) next = {wait, neighbour};
  }
  return next;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::happen_in_patch(std::uint32_t i) {
  const Neighbour partner = flight_.agenda[i].partner;
  if (partner.sphere() < most_flying_spheres) {
    if (flight_.agenda[partner.sphere()].changes == flight_.agenda[i].partner_changes) return crowd(i, partner);
    ++totals_.stale;
    return schedule(i, foresee_in_patch(i));
  }
  Patch patch = take_out(i, now_);
  advance(patch, now_);
  patch.stretch = patch.best_stretch(longest_stretch());
  settle(std::move(patch));
}

}  // namespace scalebreak

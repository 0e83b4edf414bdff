#pragma once

#include <algorithm>
#include <map>

#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/saved_list.hpp>

// How patches start, are renewed with everything else, told of and handed over; included where EventSpheres is instantiated.

namespace scalebreak {

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::settle_all() {
  for (std::size_t slot = 0; slot < patch_.size(); ++slot) {
    if (!patch_[slot]) continue;
    Patch patch = take_out(patch_[slot]->sphere.front(), now_);
    patch.stretch = patch.best_stretch(longest_stretch());
    settle(std::move(patch));
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::bring_up_patches() {
  for (auto& patch : patch_) {
    if (!patch) continue;
    advance(*patch, now_);
    put_members(*patch, 0);
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::carry_encounter(std::uint32_t i, const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) {
  const Eigen::Vector3d carried = flight_.velocity(i, now_) - velocity;
  Encounter& encounter = encounter_[i];
  encounter.position += flight_.position(i, now_) - position - (now_ - encounter.begin) * carried;
  encounter.velocity += carried;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::carry_patches(double time) {
  for (Encounter& encounter : encounter_) encounter.begin -= time, encounter.end -= time;
  for (auto& patch : patch_) {
    if (!patch) continue;
    patch->group.begin_at(patch->group.time() - time);
    for (std::uint32_t k = 0; k < patch->sphere.size(); ++k) {
      const FlyingSphere& sphere = flight_.sphere[patch->sphere[k]];
      patch->offset[k] = {patch->group.position(k) - sphere.position, patch->group.velocity(k).x() - sphere.velocity.x()};
    }
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::renumber_patches(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> number(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  for (Encounter& encounter : encounter_) {
    if (encounter.partner < most_flying_spheres) encounter.partner = number[encounter.partner];
  }
  std::fill(patch_of_.begin(), patch_of_.end(), no_patch);
  for (std::uint32_t slot = 0; slot < patch_.size(); ++slot) {
    if (!patch_[slot]) continue;
    for (std::uint32_t& sphere : patch_[slot]->sphere) sphere = number[sphere], patch_of_[sphere] = slot;
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::tell_patch(const Patch& patch, System& system) const {
  Patch now = patch;
  now.advance_to(now_, 2 * longest_stretch());
  const auto identity = [&](std::size_t k) { return body_[now.sphere[k]].identity; };
  for (std::uint32_t k = 0; k < now.group.count(); ++k) {
    const GroupSphere sphere = now.group.sphere(k);
    const std::uint32_t i = identity(k);
    system.radius[i] = sphere.radius;
    system.position[i] = sphere.position - now.offset[k].shift;
    system.velocity[i] = sphere.velocity - Eigen::Vector3d(now.offset[k].drift, 0, 0);
    system.spin[i] = sphere.spin;
    wrap(system.cell, system.position[i], system.velocity[i]);
  }
  for (ContactMemory contact : now.group.contacts()) {
    contact.first = static_cast<std::int32_t>(identity(static_cast<std::size_t>(contact.first)));
    if (contact.second >= 0) contact.second = static_cast<std::int32_t>(identity(static_cast<std::size_t>(contact.second)));
    contact.begun += base_;
    system.contacts.push_back(contact);
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::save_patches(std::string& bytes) const {
  put_list(bytes, encounter_), put_list(bytes, free_slot_);
  put_bytes(bytes, patch_.size());
  for (const auto& patch : patch_) {
    put_list(bytes, patch ? patch->sphere : std::vector<std::uint32_t>());
    if (!patch) continue;
    std::vector<GroupSphere> spheres;
    for (std::uint32_t k = 0; k < patch->group.count(); ++k) spheres.push_back(patch->group.sphere(k));
    put_list(bytes, spheres), put_list(bytes, patch->group.contacts()), put_list(bytes, patch->offset), put_list(bytes, patch->push);
    put_bytes(bytes, patch->group.time()), put_bytes(bytes, patch->stretch);
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::load_patches(std::string_view& bytes) {
  take_list(bytes, encounter_), take_list(bytes, free_slot_);
  patch_of_.assign(count(), no_patch);
  std::size_t slots = 0;
  take_bytes(bytes, slots);
  patch_.resize(slots);
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    std::vector<std::uint32_t> sphere;
    take_list(bytes, sphere);
    if (sphere.empty()) continue;
    std::vector<GroupSphere> spheres;
    std::vector<ContactMemory> contacts;
    std::vector<Offset> offset;
    std::vector<double> push;
    take_list(bytes, spheres), take_list(bytes, contacts), take_list(bytes, offset), take_list(bytes, push);
    double time = 0, stretch = 0;
    take_bytes(bytes, time), take_bytes(bytes, stretch);
    Patch patch{DemGroup(*groups_, time), sphere, offset, stretch, push};
    for (const GroupSphere& each : spheres) (void)patch.group.add(each);
    for (const ContactMemory& each : contacts) patch.group.add(each);
    for (const std::uint32_t k : sphere) patch_of_[k] = slot;
    patch_[slot] = std::move(patch);
  }
}

/// Patches of spheres, their numbers those of the start, that touch already.
template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::adopt(const std::vector<ContactMemory>& contacts) {
  std::vector<std::uint32_t> place(count());
  for (std::uint32_t k = 0; k < count(); ++k) place[body_[k].identity] = k;
  std::vector<std::vector<std::size_t>> of(count());  // contacts of each sphere
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    of[place[static_cast<std::size_t>(contacts[c].first)]].push_back(c);
    if (contacts[c].second >= 0) of[place[static_cast<std::size_t>(contacts[c].second)]].push_back(c);
  }
  std::vector<std::uint8_t> done(count(), 0);
  for (std::uint32_t seed = 0; seed < count(); ++seed) {
    if (done[seed] || of[seed].empty()) continue;
    Patch patch{DemGroup(*groups_, now_), {}, {}, 0, {}};
    std::map<std::uint32_t, std::int32_t> number;
    const auto add = [&](std::uint32_t k, const Offset& offset) {
      GroupSphere sphere = group_sphere(k, now_);
      sphere.position += offset.shift, sphere.velocity.x() += offset.drift;
      number[k] = static_cast<std::int32_t>(patch.sphere.size());
      patch.add(k, sphere, offset);
      done[k] = 1;
    };
    add(seed, {});
    std::vector<std::size_t> found;
    for (std::size_t n = 0; n < patch.sphere.size(); ++n) {
      const std::uint32_t i = patch.sphere[n];
      for (const std::size_t c : of[i]) {
        found.push_back(c);
        if (contacts[c].second < 0) continue;
        const std::uint32_t a = place[static_cast<std::size_t>(contacts[c].first)], b = place[static_cast<std::size_t>(contacts[c].second)];
        const std::uint32_t j = a == i ? b : a;
        if (done[j]) continue;
        const Eigen::Vector3d apart = flight_.position(j, now_) - patch.group.position(static_cast<std::uint32_t>(n));
        const Cell cell = advanced(flight_.cell, now_);
        add(j, {nearest_image(cell, apart) - apart, image_velocity(cell, apart).x()});
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const std::size_t c : found) {
      ContactMemory contact = contacts[c];
      contact.begun -= base_;
      contact.first = number[place[static_cast<std::size_t>(contact.first)]];
      if (contact.second >= 0) contact.second = number[place[static_cast<std::size_t>(contact.second)]];
      patch.group.add(contact);
    }
    ++totals_.patches;
    (void)open_slot(std::move(patch));
  }
}

}  // namespace scalebreak

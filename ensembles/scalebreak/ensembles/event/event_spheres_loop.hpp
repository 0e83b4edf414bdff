#pragma once

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/flight/foresee.hpp>
#include <scalebreak/ensembles/event/flight/instants.hpp>
#include <scalebreak/ensembles/event/flight/lists.hpp>

#include <fmt/format.h>

// What happens between two looks at a flow; included where EventSpheres is instantiated.

namespace scalebreak {

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::advance_to(double time) {
  while (true) {
    const Due due = queue_.next();
    const double end = time - base_;
    if (due.time >= renew_at_ && renew_at_ <= end) {
      now_ = renew_at_;
      renew();
      continue;
    }
    if (due.time > end) {
      now_ = std::max(now_, end);
      return;
    }
    now_ = std::max(now_, due.time);
    happen(due.sphere);
    if (collisions_left_ <= 0) renew();
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::advance_collisions(long collisions) {
  const auto so_far = [&] { return totals_.collisions + totals_.wall_collisions; };
  const long last = so_far() + collisions;
  while (so_far() < last) {
    const Due due = queue_.next();
    if (due.time == never) throw WorkError("no sphere will ever meet another one again");
    now_ = std::max(now_, std::min(due.time, renew_at_));
    if (due.time >= renew_at_ || collisions_left_ <= 0)
      renew();
    else
      happen(due.sphere);
  }
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::look_ahead(std::uint32_t i) {
  schedule(i, foresee(flight_, i, now_));
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::schedule(std::uint32_t i, const Foreseen& next) {
  Agenda& agenda = flight_.agenda[i];
  agenda.partner = next.partner;
  if (next.partner.sphere() < most_flying_spheres) agenda.partner_changes = flight_.agenda[next.partner.sphere()].changes;
  queue_.schedule(i, now_ + next.wait);
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::happen(std::uint32_t i) {
  if constexpr (requires { queue_.for_each_soon([](std::uint32_t) {}); }) {
    queue_.for_each_soon([&](std::uint32_t k) {
      __builtin_prefetch(&flight_.sphere[k]);
      __builtin_prefetch(&flight_.agenda[k]);
    });
  }
  if (patched(i)) return happen_in_patch(i);
  const Agenda& agenda = flight_.agenda[i];
  const Neighbour partner = agenda.partner;
  if (partner.sphere() == no_neighbour::list_ends) return end_list(i);
  if (partner.sphere() >= no_neighbour::first_wall) return collide_with_wall(i, partner.sphere() - no_neighbour::first_wall);
  if (flight_.agenda[partner.sphere()].changes == agenda.partner_changes) return collide(i, partner);
  ++totals_.stale;
  look_ahead(i);
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::end_list(std::uint32_t i) {
  constexpr double far_enough = 0.8;  // under gravity, or where the path has changed, it may be nearer than was foreseen
  if (share_of_allowance(flight_, i, now_) > far_enough) {
    list_anew(i);
  }
  look_ahead(i);
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::list_anew(std::uint32_t i) {
  ++totals_.lists;
  if (!groups_) return renew_list(flight_, i, now_);
  const Eigen::Vector3d position = flight_.position(i, now_), velocity = flight_.velocity(i, now_);
  renew_list(flight_, i, now_);
  carry_encounter(i, position, velocity);
}

template <class Queue, class Rule>
Meeting::Body EventSpheres<Queue, Rule>::meeting_body(std::uint32_t i) const {
  Meeting::Body body{body_[i].mass, flight_.sphere[i].radius, body_[i].material, flight_.sphere[i].velocity, Eigen::Vector3d::Zero()};
  if constexpr (Rule::spins) body.spin = spin_[i];
  return body;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::collide(std::uint32_t i, Neighbour partner) {
  const std::uint32_t j = partner.sphere();
  if (patched(j) || busy(i) || busy(j)) return crowd(i, partner);
  const Images::Image& image = flight_.images[partner.image()];
  bring_up(flight_, i, now_);
  bring_up(flight_, j, now_);
  FlyingSphere &first = flight_.sphere[i], &second = flight_.sphere[j];
  const Eigen::Vector3d branch = second.position + image.shift_at(now_) - first.position, drift(image.drift, 0, 0);
  Meeting meeting{branch.normalized(), meeting_body(i), meeting_body(j), branch.norm()};
  meeting.second.velocity += drift;
  const Parting parting = rule_.collide(meeting);
  if constexpr (Rule::lasts) {
    if (groups_) {
      if (parting.unresolved) return crowd(i, partner);
      if (disturbed(i, j, parting)) {
        (void)rule_.take_back(meeting);
        return crowd(i, partner);
      }
      keep_encounter(i, j, parting.contact_time);
      keep_encounter(j, i, parting.contact_time);
    }
  }
  account(meeting, parting, 1);
  first.velocity = parting.velocity[0];
  second.velocity = parting.velocity[1] - drift;
  if constexpr (Rule::displaces) {
    first.position += parting.shift[0];
    second.position += parting.shift[1];
  }
  if constexpr (Rule::spins) spin_[i] = parting.spin[0], spin_[j] = parting.spin[1];
  --collisions_left_;
  ++flight_.agenda[i].changes;
  ++flight_.agenda[j].changes;
  look_ahead(i);
  look_ahead(j);
  watch_for_collapse();
}

template <class Queue, class Rule>
Meeting EventSpheres<Queue, Rule>::wall_meeting(std::uint32_t wall, const Meeting::Body& body) const {
  const int axis = static_cast<int>(wall / 2);
  const double side = wall % 2 == 1 ? 1 : -1;
  Meeting meeting{side * Eigen::Vector3d::Unit(axis), body, {.mass = never}, body.radius, true};
  if (axis == 2) meeting.second.velocity.x() = side * flight_.cell.wall_speed;
  return meeting;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::collide_with_wall(std::uint32_t i, std::uint32_t wall) {
  const Neighbour partner(no_neighbour::first_wall + wall, 0);
  if (busy(i)) return crowd(i, partner);
  bring_up(flight_, i, now_);
  const Meeting meeting = wall_meeting(wall, meeting_body(i));
  const Parting parting = rule_.collide(meeting);
  if constexpr (Rule::lasts) {
    if (groups_) {
      if (parting.unresolved) return crowd(i, partner);
      constexpr double weighs = 0.02;  // what its weight does while they touch, over what the wall does
      const bool rests = parting.contact_time * flight_.gravity.norm() > weighs * std::abs(meeting.velocity().dot(meeting.normal));
      if (rests || disturbed(i, partner.sphere(), parting)) {
        (void)rule_.take_back(meeting);
        return crowd(i, partner);
      }
      keep_encounter(i, partner.sphere(), parting.contact_time);
    }
  }
  account(meeting, parting, 1);
  FlyingSphere& sphere = flight_.sphere[i];
  // The wall bears its weight while they touch: it leaves at the rule's velocity, so that on its parabola it starts with this one.
  const double time = parting.contact_time;
  sphere.velocity = parting.velocity[0] - time * flight_.gravity;
  if constexpr (Rule::displaces) sphere.position += parting.shift[0] + time * time / 2 * flight_.gravity;
  if constexpr (Rule::spins) spin_[i] = parting.spin[0];
  --collisions_left_;
  ++flight_.agenda[i].changes;
  look_ahead(i);
  watch_for_collapse();
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::account(const Meeting& meeting, const Parting& parting, double sign) {
  const Meeting::Body &first = meeting.first, &second = meeting.second;
  const double mass = meeting.wall ? first.mass : first.mass * second.mass / (first.mass + second.mass);
  const Eigen::Vector3d before = meeting.velocity(), branch = meeting.distance * meeting.normal;
  const Eigen::Vector3d after = parting.velocity[0] - (meeting.wall ? second.velocity : parting.velocity[1]);
  totals_.dissipated += sign * mass / 2 * (before.squaredNorm() - after.squaredNorm());
  if constexpr (Rule::spins) {
    const auto spent = [&](const Meeting::Body& body, const Eigen::Vector3d& spin) {
      totals_.dissipated += sign * 0.2 * body.mass * body.radius * body.radius * (body.spin.squaredNorm() - spin.squaredNorm());
    };
    spent(first, parting.spin[0]);
    if (!meeting.wall) spent(second, parting.spin[1]);
  }
  if (meeting.wall) {
    const Eigen::Vector3d impulse = mass * (parting.velocity[0] - first.velocity - parting.contact_time * flight_.gravity);
    totals_.wall_work += sign * impulse.dot(second.velocity);
    totals_.contact_moment -= sign * impulse * branch.transpose();
    totals_.contact_time += sign * parting.contact_time / 2;
    totals_.wall_collisions += sign > 0 ? 1 : -1;
    return;
  }
  const Eigen::Vector3d branch_after = branch + parting.shift[1] - parting.shift[0];
  totals_.contact_moment += sign * mass * (before * branch.transpose() - after * branch_after.transpose());
  totals_.contact_time += sign * parting.contact_time;
  totals_.collisions += sign > 0 ? 1 : -1;
}

template <class Queue, class Rule>
void EventSpheres<Queue, Rule>::watch_for_collapse() {
  const long window = 65536 + 8 * static_cast<long>(count());
  if (++watched_ < window) return;
  const double spent = time() - watched_from_;
  if (spent <= collapsed * longest_watch_)
    throw WorkError(
        fmt::format("the flow collapsed at {:.6g} s: {} collisions of spheres that are constantly in contact took {:.3g} s together, "
                    "and collisions that take no time cannot go on from there; a softer contact needs another engine",
                    time(), window, spent));
  longest_watch_ = std::max(longest_watch_, spent);
  watched_ = 0;
  watched_from_ = time();
}

}  // namespace scalebreak

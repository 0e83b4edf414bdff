#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/few_body_system.hpp>

// What happens to links: where an event lies, and what it changes.

namespace scalebreak {

using Eigen::Vector3d;

void FewBodySystem::set_slide(State& y, std::size_t c, const Slider<3>& slider, std::vector<Change>& changes) {
  Link& link = links_[c];
  const bool held = link.slide == Grip::holds, holds = slider.grip == Grip::holds;
  link.slide = slider.grip;
  put(y, link_at(c) + slide, slider.history);
  if (held != holds) changes.push_back({holds ? ContactChange::stick : ContactChange::slide, link.first, link.second});
}

void FewBodySystem::set_roll(State& y, std::size_t c, const Slider<3>& slider, std::vector<Change>& changes) {
  Link& link = links_[c];
  const bool held = link.roll == Grip::holds, holds = slider.grip == Grip::holds;
  link.roll = slider.grip;
  put(y, link_at(c) + roll, slider.history);
  if (held != holds) changes.push_back({holds ? ContactChange::roll_stop : ContactChange::roll, link.first, link.second});
}

void FewBodySystem::change_roll(State& y, std::size_t c, std::vector<Change>& changes) {
  const MappedLaws& mapped = laws_[links_[c].pair];
  if (!mapped.laws.rolling.rigid()) {
    const Evaluated& e = evaluated_[c];
    Slider<3> slider = e.roll;
    slider.let_go(e.roll_law, e.roll_speed, e.roll_acceleration, time_rate_ * mapped.length);
    return set_roll(y, c, slider, changes);
  }
  // Can the limit hold it, at rest?
  const Grip before = links_[c].roll;
  links_[c].roll = Grip::holds;
  stop_rigid_rolling(y);
  evaluate(y);
  links_[c].roll = before;
  if (before != Grip::holds && evaluated_[c].torque.norm() <= evaluated_[c].roll_law.limit) return set_roll(y, c, {}, changes);
  // What was needed to hold it is beyond the limit: it goes the way it is pushed. In a closed loop none can go alone: with it go those that
  // have as little left to hold it by.
  constexpr double at_limit = 1 - 1e-9;
  for (std::size_t other = 0; other < links_.size(); ++other) {
    const Evaluated& e = evaluated_[other];
    const bool held = links_[other].touching && laws_[links_[other].pair].laws.rolling.acts() &&
                      laws_[links_[other].pair].laws.rolling.rigid() && links_[other].roll == Grip::holds;
    if (other != c && !(held && e.torque.norm() > at_limit * e.roll_law.limit)) continue;
    Slider<3> slider;
    slider.slide_along(e.torque);
    set_roll(y, other, slider, changes);
  }
}

std::vector<FewBodySystem::Change> FewBodySystem::apply(std::size_t k, State& y) {
  constexpr auto kinds = static_cast<std::size_t>(LinkEvent::count);
  std::vector<Change> changes;
  const std::size_t of_links = kinds * links_.size();
  if (k >= of_links + laws_.size()) {
    duration_over_ = true;
    return changes;
  }
  if (k >= of_links) {
    std::size_t pair = k - of_links, i = 0;
    while (pair >= bodies_.size() - i - 1) pair -= bodies_.size() - i - 1, ++i;
    touch(y, i, i + 1 + pair, changes);
    return changes;
  }
  const std::size_t c = k / kinds;
  Link& link = links_[c];
  const ContactLaws& laws = laws_[link.pair].laws;
  evaluate(y);
  switch (static_cast<LinkEvent>(k % kinds)) {
    case LinkEvent::phase_end: {
      if (!link.touching) {
        changes.push_back({ContactChange::rupture, link.first, link.second});
        remove(y, c);
        return changes;
      }
      const double touch = std::visit([](const auto& law) { return law.touch(); }, laws.normal);
      const double end = std::visit([](const auto& law) { return law.separation(); }, laws.normal);
      if (!link.rooted || end >= touch) {
        separate(y, c, changes);
        return changes;
      }
      // Below zero overlap nothing depends on its root; a spring that held a torque there has lost it.
      link.rooted = false;
      y[link_at(c) + root] = 0;
      y[link_at(c) + coordinate] = touch;
      if (laws.rolling.on_overlap()) {
        put(y, link_at(c) + roll, Vector3d::Zero());
        link.roll = Grip::holds;
      }
      break;
    }
    case LinkEvent::phase_begin:
      link.rooted = true;
      y[link_at(c) + root] = begin_share * scales_[link.pair].root;
      y[link_at(c) + coordinate] = std::visit([](const auto& law) { return law.touch(); }, laws.normal);
      break;
    case LinkEvent::slide: {
      Evaluated& e = evaluated_[c];
      e.slide.let_go(e.slide_law, e.slide_speed, e.slide_acceleration, time_rate_ * laws_[link.pair].length);
      set_slide(y, c, e.slide, changes);
      break;
    }
    case LinkEvent::skid:
      evaluated_[c].slide.skid(evaluated_[c].slide_law, evaluated_[c].slide_speed);
      set_slide(y, c, evaluated_[c].slide, changes);
      break;
    case LinkEvent::roll: change_roll(y, c, changes); break;
    case LinkEvent::load_sign: {
      link.load_sign = -link.load_sign;
      evaluate(y);
      Evaluated& e = evaluated_[c];
      const double time = time_rate_ * laws_[link.pair].length;
      if (laws.tangential.acts()) {
        e.slide.restart(e.slide_law, e.slide_speed, e.slide_acceleration, time);
        set_slide(y, c, e.slide, changes);
      }
      if (laws.rolling.acts() && !laws.rolling.rigid()) {
        e.roll.restart(e.roll_law, e.roll_speed, e.roll_acceleration, time);
        set_roll(y, c, e.roll, changes);
      }
      break;
    }
    case LinkEvent::near: link.near = !link.near; break;
    case LinkEvent::branch: link.second_branch = !link.second_branch; break;
    case LinkEvent::turn:
      link.turn_backs += link.outgoing;
      link.outgoing = !link.outgoing;
      break;
    case LinkEvent::count: break;
  }
  relink();
  return changes;
}

std::array<int, 2> FewBodySystem::bodies_of(std::size_t k) const {
  const std::size_t c = k / static_cast<std::size_t>(LinkEvent::count);
  return c < links_.size() ? std::array{links_[c].first, links_[c].second} : std::array{-1, -1};
}

double FewBodySystem::roll_event(const Link& link, const Evaluated& e) const {
  const Rolling& rolling = laws_[link.pair].laws.rolling;
  if (!rolling.acts()) return -1;
  if (rolling.rigid()) {
    // A little past zero: what has just been let go starts there.
    return link.roll == Grip::slides ? -1e-13 * scales_[link.pair].roll - e.roll.direction().dot(e.roll_speed)
                                     : e.torque.norm() - e.roll_law.limit * (1 + 1e-13);
  }
  return e.roll.end_of_grip(e.roll_law, e.roll_speed, e.roll_acceleration, time_rate_ * laws_[link.pair].length);
}

void FewBodySystem::event_values(const State& y, Values& values) {
  constexpr auto kinds = static_cast<std::size_t>(LinkEvent::count);
  values.assign(kinds * links_.size() + laws_.size() + 1, -1.0);
  if (!links_.empty()) evaluate(y);
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Link& link = links_[c];
    const Evaluated& e = evaluated_[c];
    const ContactLaws& laws = laws_[link.pair].laws;
    const PairScales& scales = scales_[link.pair];
    const auto set = [&](LinkEvent event, double value) { values[kinds * c + static_cast<std::size_t>(event)] = value; };
    if (link.touching) {
      const double touch = std::visit([](const auto& law) { return law.touch(); }, laws.normal);
      const double end = std::visit([](const auto& law) { return law.separation(); }, laws.normal);
      set(LinkEvent::phase_end,
          link.rooted ? end_share - e.root / scales.root : (end - e.coordinate) / scales.coordinate + (flat_touch(laws) ? end_share : 0.0));
      if (!link.rooted && laws.needs_overlap_root()) set(LinkEvent::phase_begin, (e.coordinate - touch) / scales.coordinate);
      if (laws.tangential.acts()) {
        set(LinkEvent::slide, e.slide.end_of_grip(e.slide_law, e.slide_speed, e.slide_acceleration, time_rate_ * laws_[link.pair].length));
        set(LinkEvent::skid, e.slide.begin_of_skid(e.slide_law, e.slide_speed, e.slide_acceleration));
      }
      set(LinkEvent::roll, roll_event(link, e));
      if (laws.uses_load()) set(LinkEvent::load_sign, -e.point.load);
      // What has come to rest turns to and fro by rounding alone.
      set(LinkEvent::turn, (link.outgoing ? e.approach : -e.approach) - 1e-13 * speed_unit_);
    }
    if (laws.liquid.acts() && (link.touching || link.bridged)) {
      const double beyond = e.separation - laws.liquid.separation_min;
      set(LinkEvent::near, link.near ? beyond : -beyond);
      const double branch = e.separation - laws.liquid.rolling_branch();
      if (laws.liquid.viscous && !link.near) set(LinkEvent::branch, link.second_branch ? -branch : branch);
      if (!link.touching) set(LinkEvent::phase_end, e.separation - laws.liquid.rupture);
    }
  }
  for (std::size_t i = 0, pair = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j, ++pair) {
      const int link = link_of_[pair];
      if ((link >= 0 && links_[static_cast<std::size_t>(link)].touching) || bodies_[i].plane) continue;
      if (!std::isfinite(bodies_[i].mass) && !std::isfinite(bodies_[j].mass)) continue;
      const Geometry g = geometry(y, i, j);
      values[kinds * links_.size() + pair] = std::min(-g.gap / length_unit_, g.velocity.dot(g.normal) / speed_unit_);
    }
  }
  if (duration_ > 0) values.back() = (y.back() - duration_) / time_unit_;
}

}  // namespace scalebreak

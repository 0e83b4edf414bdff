#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/few_body_system.hpp>
#include <scalebreak/scene/check_bodies.hpp>

// Contacts and bridges that begin and end.

namespace scalebreak {

using Eigen::Vector3d;

void FewBodySystem::begin(State& y, std::vector<Change>& changes) {
  for (std::size_t i = 0, pair = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j, ++pair) {
      if (bodies_[i].plane || (!std::isfinite(bodies_[i].mass) && !std::isfinite(bodies_[j].mass))) continue;
      const ContactLaws& laws = laws_[pair].laws;
      const bool attracts = laws.liquid.acts() || std::visit([](const auto& law) { return law.force(law.touch()) < 0; }, laws.normal);
      const double radius = bodies_[j].plane ? bodies_[i].radius : std::min(bodies_[i].radius, bodies_[j].radius);
      const Geometry g = geometry(y, i, j);
      const bool at_touch = g.gap <= touching_gap * radius && g.gap >= -touching_overlap * radius;
      if (attracts && at_touch && std::abs(g.velocity.dot(g.normal)) <= resting_speed * speed_unit_) touch(y, i, j, changes);
    }
  }
}

bool FewBodySystem::fly(State& y, std::vector<Change>& changes) {
  const double never = std::numeric_limits<double>::infinity();
  double first = never;
  std::size_t first_i = 0, first_j = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
      if (bodies_[i].plane || (!std::isfinite(bodies_[i].mass) && !std::isfinite(bodies_[j].mass))) continue;
      const Geometry g = geometry(y, i, j);
      const double closing = g.velocity.dot(g.normal);
      double when = never;
      if (closing > 0 && g.gap <= 0) {
        when = 0;
      } else if (bodies_[j].plane) {
        if (closing > 0) when = g.gap / closing;
      } else if (closing > 0) {
        // |x + vt| = r₁ + r₂: the first root, without cancellation.
        const double square = g.velocity.squaredNorm(), half = closing * g.distance;
        const double rest = g.gap * (2 * g.distance - g.gap), under = half * half - square * rest;
        if (under > 0) when = rest / (half + std::sqrt(under));
      }
      if (when < first) first = when, first_i = i, first_j = j;
    }
  }
  const bool meets = std::isfinite(first) && !(duration_ > 0 && y.back() + first > duration_);
  const double time = meets ? first : std::max(0.0, duration_ - y.back());
  for (std::size_t b = 0; b < bodies_.size(); ++b) put(y, body_at(b), at(y, body_at(b)) + time * at(y, body_at(b) + 3));
  y.back() += time;
  if (meets) touch(y, first_i, first_j, changes);
  return meets;
}

void FewBodySystem::touch(State& y, std::size_t i, std::size_t j, std::vector<Change>& changes) {
  const std::size_t pair = pair_index(i, j);
  const ContactLaws& laws = laws_[pair].laws;
  if (link_of_[pair] < 0) {
    link_of_[pair] = static_cast<int>(links_.size());
    links_.push_back({.first = static_cast<int>(i), .second = static_cast<int>(j), .pair = pair});
    y.insert(y.end() - 1, block_size, 0.0);
  }
  const auto c = static_cast<std::size_t>(link_of_[pair]);
  Link& link = links_[c];
  link.touching = true;
  link.rooted = laws.needs_overlap_root();
  // Bodies that meet again within their bridge have turned back.
  link.turn_backs += link.bridged;
  if (laws.liquid.bridges() && !link.bridged) {
    link.bridged = true;
    changes.push_back({ContactChange::bridge, link.first, link.second});
  }
  link.near = true;
  link.second_branch = false;
  link.outgoing = false;
  link.load_sign = 1;
  link.slide = link.roll = Grip::holds;
  const std::size_t base = link_at(c);
  y[base + root] = link.rooted ? begin_share * scales_[pair].root : 0.0;
  y[base + coordinate] = std::visit([](const auto& law) { return law.touch(); }, laws.normal);
  if (flat_touch(laws)) y[base + coordinate] = begin_share * scales_[pair].coordinate;
  put(y, base + slide, Vector3d::Zero());
  put(y, base + roll, Vector3d::Zero());
  link.normal_at_touch = geometry(y, i, j).normal;
  relink();
  first_modes(y, c);
  relink();
  changes.push_back({ContactChange::touch, link.first, link.second});
  if (link.slide != Grip::holds) changes.push_back({ContactChange::slide, link.first, link.second});
  if (link.roll != Grip::holds) changes.push_back({ContactChange::roll, link.first, link.second});
}

/// Does the contact slide and roll from its first instant? Asked a little into it, with springs stretched as the motion would.
void FewBodySystem::first_modes(State& y, std::size_t c) {
  Link& link = links_[c];
  const MappedLaws& mapped = laws_[link.pair];
  const std::size_t base = link_at(c);
  State little = y;
  constexpr double share = 1e-5;
  const PairScales& scales = scales_[link.pair];
  little[base + root] = share * scales.root;
  little[base + coordinate] += link.rooted ? 0.0 : share * scales.coordinate;
  evaluate(little);
  Evaluated& e = evaluated_[c];
  const double time = e.approach > 0 ? e.point.overlap / e.approach : 0.0;
  if (mapped.laws.tangential.acts()) {
    const Slider<3> slider = first_slider<3>(e.slide_law, e.slide_speed, time);
    put(y, base + slide, slider.history);
    link.slide = slider.grip;
  }
  if (mapped.laws.rolling.acts()) {
    Slider<3> slider;
    if (!mapped.laws.rolling.rigid()) {
      slider = first_slider<3>(e.roll_law, e.roll_speed, time);
    } else if (e.roll_speed.norm() > 1e-12 * speed_unit_ / mapped.laws.radius) {
      slider.slide_along(e.roll_speed);
    }
    put(y, base + roll, slider.history);
    link.roll = slider.grip;
  }
}

void FewBodySystem::separate(State& y, std::size_t c, std::vector<Change>& changes) {
  Link& link = links_[c];
  const MappedLaws& mapped = laws_[link.pair];
  changes.push_back({ContactChange::separation, link.first, link.second});
  spent_.adhesion +=
      std::visit([](const auto& law) { return law.energy(law.separation()); }, mapped.laws.normal) * mapped.force / mapped.length;
  if (!link.bridged) return remove(y, c);
  link.touching = link.rooted = false;
  link.slide = link.roll = Grip::holds;
  const std::size_t base = link_at(c);
  std::fill(y.begin() + static_cast<std::ptrdiff_t>(base), y.begin() + static_cast<std::ptrdiff_t>(base + damping_work), 0.0);
  const auto g = geometry(y, static_cast<std::size_t>(link.first), static_cast<std::size_t>(link.second));
  link.near = g.gap * mapped.length < mapped.laws.liquid.separation_min;
  relink();
}

void FewBodySystem::remove(State& y, std::size_t c) {
  const std::size_t base = link_at(c);
  spent_.damping += y[base + damping_work];
  spent_.friction += y[base + tangential_work];
  spent_.rolling += y[base + rolling_work];
  spent_.liquid += y[base + liquid_work];
  y.erase(y.begin() + static_cast<std::ptrdiff_t>(base), y.begin() + static_cast<std::ptrdiff_t>(base + block_size));
  links_.erase(links_.begin() + static_cast<std::ptrdiff_t>(c));
  relink();
}

}  // namespace scalebreak

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/few_body_system.hpp>

// What there is to see of the contacts at one state.

namespace scalebreak {

double FewBodySystem::scaled_overlap(const State& y, std::size_t c) const {
  const MappedLaws& mapped = laws_[links_[c].pair];
  const double x = y[link_at(c) + coordinate];
  return std::visit([&](const auto& law) { return law.overlap(x); }, mapped.laws.normal) / mapped.length;
}

double FewBodySystem::largest_overlap(const State& y) const {
  double largest = 0;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    if (links_[c].touching) largest = std::max(largest, scaled_overlap(y, c));
  }
  return largest;
}

double FewBodySystem::largest_depth(const State& y) const {
  double largest = 0;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    if (!links_[c].touching) continue;
    const MovingBody& first = bodies_[static_cast<std::size_t>(links_[c].first)];
    const MovingBody& second = bodies_[static_cast<std::size_t>(links_[c].second)];
    const double curvature = 1 / first.radius + (second.plane ? 0.0 : 1 / second.radius);
    largest = std::max(largest, scaled_overlap(y, c) * curvature);
  }
  return largest;
}

FewBodySystem::Deepest FewBodySystem::deepest(const State& y) const {
  Deepest deepest;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    if (!links_[c].touching) continue;
    const MovingBody& first = bodies_[static_cast<std::size_t>(links_[c].first)];
    const MovingBody& second = bodies_[static_cast<std::size_t>(links_[c].second)];
    const double overlap = scaled_overlap(y, c), radius = second.plane ? first.radius : std::min(first.radius, second.radius);
    if (overlap * deepest.radius > deepest.overlap * radius) deepest = {links_[c].first, links_[c].second, overlap, radius};
  }
  return deepest;
}

double FewBodySystem::largest_force(const State& y) {
  double largest = 0;
  if (!links_.empty()) evaluate(y);
  for (std::size_t c = 0; c < links_.size(); ++c) {
    if (links_[c].touching) largest = std::max(largest, laws_[links_[c].pair].force * evaluated_[c].normal.total);
  }
  return largest;
}

std::vector<ContactState> FewBodySystem::contacts(const State& y) {
  std::vector<ContactState> states;
  if (!links_.empty()) evaluate(y);
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Link& link = links_[c];
    const MappedLaws& mapped = laws_[link.pair];
    const Evaluated& e = evaluated_[c];
    const double solid = link.touching ? e.normal.total : 0.0;
    ContactState state{.first = link.first,
                       .second = link.second,
                       .touching = link.touching,
                       .overlap = link.touching ? scaled_overlap(y, c) : -e.at.gap,
                       .normal_force = mapped.force * solid,
                       .liquid_force = mapped.force * (e.normal_force - solid),
                       .tangential_force = -mapped.force * e.friction};
    if (link.touching) {
      state.contact_radius = e.point.root * e.point.root;
      state.tangential_stiffness = mapped.force * mapped.length * e.slide_law.stiffness;
    }
    const double first = bodies_[static_cast<std::size_t>(link.first)].radius;
    const double second =
        bodies_[static_cast<std::size_t>(link.second)].plane ? 0.0 : bodies_[static_cast<std::size_t>(link.second)].radius;
    state.surface_velocity = e.centres + (first * e.turning[0] + second * e.turning[1]) / mapped.spin;
    state.slides = link.touching && mapped.laws.tangential.acts() && link.slide != Grip::holds;
    state.rolls = link.touching && mapped.laws.rolling.acts() && link.roll != Grip::holds;
    states.push_back(state);
  }
  return states;
}

EnergyAccount FewBodySystem::account(const State& y) {
  EnergyAccount sum = spent_;
  sum.kinetic = kinetic_energy(bodies(y));
  if (!links_.empty()) evaluate(y);
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const MappedLaws& mapped = laws_[links_[c].pair];
    const Evaluated& e = evaluated_[c];
    const std::size_t base = link_at(c);
    const double map = mapped.force / mapped.length;
    sum.damping += y[base + damping_work];
    sum.friction += y[base + tangential_work];
    sum.rolling += y[base + rolling_work];
    sum.liquid += y[base + liquid_work];
    if (!links_[c].touching) continue;
    sum.elastic += map * std::visit([&](const auto& law) { return law.energy(e.coordinate); }, mapped.laws.normal);
    if (!mapped.laws.tangential.acts()) continue;
    const double spring = map * e.slide.energy(e.slide_law, e.slide_speed);
    sum.elastic += spring;
    sum.friction -= spring;
  }
  return sum;
}

double FewBodySystem::turned(const State& y, const Link& link) const {
  const Eigen::Vector3d n = geometry(y, static_cast<std::size_t>(link.first), static_cast<std::size_t>(link.second)).normal;
  return std::atan2(link.normal_at_touch.cross(n).norm(), link.normal_at_touch.dot(n));
}

}  // namespace scalebreak

#include <scalebreak/collisions/few_body_system.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <Eigen/Geometry>

#include <scalebreak/base/error.hpp>

// Units, links and modes: all that changes only at events.

namespace scalebreak {
namespace {

using Eigen::Vector3d;

Vector3d at(const FewBodySystem::State& y, std::size_t i) { return {y[i], y[i + 1], y[i + 2]}; }

void put(FewBodySystem::State& y, std::size_t i, const Vector3d& v) {
  y[i] = v[0];
  y[i + 1] = v[1];
  y[i + 2] = v[2];
}

/// Depth of the potential well below first touch (0 without adhesion), and the coordinate that an energy reaches.
struct Reach {
  double depth, coordinate;
};
template <class Law>
Reach reach(const Law& law, double energy) {
  double depth = 0, x = law.touch();
  if constexpr (std::is_same_v<Law, Jkr<double>> || std::is_same_v<Law, Jkr<double, DampingOn::overlap>>) {
    x = std::cbrt(law.adhesive_force / law.stiffness);  // where the force is zero
    depth = -law.energy(x);
  }
  const double wanted = energy + depth;
  double high = x > 0 ? 2 * x : 1e-12;
  while (law.energy(high) < wanted) high *= 2;
  double low = x;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (law.energy(middle) < wanted ? low : high) = middle;
  }
  return {depth, high};
}

double reduced_mass(const MovingBody& a, const MovingBody& b) { return 1 / (1 / a.mass + 1 / b.mass); }

}  // namespace

FewBodySystem::FewBodySystem(std::vector<MovingBody> bodies, const std::function<MappedLaws(int, int)>& laws, double duration)
    : bodies_(std::move(bodies)), duration_(duration), acceleration_(bodies_.size()), spin_rate_(bodies_.size()) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j) laws_.push_back(laws(static_cast<int>(i), static_cast<int>(j)));
  }
  link_of_.assign(laws_.size(), -1);
  set_units();
  relink();
}

std::size_t FewBodySystem::pair_index(std::size_t i, std::size_t j) const { return i * (2 * bodies_.size() - i - 1) / 2 + (j - i - 1); }

/// The scene is measured by its largest relative speed, of surfaces too, or by what adhesion gives where all is at rest; a contact
/// by the overlap that this speed reaches.
void FewBodySystem::set_units() {
  double speed = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
      speed = std::max({speed, (bodies_[i].velocity - bodies_[j].velocity).norm(), bodies_[i].spin.norm() * bodies_[i].radius,
                        bodies_[j].spin.norm() * bodies_[j].radius});
    }
  }
  length_unit_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, pair = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j, ++pair) {
      const MappedLaws& mapped = laws_[pair];
      const double mass = reduced_mass(bodies_[i], bodies_[j]);
      PairScales scales;
      if (std::isfinite(mass)) {
        std::visit(
            [&](const auto& law) {
              const double energy = mass * speed * speed / 2 * mapped.length / mapped.force;
              const auto [depth, x] = reach(law, energy);
              scales.depth = depth * mapped.force / mapped.length;
              scales.coordinate = x;
              scales.overlap = law.overlap(x);
              scales.force = std::abs(law.force(x));
              scales.slope = law.overlap_slope(x);
            },
            mapped.laws.normal);
        scales.root = std::sqrt(std::sqrt(scales.overlap));
        scales.root_slope = 4 * scales.overlap / scales.root;
        length_unit_ = std::min(length_unit_, scales.overlap / mapped.length);
        energy_unit_ = std::max(energy_unit_, mass * speed * speed / 2 + scales.depth);
        speed_unit_ = std::max(speed_unit_, std::sqrt(speed * speed + 2 * scales.depth / mass));
      }
      scales_.push_back(scales);
    }
  }
  if (!(speed_unit_ > 0)) throw WorkError("nothing moves: the bodies are at rest, and no contact holds energy");
  time_unit_ = 3 * length_unit_ / speed_unit_;
  for (std::size_t pair = 0; pair < laws_.size(); ++pair) {
    const MappedLaws& mapped = laws_[pair];
    PairScales& scales = scales_[pair];
    const double displacement = scales.overlap / mapped.laws.radius;
    scales.roll = displacement;
    if (mapped.laws.rolling.rigid()) scales.roll = speed_unit_ / mapped.laws.radius;
    if (mapped.laws.rolling.model == RollingModel::epsd || mapped.laws.rolling.model == RollingModel::epsd2) {
      const ContactPoint deep{.overlap = scales.overlap,
                              .root = scales.coordinate,
                              .overlap_root = std::sqrt(std::sqrt(mapped.laws.radius)) * scales.root,
                              .load = 0};
      scales.roll *= mapped.laws.rolling.at(deep, {}).stiffness;
    }
    if (!(scales.roll > 0)) scales.roll = 1;
  }
}

FewBodySystem::State FewBodySystem::start() const {
  State y(9 * bodies_.size() + 1, 0.0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    put(y, body_at(b), bodies_[b].position);
    put(y, body_at(b) + 3, bodies_[b].velocity);
    put(y, body_at(b) + 6, bodies_[b].spin);
  }
  return y;
}

std::vector<MovingBody> FewBodySystem::bodies(const State& y) const {
  std::vector<MovingBody> result = bodies_;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    result[b].position = at(y, body_at(b));
    result[b].velocity = at(y, body_at(b) + 3);
    result[b].spin = at(y, body_at(b) + 6);
  }
  return result;
}

/// After links or modes have changed: who is linked, and what each component's error is measured against.
void FewBodySystem::relink() {
  std::fill(link_of_.begin(), link_of_.end(), -1);
  evaluated_.resize(links_.size());
  scale_.assign(9 * bodies_.size() + block_size * links_.size() + 1, 1.0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (std::size_t k = 0; k < 3; ++k) {
      scale_[body_at(b) + k] = length_unit_;
      scale_[body_at(b) + 3 + k] = speed_unit_;
      scale_[body_at(b) + 6 + k] = bodies_[b].radius > 0 ? speed_unit_ / bodies_[b].radius : 1.0;
    }
  }
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Link& link = links_[c];
    const PairScales& scales = scales_[link.pair];
    link_of_[link.pair] = static_cast<int>(c);
    double* s = &scale_[link_at(c)];
    s[root] = scales.root;
    s[coordinate] = scales.coordinate;
    for (std::size_t k = 0; k < 3; ++k) {
      s[slide + k] = link.slide == Grip::slides ? 1.0 : scales.overlap;
      s[roll + k] = link.roll == Grip::slides ? 1.0 : scales.roll;
    }
    for (const std::size_t work : {damping_work, tangential_work, rolling_work, liquid_work}) s[work] = energy_unit_;
  }
  scale_.back() = time_unit_;
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
  Slider<3> slider = evaluated_[c].roll;
  if (!mapped.laws.rolling.rigid()) {
    const Evaluated& e = evaluated_[c];
    slider.let_go(e.roll_law, e.roll_speed, e.roll_acceleration, time_rate_ * mapped.length);
  } else if (slider.grip == Grip::holds) {  // what was needed to hold it is beyond the limit: it goes the way it was pushed
    slider.slide_along(evaluated_[c].torque);
  } else {  // at rest: can the limit hold it?
    links_[c].roll = Grip::holds;
    evaluate(y);
    links_[c].roll = Grip::slides;
    const Evaluated& e = evaluated_[c];
    slider = {};
    if (e.torque.norm() > e.roll_law.limit) slider.slide_along(e.torque);
    if (slider.grip == Grip::holds) {  // what little rolling is left would be held too; without it the angular momentum is the same
      const std::size_t i = static_cast<std::size_t>(links_[c].first), j = static_cast<std::size_t>(links_[c].second);
      const Vector3d left = e.at.normal.cross(e.roll_speed) / mapped.spin;
      const double first = 1 / bodies_[i].inertia, second = 1 / bodies_[j].inertia;
      put(y, body_at(i) + 6, at(y, body_at(i) + 6) - left * (first / (first + second)));
      put(y, body_at(j) + 6, at(y, body_at(j) + 6) + left * (second / (first + second)));
    }
  }
  set_roll(y, c, slider, changes);
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
  const Vector3d n = geometry(y, static_cast<std::size_t>(link.first), static_cast<std::size_t>(link.second)).normal;
  return std::atan2(link.normal_at_touch.cross(n).norm(), link.normal_at_touch.dot(n));
}

}  // namespace scalebreak

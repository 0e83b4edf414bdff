#include <algorithm>
#include <cmath>
#include <limits>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/bodies/few_body_system.hpp>
#include <scalebreak/collisions/bodies/normal_well.hpp>

// The units of a motion, and its state.

namespace scalebreak {
namespace {

using Eigen::Vector3d;

/// Depth of the potential well below first touch (0 without attraction) [J], and the coordinate that an energy reaches.
struct Reach {
  double depth, coordinate;
};
template <class Law>
Reach reach(const Law& law, double energy, double pull) {
  const double bottom = well_bottom(law, pull), depth = -well_energy(law, bottom, pull);
  double low = bottom, high = low > 0 ? 2 * low : 1e-12;
  while (well_energy(law, high, pull) < energy) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (well_energy(law, middle, pull) < energy ? low : high) = middle;
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

/// The scene is measured by its largest relative speed, of surfaces too, or by what attraction gives where all is at rest; a contact
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
              const auto [depth, x] = reach(law, energy, mapped.laws.liquid.capillary_force(mapped.laws.liquid.separation_min));
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
  evaluated_state_.clear();  // a change works on what was evaluated
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
      s[slide + k] = link.slide == Grip::slides || link.slide == Grip::relaxes ? 1.0 : scales.overlap;
      s[roll + k] = link.roll == Grip::slides ? 1.0 : scales.roll;
    }
    for (const std::size_t work : {damping_work, tangential_work, rolling_work, liquid_work}) s[work] = energy_unit_;
  }
  scale_.back() = time_unit_;
}

}  // namespace scalebreak

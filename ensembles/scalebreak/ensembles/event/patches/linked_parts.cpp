#include <scalebreak/ensembles/event/patches/linked_parts.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <scalebreak/ensembles/event/flight/instants.hpp>

namespace scalebreak {
namespace {

/// Which of some spheres belong together.
class Bonds {
 public:
  explicit Bonds(std::uint32_t count) : parent_(count), acts_(count, 0) { std::iota(parent_.begin(), parent_.end(), 0u); }
  [[nodiscard]] std::uint32_t root(std::uint32_t k) const {
    while (parent_[k] != k) k = parent_[k];
    return k;
  }
  /// Links two, or one to a wall.
  void link(std::uint32_t a, std::uint32_t b) {
    acts_[a] = acts_[b] = 1;
    const std::uint32_t first = root(a), second = root(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }
  [[nodiscard]] int acts(std::uint32_t k) const { return acts_[k]; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> acts_;
};

/// What one sphere's velocity may be changed by as it meets another, or a wall (of infinite mass): at most an elastic collision's change.
double push_of(const GroupSphere& one, const Eigen::Vector3d& velocity, double mass, double spinning) {
  const double share = std::isfinite(mass) ? 2 * mass / (one.mass + mass) : 2.0;
  return share * ((one.velocity - velocity).norm() + spinning / 2);
}

class Linker {
 public:
  Linker(Patch& patch, double horizon) : patch_(patch), horizon_(horizon), bonds_(patch.group.count()) {
    for (std::uint32_t k = 0; k < patch.group.count(); ++k) spheres_.push_back(patch.group.sphere(k));
  }

  void link_contacts() {
    for (const ContactMemory& contact : patch_.group.contacts()) {
      const auto first = static_cast<std::uint32_t>(contact.first);
      if (contact.second >= 0) link(first, static_cast<std::uint32_t>(contact.second));
    }
    for (const dem::WallView& wall : patch_.group.laws().walls()) {
      for (std::uint32_t k = 0; k < patch_.group.count(); ++k) {
        const GroupSphere& one = spheres_[k];
        const double height = wall.side * (wall.place - one.position[wall.axis]), speed = -wall.side * one.velocity[wall.axis];
        const double fall = -wall.side * patch_.group.laws().gravity()[wall.axis];
        if (time_to_wall(height, speed, fall, one.radius) > horizon_ && !(height < one.radius)) continue;
        bonds_.link(k, k);
        const double gained = std::abs(fall) * horizon_;
        patch_.push[k] = std::max(patch_.push[k], push_of(one, {wall.velocity.x, 0, 0}, INFINITY, spinning(one)) + gained);
      }
    }
  }

  /// Links what may touch, of spheres in the order of their x; true if there was anything.
  bool link_near() {
    std::vector<std::uint32_t> order(spheres_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(spheres_[a].position.x(), a) < std::pair(spheres_[b].position.x(), b);
    });
    double radius = 0, run = 0;
    for (std::uint32_t k = 0; k < spheres_.size(); ++k)
      radius = std::max(radius, spheres_[k].radius),
      run = std::max(run, (spheres_[k].velocity - spheres_[0].velocity).norm() + patch_.push[k]);
    const double most = 2 * (radius + run * horizon_);
    bool linked = false;
    for (std::size_t n = 0; n < order.size(); ++n) {
      const std::uint32_t a = order[n];
      for (std::size_t m = n + 1; m < order.size() && spheres_[order[m]].position.x() - spheres_[a].position.x() < most; ++m)
        linked = link_if_near(a, order[m]) || linked;
    }
    return linked;
  }

  [[nodiscard]] const Bonds& bonds() const { return bonds_; }

 private:
  [[nodiscard]] double spinning(const GroupSphere& one) const { return patch_.group.laws().turns() ? one.radius * one.spin.norm() : 0.0; }

  bool link_if_near(std::uint32_t a, std::uint32_t b) {
    const int act = bonds_.acts(a) + bonds_.acts(b);
    if (act == 2 && bonds_.root(a) == bonds_.root(b)) return false;
    const GroupSphere &one = spheres_[a], &other = spheres_[b];
    constexpr double rounding = 1 + 1e-12;  // of two that have just met at less than that per time
    const double reach = (one.radius + other.radius) * rounding + (swerve(a) + swerve(b)) * horizon_;
    const Eigen::Vector3d apart = other.position - one.position, velocity = other.velocity - one.velocity;
    if (least_square_distance(apart, velocity, horizon_) > reach * reach) return false;
    // Those that only just touched and part do not meet.
    if (act == 0 && apart.dot(velocity) >= 0) return false;
    link(a, b);
    return true;
  }

  [[nodiscard]] double swerve(std::uint32_t k) const { return bonds_.acts(k) ? patch_.push[k] : 0.0; }

  void link(std::uint32_t a, std::uint32_t b) {
    bonds_.link(a, b);
    const GroupSphere &one = spheres_[a], &other = spheres_[b];
    const double turning = spinning(one) + spinning(other);
    patch_.push[a] = std::max(patch_.push[a], push_of(one, other.velocity, other.mass, turning));
    patch_.push[b] = std::max(patch_.push[b], push_of(other, one.velocity, one.mass, turning));
  }

  Patch& patch_;
  double horizon_;
  Bonds bonds_;
  std::vector<GroupSphere> spheres_;
};

}  // namespace

LinkedParts linked_parts(Patch& patch, double horizon) {
  Linker linker(patch, horizon);
  linker.link_contacts();
  while (linker.link_near()) {
  }
  const Bonds& bonds = linker.bonds();
  const std::uint32_t count = patch.group.count();
  LinkedParts linked;
  std::vector<std::size_t> place(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (!bonds.acts(k)) {
      linked.alone.push_back(k);
      patch.push[k] = 0;
      continue;
    }
    const std::uint32_t root = bonds.root(k);
    if (root == k) place[k] = linked.parts.size(), linked.parts.emplace_back();
    linked.parts[place[root]].push_back(k);
  }
  return linked;
}

}  // namespace scalebreak

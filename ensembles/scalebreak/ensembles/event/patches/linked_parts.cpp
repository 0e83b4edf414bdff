#include <scalebreak/ensembles/event/patches/linked_parts.hpp>

#include <algorithm>
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

void link_to_walls(const DemGroup& group, double horizon, Bonds& bonds) {
  for (const dem::WallView& wall : group.laws().walls()) {
    for (std::uint32_t k = 0; k < group.count(); ++k) {
      const double height = wall.side * (wall.place - group.position(k)[wall.axis]), speed = -wall.side * group.velocity(k)[wall.axis];
      if (time_to_wall(height, speed, -wall.side * group.laws().gravity()[wall.axis], group.radius(k)) <= horizon) bonds.link(k, k);
    }
  }
}

}  // namespace

LinkedParts linked_parts(const DemGroup& group, double horizon, double swerve) {
  Bonds bonds(group.count());
  for (const ContactMemory& contact : group.contacts()) {
    const auto first = static_cast<std::uint32_t>(contact.first);
    bonds.link(first, contact.second < 0 ? first : static_cast<std::uint32_t>(contact.second));
  }
  link_to_walls(group, horizon, bonds);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t a = 0; a < group.count(); ++a) {
      for (std::uint32_t b = a + 1; b < group.count(); ++b) {
        if (bonds.acts(a) && bonds.acts(b) && bonds.root(a) == bonds.root(b)) continue;
        const double reach = group.radius(a) + group.radius(b) + (bonds.acts(a) + bonds.acts(b)) * swerve;
        const Eigen::Vector3d apart = group.position(b) - group.position(a), velocity = group.velocity(b) - group.velocity(a);
        constexpr double rounding = 1 + 1e-12;  // of two that have just met at less than that per time
        if (least_square_distance(apart, velocity, horizon) > reach * reach * rounding) continue;
        // Those that only just touched and part do not meet.
        if (!bonds.acts(a) && !bonds.acts(b) && apart.dot(velocity) >= 0) continue;
        bonds.link(a, b);
        changed = true;
      }
    }
  }
  LinkedParts linked;
  std::vector<std::size_t> place(group.count());
  for (std::uint32_t k = 0; k < group.count(); ++k) {
    if (!bonds.acts(k)) {
      linked.alone.push_back(k);
      continue;
    }
    const std::uint32_t root = bonds.root(k);
    if (root == k) place[k] = linked.parts.size(), linked.parts.emplace_back();
    linked.parts[place[root]].push_back(k);
  }
  return linked;
}

}  // namespace scalebreak

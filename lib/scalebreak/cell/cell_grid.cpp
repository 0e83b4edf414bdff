#include <scalebreak/cell/cell_grid.hpp>

#include <cmath>

namespace scalebreak {

CellGrid::CellGrid(const Cell& cell, std::span<const Eigen::Vector3d> position, std::span<const double> radius, double reach)
    : cell_(cell), reach_(reach) {
  if (position.empty()) return;
  const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
  double below = *least;
  std::vector<Level> levels;
  do {
    below = below > 0 ? 2 * below : 2 * *most;
    levels.emplace_back();
  } while (below <= *most && below > 0);
  for (std::uint32_t i = 0; i < position.size(); ++i) {
    const auto octaves = *least > 0 ? static_cast<std::size_t>(std::ilogb(radius[i] / *least)) : 0;
    Level& level = levels[std::min(octaves, levels.size() - 1)];
    level.sphere.push_back(i);
    level.largest = std::max(level.largest, radius[i]);
  }
  for (Level& level : levels) {
    if (level.sphere.empty()) continue;
    sort_into_bins(level, position, radius);
    levels_.push_back(std::move(level));
  }
}

void CellGrid::sort_into_bins(Level& level, std::span<const Eigen::Vector3d> position, std::span<const double> radius) const {
  const auto count = static_cast<double>(level.sphere.size());
  const double one_a_bin = std::cbrt(cell_.volume() / count);  // more bins than spheres would only cost memory
  const double width = std::max(2 * level.largest + reach_, one_a_bin);
  for (int axis = 0; axis < 3; ++axis) {
    const double fitting = std::floor(cell_.size[axis] / width);
    const int bins = fitting >= 1 ? static_cast<int>(std::min(fitting, count)) : 1;
    level.bins[static_cast<std::size_t>(axis)] = bins;
    level.bin_size[axis] = cell_.size[axis] / bins;
  }

  std::vector<Eigen::Vector3d> wrapped(level.sphere.size());
  std::vector<int> bins(level.sphere.size());
  level.start.assign(
      static_cast<std::size_t>(level.bins[0]) * static_cast<std::size_t>(level.bins[1]) * static_cast<std::size_t>(level.bins[2]) + 1, 0);
  for (std::size_t k = 0; k < wrapped.size(); ++k) {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    wrapped[k] = position[level.sphere[k]];
    wrap(cell_, wrapped[k], velocity);
    bins[k] = bin(level, wrapped[k]);
    ++level.start[static_cast<std::size_t>(bins[k]) + 1];
  }
  for (std::size_t b = 1; b < level.start.size(); ++b) level.start[b] += level.start[b - 1];

  const std::vector<std::uint32_t> given = level.sphere;
  std::vector<std::uint32_t> next = level.start;
  level.position.resize(given.size());
  level.radius.resize(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::uint32_t slot = next[static_cast<std::size_t>(bins[k])]++;
    level.sphere[slot] = given[k];
    level.position[slot] = wrapped[k];
    level.radius[slot] = radius[given[k]];
  }
}

int CellGrid::bin(const Level& level, const Eigen::Vector3d& wrapped) const {
  std::array<int, 3> at{};
  for (int axis = 0; axis < 3; ++axis) {
    const int last = level.bins[static_cast<std::size_t>(axis)] - 1;
    at[static_cast<std::size_t>(axis)] =
        last == 0 ? 0 : static_cast<int>(std::clamp(std::floor(wrapped[axis] / level.bin_size[axis]), 0.0, static_cast<double>(last)));
  }
  return (at[2] * level.bins[1] + at[1]) * level.bins[0] + at[0];
}

CellGrid::Range CellGrid::range(const Level& level, int axis, double middle, double reach) const {
  const int bins = level.bins[static_cast<std::size_t>(axis)];
  if (bins == 1) return {0, 1};
  const double first = std::floor((middle - reach) / level.bin_size[axis]), last = std::floor((middle + reach) / level.bin_size[axis]);
  if (cell_.periodic(axis)) {
    if (last - first + 1 > bins) return {0, bins};
    return {static_cast<int>(first), static_cast<int>(last - first) + 1};
  }
  const double outermost = bins - 1;
  const int from = static_cast<int>(std::clamp(first, 0.0, outermost)), to = static_cast<int>(std::clamp(last, 0.0, outermost));
  return {from, to - from + 1};
}

std::vector<std::uint32_t> CellGrid::order() const {
  std::vector<std::uint32_t> all;
  for (const Level& level : levels_) all.insert(all.end(), level.sphere.begin(), level.sphere.end());
  return all;
}

}  // namespace scalebreak

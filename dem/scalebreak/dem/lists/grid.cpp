#include <scalebreak/dem/lists/grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <scalebreak/dem/lists/images.hpp>

namespace scalebreak::dem {
namespace {

/// Bins along x and y that lie together in memory, so that of what is near along z little lies between.
constexpr int column_length = 16, column_rows = 8;
/// More bins than spheres only cost memory.
constexpr double most_bins_per_sphere = 4;

}  // namespace

std::size_t Grid::bin_number(const Level& level, int x, int y, int z) const {
  const auto size = [](int n) { return static_cast<std::size_t>(n); };
  const int first_row = y / column_rows * column_rows, rows = std::min(column_rows, level.bins[1] - first_row);
  const int first = x / column_length * column_length, length = std::min(column_length, level.bins[0] - first);
  const std::size_t column = (size(first_row) * size(level.bins[0]) + size(rows) * size(first)) * size(level.bins[2]);
  return column + (size(z) * size(rows) + size(y - first_row)) * size(length) + size(x - first);
}

std::array<int, 3> Grid::bin_of(const Level& level, const Quad& p) const {
  const auto along = [&](double x, int axis) {
    return std::clamp(static_cast<int>((x - level.low[axis]) / level.bin[axis]), 0, level.bins[static_cast<std::size_t>(axis)] - 1);
  };
  return {along(p.x, 0), along(p.y, 1), along(p.z, 2)};
}

Grid::Grid(const Cell& cell, const LargeList<Quad>& position, double skin)
    : cell_(cell), skin_(skin), offset_(central_offset(cell)), level_of_(position.size()) {
  double smallest = std::numeric_limits<double>::infinity();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(smallest), high = -low;
  for (const Quad& p : position) {
    smallest = std::min(smallest, p.w);
    low = low.cwiseMin(Eigen::Vector3d(p.x, p.y, p.z));
    high = high.cwiseMax(Eigen::Vector3d(p.x, p.y, p.z));
  }
  for (std::size_t i = 0; i < position.size(); ++i) {
    const auto level = static_cast<std::size_t>(std::max(0.0, std::floor(std::log2(position[i].w / smallest) + 1e-9)));
    level_of_[i] = static_cast<std::uint8_t>(level);
    if (levels_.size() <= level) levels_.resize(level + 1);
    levels_[level].largest = std::max(levels_[level].largest, position[i].w);
  }
  const double most = std::max(64.0, most_bins_per_sphere * static_cast<double>(position.size()));
  for (Level& level : levels_) {
    if (level.largest == 0) continue;
    double edge = 2 * level.largest + skin;
    Eigen::Vector3d size;
    for (int axis = 0; axis < 3; ++axis) {
      level.low[axis] = cell.periodic(axis) ? 0.0 : low[axis];
      size[axis] = cell.periodic(axis) ? cell.size[axis] : high[axis] - low[axis] + 1e-9 * edge;
    }
    for (;;) {
      double bins = 1;
      for (int axis = 0; axis < 3; ++axis) {
        level.bins[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp(std::floor(size[axis] / edge), 1.0, 2e4));
        bins *= level.bins[static_cast<std::size_t>(axis)];
      }
      if (bins <= most) break;
      edge *= 1.1;
    }
    for (int axis = 0; axis < 3; ++axis) level.bin[axis] = size[axis] / level.bins[static_cast<std::size_t>(axis)];
  }
  std::vector<std::uint32_t> bin(position.size());
  for (Level& level : levels_) {
    level.start.assign(
        static_cast<std::size_t>(level.bins[0]) * static_cast<std::size_t>(level.bins[1]) * static_cast<std::size_t>(level.bins[2]) + 1, 0);
  }
  for (std::size_t i = 0; i < position.size(); ++i) {
    Level& level = levels_[level_of_[i]];
    const auto at = bin_of(level, position[i]);
    bin[i] = static_cast<std::uint32_t>(bin_number(level, at[0], at[1], at[2]));
    ++level.start[bin[i] + 1];
  }
  for (Level& level : levels_) {
    std::partial_sum(level.start.begin(), level.start.end(), level.start.begin());
    level.sphere.resize(level.start.back());
  }
  std::vector<LargeList<std::uint32_t>> next(levels_.size());
  for (std::size_t l = 0; l < levels_.size(); ++l) next[l] = levels_[l].start;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const std::uint8_t l = level_of_[i];
    levels_[l].sphere[next[l][bin[i]]++] = static_cast<std::uint32_t>(i);
  }
}

std::vector<std::uint32_t> Grid::order() const {
  if (levels_.size() == 1) return {levels_[0].sphere.begin(), levels_[0].sphere.end()};
  // By the bins of the octave with the most spheres; the others come in where they lie.
  std::size_t most = 0;
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    if (levels_[l].sphere.size() > levels_[most].sphere.size()) most = l;
  }
  std::vector<std::uint32_t> order;
  for (std::size_t l = levels_.size(); l-- > 0;) {
    if (l != most) order.insert(order.end(), levels_[l].sphere.begin(), levels_[l].sphere.end());
  }
  order.insert(order.end(), levels_[most].sphere.begin(), levels_[most].sphere.end());
  return order;
}

void Grid::renumber() {
  const std::vector<std::uint32_t> order = this->order();
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  LargeList<std::uint8_t> level_of(level_of_.size());
  for (std::size_t k = 0; k < order.size(); ++k) level_of[k] = level_of_[order[k]];
  level_of_.swap(level_of);
  for (Level& level : levels_) {
    for (std::uint32_t& sphere : level.sphere) sphere = place[sphere];
  }
}

void Grid::search(const Level& level, bool own, std::uint32_t i, const LargeList<Quad>& position, const Quad* shift,
                  LargeList<std::uint32_t>& neighbours) const {
  const Quad here = position[i];
  const double touch = here.w + skin_, reach = touch + level.largest;
  // The bins from `from` to `to` along an axis, and how often the cell is passed on the way to each.
  const auto range = [&](double x, int axis, int& from, int& to) {
    from = static_cast<int>(std::floor((x - reach - level.low[axis]) / level.bin[axis]));
    to = static_cast<int>(std::floor((x + reach - level.low[axis]) / level.bin[axis]));
    const int bins = level.bins[static_cast<std::size_t>(axis)];
    if (!cell_.periodic(axis)) {
      from = std::clamp(from, 0, bins - 1), to = std::clamp(to, 0, bins - 1);
    } else {
      from = std::max(from, -bins), to = std::min(to, 2 * bins - 1);
    }
  };
  const auto image = [](int bin, int bins) { return bin < 0 ? -1 : bin >= bins ? 1 : 0; };
  int z0, z1, y0, y1, x0, x1;
  range(here.z, 2, z0, z1);
  range(here.y, 1, y0, y1);
  for (int z = z0; z <= z1; ++z) {
    const int kz = image(z, level.bins[2]);
    range(here.x - kz * offset_, 0, x0, x1);
    for (int y = y0; y <= y1; ++y) {
      const int ky = image(y, level.bins[1]);
      for (int x = x0; x <= x1;) {
        // Bins side by side along x, up to the cell's face.
        const int bins = level.bins[0], kx = image(x, bins), inside = x - kx * bins;
        const int end = std::min((inside / column_length + 1) * column_length, bins), last = std::min(x1, x + end - 1 - inside);
        const std::size_t from = bin_number(level, inside, y - ky * level.bins[1], z - kz * level.bins[2]);
        const std::size_t to = from + static_cast<std::size_t>(last - x);
        const auto number = static_cast<std::uint32_t>(kx + 1 + 3 * (ky + 1) + 9 * (kz + 1));
        const Quad away = shift[number];
        const double cx = here.x - away.x, cy = here.y - away.y, cz = here.z - away.z;
        for (std::uint32_t k = level.start[from]; k < level.start[to + 1]; ++k) {
          const std::uint32_t j = level.sphere[k];
          if (own && !precedes(i, j)) continue;
          const Quad& there = position[j];
          const double dx = there.x - cx, dy = there.y - cy, dz = there.z - cz, distance = touch + there.w;
          if (dx * dx + dy * dy + dz * dz < distance * distance) neighbours.push_back(packed(j, number));
        }
        x = last + 1;
      }
    }
  }
}

void Grid::neighbours_of(std::uint32_t i, const LargeList<Quad>& position, const Quad* shift, LargeList<std::uint32_t>& neighbours) const {
  const std::uint8_t own = level_of_[i];
  for (std::size_t l = 0; l <= own; ++l) {
    if (levels_[l].largest > 0) search(levels_[l], l == own, i, position, shift, neighbours);
  }
}

}  // namespace scalebreak::dem

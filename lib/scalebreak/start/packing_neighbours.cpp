#include <scalebreak/start/packing.hpp>

#include <algorithm>
#include <cmath>

#include <scalebreak/cell/cell_grid.hpp>

namespace scalebreak {
namespace {

/// Images two lengths aside occur along x alone, where the cell is sheared.
constexpr int across_x = 5, across = 3;
static_assert(across_x * across * across <= 64, "an image is named by six bits");

std::uint32_t image_of(const Cell& cell, const Eigen::Vector3d& shift) {
  const auto crossings = [&](int axis, double length) {
    return cell.periodic(axis) ? static_cast<int>(std::nearbyint(length / cell.size[axis])) : 0;
  };
  const int z = crossings(2, shift.z()), y = crossings(1, shift.y()), x = crossings(0, shift.x() - z * cell.shear_offset);
  return static_cast<std::uint32_t>(((z + 1) * across + y + 1) * across_x + x + 2);
}

std::vector<Eigen::Vector3d> shifts_of(const Cell& cell) {
  std::vector<Eigen::Vector3d> shifts;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -2; x <= 2; ++x) shifts.emplace_back(x * cell.size.x() + z * cell.shear_offset, y * cell.size.y(), z * cell.size.z());
    }
  }
  return shifts;
}

}  // namespace

PackingNeighbours::PackingNeighbours(Packing& packing, double scale, double skin)
    : shift_(shifts_of(packing.cell)), farthest_squared_(skin * skin / 4) {
  const std::size_t count = packing.position.size();
  for (Eigen::Vector3d& position : packing.position) {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    wrap(packing.cell, position, velocity);
  }
  std::vector<double> radius = packing.radius;
  for (double& r : radius) r *= scale;
  const double reach = 2 * *std::max_element(radius.begin(), radius.end()) + skin;
  for (int axis = 0; axis < 3; ++axis) narrow_ = narrow_ || (packing.cell.periodic(axis) && packing.cell.size[axis] < 2 * (reach + skin));
  struct Pair {
    std::uint32_t first, second, image;
  };
  std::vector<Pair> pairs;
  pairs.reserve(8 * count);
  start_.assign(count + 1, 0);
  const CellGrid grid(packing.cell, packing.position, radius, skin);
  grid.for_each_pair([&](std::uint32_t i, std::uint32_t j, const Eigen::Vector3d& difference) {
    pairs.push_back({i, j, image_of(packing.cell, packing.position[j] - packing.position[i] - difference)});
    ++start_[i + 1];
    ++start_[j + 1];
  });
  for (std::size_t i = 0; i < count; ++i) start_[i + 1] += start_[i];
  neighbour_.resize(start_[count]);
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  constexpr std::uint32_t last_sphere = most_spheres - 1, images = across_x * across * across;
  for (const Pair& pair : pairs) {
    neighbour_[next[pair.first]++] = {pair.second & last_sphere, pair.image & 63};
    neighbour_[next[pair.second]++] = {pair.first & last_sphere, (images - 1 - pair.image) & 63};  // the opposite image
  }
  made_at_ = packing.position;
}

}  // namespace scalebreak

#include <scalebreak/start/packing.hpp>

namespace scalebreak {
namespace {

bool clear_of_faces(const Packing& packing, const Eigen::Vector3d& position, double reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!packing.cell.periodic(axis) && !(position[axis] >= reach && packing.cell.size[axis] - position[axis] >= reach)) return false;
  }
  return true;
}

bool clear_of_spheres(const Packing& packing, const PackingNeighbours& list, std::size_t i, const Eigen::Vector3d& position, double scale) {
  for (const auto neighbour : list.of(i)) {
    const double distance = scale * (packing.radius[i] + packing.radius[neighbour.sphere]);
    if (list.away(packing, position, neighbour).squaredNorm() < distance * distance) return false;
  }
  return true;
}

}  // namespace

void shake(Packing& packing, double scale, double step, int sweeps, std::mt19937_64& random) {
  const double skin = 6 * step;
  PackingNeighbours list(packing, scale, skin);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < packing.position.size(); ++i) {
      Eigen::Vector3d trial = packing.position[i];
      for (int axis = 0; axis < 3; ++axis) trial[axis] += step * (2 * even_random(random) - 1);
      if (!clear_of_faces(packing, trial, scale * packing.radius[i]) || !clear_of_spheres(packing, list, i, trial, scale)) continue;
      packing.position[i] = trial;
      if (list.outrun(packing, i)) list = PackingNeighbours(packing, scale, skin);
    }
  }
}

}  // namespace scalebreak

#include <scalebreak/start/check_overlap.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/cell/cell_grid.hpp>
#include <scalebreak/scene/check_bodies.hpp>

namespace scalebreak {
namespace {

/// The overlap that is most for its radius.
struct Worst {
  double excess = touching_overlap;  ///< overlap over the smaller radius
  std::size_t first = 0, second = 0;
  double distance = 0;
};

void check_walls(const System& system, const std::string& where) {
  for (std::size_t i = 0; i < system.count(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!system.cell.walled(axis)) continue;
      for (const double distance : {system.position[i][axis], system.cell.size[axis] - system.position[i][axis]}) {
        if (!(system.radius[i] - distance > touching_overlap * system.radius[i])) continue;
        throw InputError(fmt::format(
            "{}sphere {} and a wall across {} overlap by {:g} m at the start (distance {:g} m, radius {:g} m); allowed: at most "
            "{:g} of the radius",
            where, i + 1, "xyz"[axis], system.radius[i] - distance, distance, system.radius[i], touching_overlap));
      }
    }
  }
}

}  // namespace

void check_no_overlap(const System& system, const std::string& where) {
  Worst worst;
  const CellGrid grid(system.cell, system.position, system.radius, 0);
  grid.for_each_pair([&](std::uint32_t i, std::uint32_t j, const Eigen::Vector3d& difference) {
    const double distance = difference.norm(), overlap = system.radius[i] + system.radius[j] - distance;
    const double excess = overlap / std::min(system.radius[i], system.radius[j]);
    const auto [first, second] = std::minmax(i, j);
    if (excess > worst.excess) worst = {excess, first, second, distance};
  });
  if (worst.first != worst.second) {
    const double first = system.radius[worst.first], second = system.radius[worst.second];
    throw InputError(fmt::format(
        "{}spheres {} and {} overlap by {:g} m at the start (distance {:g} m, radii {:g} m and {:g} m); allowed: at most {:g} of "
        "the radius",
        where, worst.first + 1, worst.second + 1, first + second - worst.distance, worst.distance, first, second, touching_overlap));
  }
  check_walls(system, where);
}

double least_gap_ratio(const System& system, double below) {
  double least = below;
  std::vector<double> radius = system.radius;
  for (double& r : radius) r *= 1 + below;
  const CellGrid grid(system.cell, system.position, radius, 0);
  grid.for_each_pair([&](std::uint32_t i, std::uint32_t j, const Eigen::Vector3d& difference) {
    least = std::min(least, difference.norm() / (system.radius[i] + system.radius[j]) - 1);
  });
  for (std::size_t i = 0; i < system.count(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (system.cell.periodic(axis)) continue;
      const double nearest = std::min(system.position[i][axis], system.cell.size[axis] - system.position[i][axis]);
      least = std::min(least, nearest / system.radius[i] - 1);
    }
  }
  return least;
}

}  // namespace scalebreak

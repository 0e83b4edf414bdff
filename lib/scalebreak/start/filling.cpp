#include <scalebreak/start/filling.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/base/random.hpp>
#include <scalebreak/cell/cell_grid.hpp>
#include <scalebreak/start/check_overlap.hpp>
#include <scalebreak/start/packing.hpp>
#include <scalebreak/start/velocities.hpp>

namespace scalebreak {
namespace {

enum Purpose : std::uint64_t { centres = 1, shaking = 2, velocities = 3 };

/// Volume fraction to which spheres of one size are blown up while they are moved apart: below that of random close packing, 0.64.
constexpr double soft_volume_fraction = 0.615;
constexpr double most_softness = 0.1, least_softness = 1e-4;  // soft radius over the radius, less 1
constexpr int attempts = 4, steps_each = 3000, sweeps = 40;
constexpr double above_rounding = 1 + 1e-9;

void refuse_what_does_not_fit(const Filling& filling) {
  const double largest = *std::max_element(filling.radius.begin(), filling.radius.end()) * (1 + filling.gap) * above_rounding;
  for (int axis = 0; axis < 3; ++axis) {
    if (filling.cell.size[axis] > 2 * largest) continue;
    throw InputError(fmt::format("cell.size: found {:g} m along {}; allowed: above {:g} m, the largest sphere's diameter with its gap",
                                 filling.cell.size[axis], "xyz"[axis], 2 * largest));
  }
}

/// Centres anywhere; spheres that are near in space are near in the list. `sphere` says which is which.
Packing random_centres(const Filling& filling, std::vector<std::uint32_t>& sphere) {
  std::mt19937_64 random = random_stream(filling.seed, centres, filling.replica);
  std::vector<Eigen::Vector3d> position(filling.radius.size());
  for (std::size_t i = 0; i < position.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double inset = filling.cell.periodic(axis) ? 0 : filling.radius[i];
      position[i][axis] = inset + (filling.cell.size[axis] - 2 * inset) * even_random(random);
    }
  }
  sphere = CellGrid(filling.cell, position, filling.radius, 0).order();
  Packing packing{filling.cell, {}, {}};
  for (const std::uint32_t i : sphere) {
    packing.position.push_back(position[i]);
    packing.radius.push_back(filling.radius[i]);
  }
  return packing;
}

/// Moves the spheres apart, with less and less of a margin where that fails.
void separate(Packing& packing, double wanted) {
  const double fraction = volume_fraction(packing.cell, packing.radius);
  double softness = std::clamp(std::cbrt(soft_volume_fraction / fraction) / wanted - 1, least_softness, most_softness);
  double reached = 0;
  for (int attempt = 0; attempt < attempts; ++attempt, softness /= 4) {
    reached = std::max(reached, relax(packing, wanted * (1 + softness), wanted, steps_each).scale);
    if (reached >= wanted) return;
  }
  throw WorkError(fmt::format(
      "the cell cannot be filled at random to a volume fraction of {:.4g}: without overlap it reached {:.4g}; a larger cell, or fewer or smaller spheres may help",
      fraction, fraction * std::pow(reached / wanted, 3)));
}

/// Half the width of a trial move: about the free way between spheres at that volume fraction.
double shaking_step(const Packing& packing, double wanted) {
  const double smallest = *std::min_element(packing.radius.begin(), packing.radius.end());
  const double fraction = volume_fraction(packing.cell, packing.radius) * wanted * wanted * wanted;
  return 2 * smallest * std::clamp(std::cbrt(0.64 / fraction) - 1, 0.02, 0.2);
}

}  // namespace

double volume_fraction(const Cell& cell, const std::vector<double>& radius) {
  double solid = 0;
  for (const double r : radius) solid += 4 * std::numbers::pi / 3 * r * r * r;
  return solid / cell.volume();
}

System fill(const Filling& filling) {
  const std::size_t count = filling.radius.size();
  if (count == 0 || filling.material.size() != count || filling.mass.size() != count)
    throw WorkError(fmt::format("a filling has {} radii, {} materials and {} masses", count, filling.material.size(), filling.mass.size()));
  if (count > PackingNeighbours::most_spheres)
    throw WorkError(fmt::format("a filling has at most {} spheres, found {}", PackingNeighbours::most_spheres, count));
  refuse_what_does_not_fit(filling);

  const double wanted = (1 + filling.gap) * above_rounding;
  std::vector<std::uint32_t> sphere;
  Packing packing = random_centres(filling, sphere);
  separate(packing, wanted);
  std::mt19937_64 shakes = random_stream(filling.seed, shaking, filling.replica);
  shake(packing, wanted, shaking_step(packing, wanted), sweeps, shakes);

  System system{.cell = filling.cell, .radius = filling.radius, .mass = filling.mass, .material = filling.material};
  system.position.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    Eigen::Vector3d none = Eigen::Vector3d::Zero();
    system.position[sphere[k]] = packing.position[k];
    wrap(system.cell, system.position[sphere[k]], none);
  }
  if (const double gap = least_gap_ratio(system, filling.gap + 1e-3); gap < filling.gap)
    throw WorkError(fmt::format("the filling left a gap of {:g} of the radii, below the {:g} that was asked for", gap, filling.gap));
  system.spin.assign(count, Eigen::Vector3d::Zero());
  std::mt19937_64 speeds = random_stream(filling.seed, velocities, filling.replica);
  set_velocities(system, filling.speed, speeds);
  return system;
}

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// Bins in which near pairs of spheres are found, in any cell: periodic or not, sheared, of fewer than three bins along an axis,
/// and with centres outside it. Spheres of like size (within a factor of two) share bins of their size; a small sphere looks for
/// large ones among the large, so that a size ratio of ten costs no more than many small spheres.
class CellGrid {
 public:
  /// Of centres and radii [m], for pairs whose surfaces are closer than `reach` [m], which is at least 0. With radii of 0, reach is
  /// the distance of centres.
  CellGrid(const Cell& cell, std::span<const Eigen::Vector3d> position, std::span<const double> radius, double reach);

  /// Calls visit(i, j, difference) once for each pair, in either order, whose distance is below radius[i] + radius[j] + reach;
  /// difference [m] leads from i to the `nearest_image` of j. In a cell that is shorter than twice that distance along a periodic
  /// axis, further images of the same pair may be as near; they are not visited.
  template <class Visit>
  void for_each_pair(Visit&& visit) const;

  /// Spheres, so that neighbours in space are near in the order.
  [[nodiscard]] std::vector<std::uint32_t> order() const;

 private:
  /// Spheres of like size, sorted by bin: those of bin b are the slots from start[b] to start[b + 1].
  struct Level {
    double largest = 0;  ///< radius
    std::array<int, 3> bins = {1, 1, 1};
    Eigen::Vector3d bin_size;
    std::vector<std::uint32_t> start, sphere;
    std::vector<Eigen::Vector3d> position;  ///< wrapped
    std::vector<double> radius;
  };

  /// Bins of an axis, a number of them one after the other, beginning below 0 where they lie beyond a periodic face.
  struct Range {
    int first = 0, count = 1;
  };

  void sort_into_bins(Level& level, std::span<const Eigen::Vector3d> position, std::span<const double> radius) const;
  [[nodiscard]] int bin(const Level& level, const Eigen::Vector3d& wrapped) const;
  [[nodiscard]] Range range(const Level& level, int axis, double middle, double reach) const;

  template <class Visit>
  void visit_row(const Level& level, const Eigen::Vector3d& middle, double reach, int y, int z, int crossings, bool whole_rows,
                 Visit&& visit_bin) const;
  template <class Visit>
  void visit_bins(const Level& level, const Eigen::Vector3d& middle, double reach, Visit&& visit_bin) const;

  Cell cell_;
  double reach_;
  std::vector<Level> levels_;  ///< from small to large
};

template <class Visit>
void CellGrid::visit_row(const Level& level, const Eigen::Vector3d& middle, double reach, int y, int z, int crossings, bool whole_rows,
                         Visit&& visit_bin) const {
  const Range x = whole_rows ? Range{0, level.bins[0]} : range(level, 0, middle.x() - crossings * cell_.shear_offset, reach);
  for (int i = 0; i < x.count; ++i) {
    const int wrapped = ((x.first + i) % level.bins[0] + level.bins[0]) % level.bins[0];
    visit_bin(static_cast<std::size_t>((z * level.bins[1] + y) * level.bins[0] + wrapped));
  }
}

template <class Visit>
void CellGrid::visit_bins(const Level& level, const Eigen::Vector3d& middle, double reach, Visit&& visit_bin) const {
  const Range ys = range(level, 1, middle.y(), reach), zs = range(level, 2, middle.z(), reach);
  // A bin that several images of reach into is visited once, whatever its displacement.
  const bool whole_rows = cell_.shear_offset != 0 && cell_.periodic(2) && zs.count == level.bins[2];
  for (int k = 0; k < zs.count; ++k) {
    const int rows = level.bins[2], above = zs.first + k, z = (above % rows + rows) % rows;
    for (int j = 0; j < ys.count; ++j) {
      const int y = ((ys.first + j) % level.bins[1] + level.bins[1]) % level.bins[1];
      visit_row(level, middle, reach, y, z, (above - z) / rows, whole_rows, visit_bin);
    }
  }
}

template <class Visit>
void CellGrid::for_each_pair(Visit&& visit) const {
  for (auto level = levels_.begin(); level != levels_.end(); ++level) {
    for (std::uint32_t a = 0; a < level->sphere.size(); ++a) {
      const Eigen::Vector3d& middle = level->position[a];
      for (auto other = level; other != levels_.end(); ++other) {
        visit_bins(*other, middle, level->radius[a] + other->largest + reach_, [&](std::size_t bin) {
          const std::uint32_t first = other == level ? std::max(other->start[bin], a + 1) : other->start[bin];
          for (std::uint32_t b = first; b < other->start[bin + 1]; ++b) {
            const Eigen::Vector3d difference = nearest_image(cell_, other->position[b] - middle);
            const double distance = level->radius[a] + other->radius[b] + reach_;
            if (difference.squaredNorm() < distance * distance) visit(level->sphere[a], other->sphere[b], difference);
          }
        });
      }
    }
  }
}

}  // namespace scalebreak

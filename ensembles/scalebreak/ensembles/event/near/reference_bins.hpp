#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// The reference points of spheres, sorted into bins of the cell as it is at time 0. The points move with a flow of constant rate along
/// x that grows with z, and are given by where they were at time 0; `strain` is how far that flow has come.
class ReferenceBins {
 public:
  ReferenceBins() = default;
  /// Bins of about `edge` [m].
  ReferenceBins(const Cell& cell, double edge, std::size_t spheres);

  void insert(std::uint32_t sphere, const Eigen::Vector3d& reference) { link(sphere, bin_of(reference)); }
  void move(std::uint32_t sphere, const Eigen::Vector3d& reference);

  /// Calls visit(sphere) for every sphere whose reference may be within `reach` of a point, and for some others; once each.
  template <class Visit>
  void for_each_near(const Eigen::Vector3d& point, double reach, double strain, Visit&& visit) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Place {
    std::uint32_t bin = none, next = none, previous = none;
  };
  struct Range {
    int first = 0, count = 1;
  };

  [[nodiscard]] std::uint32_t bin_of(const Eigen::Vector3d& reference) const;
  [[nodiscard]] int inside(int axis, int bin) const;
  [[nodiscard]] Range range(int axis, double low, double high) const;
  void link(std::uint32_t sphere, std::uint32_t bin);

  Cell cell_;
  std::array<int, 3> bins_ = {1, 1, 1};
  Eigen::Vector3d edge_{1, 1, 1};
  std::vector<std::uint32_t> first_;
  std::vector<Place> place_;
};

inline int ReferenceBins::inside(int axis, int bin) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  if (bin >= 0 && bin < bins) return bin;
  if (!cell_.periodic(axis)) return bin < 0 ? 0 : bins - 1;
  return (bin % bins + bins) % bins;
}

inline ReferenceBins::Range ReferenceBins::range(int axis, double low, double high) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  int from = static_cast<int>(std::floor(low / edge_[axis])), to = static_cast<int>(std::floor(high / edge_[axis]));
  if (!cell_.periodic(axis)) {
    from = inside(axis, from), to = inside(axis, to);
  } else if (to - from >= bins) {
    to = from + bins - 1;
  }
  return {from, to - from + 1};
}

template <class Visit>
void ReferenceBins::for_each_near(const Eigen::Vector3d& point, double reach, double strain, Visit&& visit) const {
  const Range ys = range(1, point.y() - reach, point.y() + reach), zs = range(2, point.z() - reach, point.z() + reach);
  // Rows that several images of the reach go into are looked at as a whole.
  const bool whole_rows = cell_.periodic(2) && cell_.shear_rate != 0 && zs.count == bins_[2];
  for (int row = zs.first; row < zs.first + zs.count; ++row) {
    const int z = inside(2, row), crossings = (row - z) / bins_[2];
    Range xs{0, bins_[0]};
    if (!whole_rows) {
      // How much higher the references of this row can be: by so much more the flow has carried them on.
      const bool lowest = !cell_.periodic(2) && row == 0, highest = !cell_.periodic(2) && row == bins_[2] - 1;
      const double low = lowest ? -reach : std::max(-reach, row * edge_.z() - point.z());
      const double high = highest ? reach : std::min(reach, (row + 1) * edge_.z() - point.z());
      const double middle = point.x() - crossings * cell_.shear_offset;
      xs = range(0, middle - reach - std::max(strain * low, strain * high), middle + reach - std::min(strain * low, strain * high));
    }
    for (int j = ys.first; j < ys.first + ys.count; ++j) {
      const int line = (z * bins_[1] + inside(1, j)) * bins_[0];
      for (int i = xs.first; i < xs.first + xs.count; ++i) {
        const std::uint32_t bin = static_cast<std::uint32_t>(line + inside(0, i));
        for (std::uint32_t sphere = first_[bin]; sphere != none; sphere = place_[sphere].next) visit(sphere);
      }
    }
  }
}

}  // namespace scalebreak

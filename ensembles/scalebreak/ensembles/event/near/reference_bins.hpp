#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// The reference points of spheres, sorted into bins of the cell as it is at time 0. The points move with a flow of constant rate along
/// x that grows with z, and are given by where they were at time 0; `strain` is how far that flow has come.
class ReferenceBins {
 public:
  ReferenceBins() = default;
  /// For so many spheres, about two in a bin.
  ReferenceBins(const Cell& cell, std::size_t spheres);

  void insert(std::uint32_t sphere, const Eigen::Vector3d& reference);
  void move(std::uint32_t sphere, const Eigen::Vector3d& reference);

  /// What has been put into them, of bins that were made alike.
  void save(std::string& bytes) const;
  void load(std::string_view& bytes);

  /// Calls visit(sphere) for every sphere whose reference is within `reach` of a point, and for some others; once each.
  template <class Visit>
  void for_each_near(const Eigen::Vector3d& point, double reach, double strain, Visit&& visit) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr int lanes = 8, entries = lanes - 1;
  static constexpr float nowhere = 1e18f;

  /// Two cache lines: points in single precision, brought back into the cell, which is enough to tell the far from the near.
  struct alignas(64) Bin {
    std::array<float, lanes> x, y, z;
    std::array<std::uint32_t, entries> sphere;
    std::uint32_t more;  ///< a bin with those that had no room
  };
  struct Range {
    int first = 0, count = 1;
    bool all = false;  ///< of a periodic axis, so that images of one bin cannot be told from each other
  };

  [[nodiscard]] std::array<float, 3> point_in_cell(const Eigen::Vector3d& reference) const;
  [[nodiscard]] std::uint32_t bin_of(const std::array<float, 3>& point) const;
  [[nodiscard]] int inside(int axis, int bin) const;
  [[nodiscard]] Range range(int axis, double low, double high) const;
  void put(std::uint32_t bin, std::uint32_t sphere, const std::array<float, 3>& point);
  void take(std::uint32_t bin, std::uint32_t sphere);
  template <class Visit>
  void visit_bin(std::uint32_t bin, const std::array<float, 3>& middle, float strain, float square, Visit&& visit) const;

  Cell cell_;
  std::array<int, 3> bins_ = {1, 1, 1};
  Eigen::Vector3d edge_{1, 1, 1};
  std::vector<Bin> bin_;
  std::vector<std::uint32_t> bin_of_sphere_;
};

inline int ReferenceBins::inside(int axis, int bin) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  if (bin >= 0 && bin < bins) return bin;
  if (!cell_.periodic(axis)) return bin < 0 ? 0 : bins - 1;
  return (bin % bins + bins) % bins;
}

inline ReferenceBins::Range ReferenceBins::range(int axis, double low, double high) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  const auto below = [](double x) { return static_cast<int>(x) - (x < static_cast<int>(x) ? 1 : 0); };
  int from = below(low / edge_[axis]), to = below(high / edge_[axis]);
  if (!cell_.periodic(axis)) {
    from = inside(axis, from), to = inside(axis, to);
  } else if (to - from + 1 >= bins) {
    return {from, bins, true};
  }
  return {from, to - from + 1, false};
}

template <class Visit>
void ReferenceBins::visit_bin(std::uint32_t bin, const std::array<float, 3>& middle, float strain, float square, Visit&& visit) const {
  while (bin != none) {
    const Bin& b = bin_[bin];
    std::array<float, lanes> distance;
    for (std::size_t k = 0; k < lanes; ++k) {
      const float z = b.z[k] - middle[2], y = b.y[k] - middle[1], x = b.x[k] - middle[0] + strain * z;
      distance[k] = x * x + y * y + z * z;
    }
    for (std::size_t k = 0; k < entries; ++k) {
      if (distance[k] < square) visit(b.sphere[k]);
    }
    bin = b.more;
  }
}

template <class Visit>
void ReferenceBins::for_each_near(const Eigen::Vector3d& point, double reach, double strain, Visit&& visit) const {
  const double single_precision = 1e-6 * cell_.size.maxCoeff();  // points have been rounded to it
  reach += single_precision;
  const Range ys = range(1, point.y() - reach, point.y() + reach), zs = range(2, point.z() - reach, point.z() + reach);
  // Where an axis is looked at as a whole, images are left to the visitor.
  const bool whole_rows = zs.all && cell_.shear_rate != 0;
  const float least_square = static_cast<float>(reach * reach);
  for (int row = zs.first; row < zs.first + zs.count; ++row) {
    const int z = inside(2, row), crossings = (row - z) / bins_[2];
    const double middle = point.x() - crossings * cell_.shear_offset;
    Range xs{0, bins_[0], true};
    if (!whole_rows) {
      // How much higher the references of this row can be: by so much more the flow has carried them on.
      const bool lowest = !cell_.periodic(2) && row == 0, highest = !cell_.periodic(2) && row == bins_[2] - 1;
      const double low = lowest ? -reach : std::max(-reach, row * edge_.z() - point.z());
      const double high = highest ? reach : std::min(reach, (row + 1) * edge_.z() - point.z());
      xs = range(0, middle - reach - std::max(strain * low, strain * high), middle + reach - std::min(strain * low, strain * high));
    }
    const float square = xs.all || ys.all || zs.all ? nowhere : least_square;
    const float at_z = static_cast<float>(point.z() - crossings * cell_.size.z());
    for (int j = ys.first; j < ys.first + ys.count; ++j) {
      const int y = inside(1, j), line = (z * bins_[1] + y) * bins_[0];
      const float at_y = static_cast<float>(point.y() - (j - y) / bins_[1] * cell_.size.y());
      for (int i = xs.first; i < xs.first + xs.count; ++i) {
        const int x = inside(0, i);
        const float at_x = static_cast<float>(middle - (i - x) / bins_[0] * cell_.size.x());
        visit_bin(static_cast<std::uint32_t>(line + x), {at_x, at_y, at_z}, static_cast<float>(strain), square, visit);
      }
    }
  }
}

}  // namespace scalebreak

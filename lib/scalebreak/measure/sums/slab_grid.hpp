#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// The gap cut into slabs of equal height, counted from below.
class SlabGrid {
 public:
  SlabGrid(const Cell& cell, int slabs) : slabs_(slabs), height_(cell.size.z() / slabs), periodic_(cell.periodic(2)) {}

  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] Eigen::Index slabs() const { return slabs_; }

  /// Which slab holds a height [m]; nothing beyond faces that are not periodic.
  [[nodiscard]] std::optional<Eigen::Index> slab_at(double z) const {
    const double top = height_ * static_cast<double>(slabs_);
    if (!periodic_ && (z < 0 || z > top)) return std::nullopt;
    if (!periodic_ && z >= top) return slabs_ - 1;
    return folded(static_cast<Eigen::Index>(std::floor(z / height_)));
  }

  /// Calls f(slab, lower, upper) with each part [lower, upper] of a stretch of z that one slab holds, in metres. What lies beyond faces
  /// that are not periodic is left out.
  template <class F>
  void cut(double from, double to, F f) const {
    for (auto i = static_cast<Eigen::Index>(std::floor(from / height_)); static_cast<double>(i) * height_ < to; ++i) {
      if (!periodic_ && (i < 0 || i >= slabs_)) continue;
      const double below = static_cast<double>(i) * height_;
      f(folded(i), std::max(from, below), std::min(to, below + height_));
    }
  }

 private:
  [[nodiscard]] Eigen::Index folded(Eigen::Index slab) const { return ((slab % slabs_) + slabs_) % slabs_; }

  Eigen::Index slabs_;
  double height_;
  bool periodic_;
};

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <scalebreak/table/collision_table.hpp>

namespace scalebreak {

/// Where the impacts of a pair of materials lie on the unit square: x is ξ, the coordinate of v̂² − v̂_s² of CollisionTable, from the
/// table's first to its last, and y = ψ/(ψ + ψ₀) of the ratio ψ ≥ 0 of another speed to the normal one.
struct ImpactPlane {
  bool adhesive = false;
  double sticking_squared = 0;  ///< v̂_s²
  double half_way = 1;          ///< ψ₀

  /// x at v̂; nothing where CollisionTable has nothing, or the pair sticks. Without adhesion nothing depends on it.
  [[nodiscard]] std::optional<double> column(double speed) const {
    if (!adhesive) return 0.5;
    const double excess = speed * speed - sticking_squared;
    if (!(excess >= TableBounds::margin(sticking_squared) && excess <= TableBounds::excess_max)) return std::nullopt;
    return (CollisionTable::speed_coordinate(excess) - first()) / (last() - first());
  }
  [[nodiscard]] double row(double ratio) const { return ratio / (ratio + half_way); }

  /// v̂ at x, and at least where v̂² − v̂_s² is `least` (1 + v̂_s²); 1 without adhesion.
  [[nodiscard]] double speed_at(double x, double least) const {
    if (!adhesive) return 1.0;
    const double excess = CollisionTable::excess_squared_at(first() + x * (last() - first()));
    return std::sqrt(std::max(excess, least * (1 + sticking_squared)) + sticking_squared);
  }
  /// ψ at y, kept between `least` and `most` of ψ₀.
  [[nodiscard]] double ratio_at(double y, double least, double most) const {
    return half_way * std::clamp(y < 1 ? y / (1 - y) : most, least, most);
  }

 private:
  [[nodiscard]] static double first() { return CollisionTable::speed_coordinate(TableBounds::excess_min); }
  [[nodiscard]] static double last() { return CollisionTable::speed_coordinate(TableBounds::excess_max); }
};

}  // namespace scalebreak

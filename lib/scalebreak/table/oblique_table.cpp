#include <scalebreak/table/oblique_table.hpp>

namespace scalebreak {

std::optional<ObliqueTable::Place> ObliqueTable::place(double speed, double ratio) const {
  const double y = ratio / (ratio + half_way_);
  if (!key_.kind.adhesive()) return Place{0.5, y};
  const double excess = speed * speed - sticking_squared_;
  if (excess < TableBounds::margin(sticking_squared_) || excess > TableBounds::excess_max) return std::nullopt;
  const double x = (CollisionTable::speed_coordinate(excess) - first_coordinate()) / (last_coordinate() - first_coordinate());
  return Place{x, y};
}

std::optional<ObliqueEntry> ObliqueTable::find(double speed, double ratio) const {
  const auto at = place(speed, ratio);
  if (!at) return std::nullopt;
  const auto entry = entries_.at(at->x, at->y);
  return ObliqueEntry{entry[0], entry[1]};
}

std::optional<TurningEntry> ObliqueTable::turning(double speed, double ratio) const {
  const auto at = place(speed, ratio);
  if (!at || (key_.kind.adhesive() && speed * speed - sticking_squared_ < turning_excess * (1 + sticking_squared_))) return std::nullopt;
  // Kept over 1 + ψ²-like sizes, so that all entries are of order one.
  const auto entry = turnings_.at(at->x, at->y);
  const double one = 1 + ratio;
  const Eigen::Array3d size(one * one, one, 1);
  return TurningEntry{entry.segment<3>(0) * size, entry.segment<3>(3) * size, entry.segment<3>(6) * size};
}

}  // namespace scalebreak

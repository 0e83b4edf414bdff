#include <scalebreak/table/oblique_table.hpp>

namespace scalebreak {

std::optional<ObliqueEntry> ObliqueTable::find(double speed, double ratio) const {
  const auto x = plane_.column(speed);
  if (!x) return std::nullopt;
  const auto entry = entries_.at(*x, plane_.row(ratio));
  return ObliqueEntry{entry[0], entry[1]};
}

std::optional<TurningEntry> ObliqueTable::turning(double speed, double ratio) const {
  const auto x = plane_.column(speed);
  if (!x || (plane_.adhesive && speed * speed - plane_.sticking_squared < turning_excess * (1 + plane_.sticking_squared)))
    return std::nullopt;
  // Kept over 1 + ψ²-like sizes, so that all entries are of order one.
  const auto entry = turnings_.at(*x, plane_.row(ratio));
  const double one = 1 + ratio;
  const Eigen::Array3d size(one * one, one, 1);
  return TurningEntry{entry.segment<3>(0) * size, entry.segment<3>(3) * size, entry.segment<3>(6) * size};
}

}  // namespace scalebreak

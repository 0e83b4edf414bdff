#pragma once

#include <optional>
#include <vector>

namespace scalebreak {

/// A quantity over time, times ascending; straight between its points, and beyond them as at the nearest.
struct PaperCurve {
  std::vector<double> time, value;

  void add(double t, double y) {
    time.push_back(t);
    value.push_back(y);
  }
  [[nodiscard]] double at(double t) const;
};

/// Largest distance of two curves from time 0 to `end`, over the range of the first; none if that is zero.
[[nodiscard]] std::optional<double> curve_distance(const PaperCurve& original, const PaperCurve& other, double end, int points = 2000);

}  // namespace scalebreak

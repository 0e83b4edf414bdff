#pragma once

#include <string>
#include <string_view>

namespace scalebreak {

/// Bounds of a number: finite, and open or closed at the lower end.
struct Bounds {
  double low, high;
  bool low_allowed = true;

  [[nodiscard]] bool contain(double value) const { return (low_allowed ? value >= low : value > low) && value <= high; }
  [[nodiscard]] std::string text() const;
};

/// The documented bounds of a numeric key (of each element of an array); throws WorkError for other keys.
[[nodiscard]] Bounds bounds_of(std::string_view dotted);

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace scalebreak {

/// An even grid of `count` nodes from `first`.
struct Axis {
  double first = 0;
  double step = 1;
  int count = 1;
  double per_step = 1 / step;

  bool operator==(const Axis&) const = default;
  [[nodiscard]] double at(double index) const { return first + step * index; }
  [[nodiscard]] double last() const { return at(count - 1); }

  /// `count` nodes that span [first, last].
  [[nodiscard]] static Axis span(double first, double last, int count) {
    return {first, count > 1 ? (last - first) / (count - 1) : 1.0, count};
  }
};

/// The six nodes about a point of an even grid, and their weights in the polynomial through them
/// (fifth degree; off centre at the grid's ends).
struct Stencil {
  static constexpr int width = 6;
  int begin = 0;
  std::array<double, width> weight{};

  Stencil(const Axis& axis, double value) {
    const double index = (value - axis.first) * axis.per_step;
    begin = std::clamp(static_cast<int>(index) - (width / 2 - 1), 0, std::max(axis.count - width, 0));
    const double u = index - begin;
    const double d0 = u, d1 = u - 1, d2 = u - 2, d3 = u - 3, d4 = u - 4, d5 = u - 5;
    const double d01 = d0 * d1, d45 = d4 * d5, d23 = d2 * d3;
    const double right = d23 * d45, left = d01 * d23, outer = d01 * d45;
    constexpr double c0 = 1.0 / 120, c1 = 1.0 / 24, c2 = 1.0 / 12;
    weight = {-c0 * d1 * right, c1 * d0 * right, -c2 * d3 * outer, c2 * d2 * outer, -c1 * d5 * left, c0 * d4 * left};
  }

  /// The polynomial's value, from the values at the grid's nodes.
  template <class Value>
  [[nodiscard]] Value of(const Value* values) const {
    const Value* node = values + begin;
    Value sum = weight[0] * node[0];
    for (std::size_t i = 1; i < width; ++i) sum += weight[i] * node[i];
    return sum;
  }
};

}  // namespace scalebreak

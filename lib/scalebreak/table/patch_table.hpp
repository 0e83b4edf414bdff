#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace scalebreak {

/// Functions of two variables on the unit square that are smooth but for kinks along lines: cells of a tree that halves them where
/// needed, each with a bicubic polynomial through 4 × 4 Chebyshev–Lobatto nodes. Cells that a kink crosses are small
/// enough for the tolerance; no polynomial is fitted across more than one of them.
///
/// Lanes is how many functions there are.
template <int Lanes>
class PatchTable {
 public:
  using Value = Eigen::Array<double, Lanes, 1>;
  static constexpr int side = 4, nodes_of_cell = side * side;

  /// A node of the tree: a cell that is halved across `axis` and whose halves are `next` and `next + 1`, or a leaf (axis −1) whose
  /// values are those of leaf `next`.
  struct Branch {
    std::int32_t next = 0;
    std::int32_t axis = -1;

    bool operator==(const Branch&) const = default;
  };

  PatchTable() = default;
  PatchTable(std::vector<Branch> tree, std::vector<Value> values) : tree_(std::move(tree)), values_(std::move(values)) {}

  /// The functions at (x, y) in the unit square.
  [[nodiscard]] Value at(double x, double y) const {
    double width_x = 1, width_y = 1;
    const Branch* branch = tree_.data();
    while (branch->axis >= 0) {
      double& place = branch->axis == 0 ? x : y;
      (branch->axis == 0 ? width_x : width_y) *= 0.5;
      place *= 2;
      const bool upper = place >= 1;
      place -= upper;
      branch = tree_.data() + branch->next + upper;
    }
    return polynomial(std::span<const Value, nodes_of_cell>(values_.data() + nodes_of_cell * branch->next, nodes_of_cell), x, y);
  }

  /// The bicubic through a cell's values, at (x, y) of the cell.
  [[nodiscard]] static Value polynomial(std::span<const Value, nodes_of_cell> values, double x, double y) {
    const auto wx = weights(x), wy = weights(y);
    Value sum = Value::Zero();
    for (std::size_t j = 0; j < side; ++j) {
      const Value* row = values.data() + side * j;
      sum += wy[j] * (wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3]);
    }
    return sum;
  }
  /// Where the nodes of a cell are along each of its sides.
  static constexpr std::array<double, side> node = {0.0, 0.25, 0.75, 1.0};

  [[nodiscard]] const std::vector<Branch>& tree() const { return tree_; }
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }
  [[nodiscard]] std::size_t cells() const { return values_.size() / nodes_of_cell; }
  [[nodiscard]] std::size_t bytes() const { return tree_.size() * sizeof(Branch) + values_.size() * sizeof(Value); }

 private:
  /// Lagrange's weights of the nodes 0, 1/4, 3/4, 1.
  [[nodiscard]] static std::array<double, side> weights(double t) {
    const double a = t, b = t - 0.25, c = t - 0.75, d = t - 1;
    return {-16.0 / 3 * b * c * d, 32.0 / 3 * a * c * d, -32.0 / 3 * a * b * d, 16.0 / 3 * a * b * c};
  }

  std::vector<Branch> tree_;
  std::vector<Value> values_;
};

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/parallel.hpp>
#include <scalebreak/table/patch_table.hpp>

namespace scalebreak {

/// How a table of patches is built.
struct PatchBuild {
  double tolerance = 1e-4;  ///< of each function, absolute
  int threads = 0;
  std::size_t most_cells = 60'000;
  bool one_dimensional = false;  ///< nothing depends on x
  double narrowest = 0;          ///< side below which a cell is not halved, for functions that jump
  std::function<void(double)> progress = {};
};

/// Builds a table of `function(x, y)`: cells are halved until the polynomial of each is within a third of the tolerance of the function
/// at nine points between its nodes. The result does not depend on the number of threads. Throws WorkError beyond `most_cells`.
template <int Lanes, class Function>
PatchTable<Lanes> build_patches(const Function& function, const PatchBuild& build) {
  using Table = PatchTable<Lanes>;
  using Value = typename Table::Value;
  struct Cell {
    std::int32_t branch;
    double x, y, width_x, width_y;
    std::array<Value, Table::nodes_of_cell> values;
    double error = 0;
    int worse_axis = 0;
  };
  const auto examine = [&](Cell& cell) {
    const auto at = [&](double u, double v) { return Value(function(cell.x + u * cell.width_x, cell.y + v * cell.width_y)); };
    for (std::size_t j = 0; j < Table::side; ++j) {
      for (std::size_t i = 0; i < Table::side; ++i) {
        Value& value = cell.values[Table::side * j + i];
        value = build.one_dimensional && i > 0 ? cell.values[Table::side * j] : at(Table::node[i], Table::node[j]);
      }
    }
    cell.error = 0;
    for (const double v : {0.1, 0.5, 0.9}) {
      for (const double u : {0.1, 0.5, 0.9}) {
        if (build.one_dimensional && u != 0.5) continue;
        cell.error = std::max(cell.error, (Table::polynomial(cell.values, u, v) - at(u, v)).abs().maxCoeff());
      }
    }
    // The highest coefficient along each side says which of them is the worse.
    double rough_x = 0, rough_y = 0;
    const auto third = [](const Value& a, const Value& b, const Value& c, const Value& d) {
      return (a - 2 * b + 2 * c - d).abs().maxCoeff();
    };
    for (std::size_t i = 0; i < Table::side; ++i) {
      const auto& f = cell.values;
      rough_x = std::max(rough_x, third(f[4 * i], f[4 * i + 1], f[4 * i + 2], f[4 * i + 3]));
      rough_y = std::max(rough_y, third(f[i], f[4 + i], f[8 + i], f[12 + i]));
    }
    cell.worse_axis = rough_x > rough_y ? 0 : 1;
  };
  std::vector<typename Table::Branch> tree(1);
  std::vector<Value> values;
  std::vector<Cell> front(1);
  front[0] = {.branch = 0, .x = 0, .y = 0, .width_x = 1, .width_y = 1, .values = {}};
  double done = 0;  // share of the square
  while (!front.empty()) {
    parallel_for(front.size(), build.threads, [&](std::size_t i) { examine(front[i]); });
    std::vector<Cell> next;
    for (const Cell& cell : front) {
      auto& branch = tree[static_cast<std::size_t>(cell.branch)];
      // A first few halvings come unasked: nine points do not see a thing that is narrow on the whole square.
      const bool coarse = cell.width_y > 0.1 || (!build.one_dimensional && cell.width_x > 0.3);
      const bool narrow = cell.width_y <= build.narrowest && (build.one_dimensional || cell.width_x <= build.narrowest);
      if (!coarse && (narrow || cell.error <= build.tolerance / 3)) {
        branch.next = static_cast<std::int32_t>(values.size() / Table::nodes_of_cell);
        values.insert(values.end(), cell.values.begin(), cell.values.end());
        done += cell.width_x * cell.width_y;
        continue;
      }
      if (values.size() / Table::nodes_of_cell + next.size() > build.most_cells) {
        throw WorkError(fmt::format("a table of tolerance {:g} would need more than {} cells; ask for a larger tolerance", build.tolerance,
                                    build.most_cells));
      }
      int axis = build.one_dimensional ? 1 : coarse ? (cell.width_y > 0.1 && cell.width_y >= cell.width_x / 3 ? 1 : 0) : cell.worse_axis;
      if ((axis == 0 ? cell.width_x : cell.width_y) <= build.narrowest) axis = 1 - axis;
      branch.axis = axis;
      branch.next = static_cast<std::int32_t>(tree.size());
      for (int half = 0; half < 2; ++half) {
        Cell part{.branch = static_cast<std::int32_t>(tree.size()),
                  .x = cell.x,
                  .y = cell.y,
                  .width_x = cell.width_x,
                  .width_y = cell.width_y,
                  .values = {}};
        (axis == 0 ? part.width_x : part.width_y) /= 2;
        if (half == 1) (axis == 0 ? part.x : part.y) += axis == 0 ? part.width_x : part.width_y;
        next.push_back(part);
        tree.emplace_back();
      }
    }
    front = std::move(next);
    if (build.progress) build.progress(std::min(1.0, done));
  }
  return {std::move(tree), std::move(values)};
}

}  // namespace scalebreak

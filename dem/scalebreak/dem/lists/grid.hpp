#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <scalebreak/base/large_list.hpp>
#include <scalebreak/cell/cell.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>

namespace scalebreak::dem {

/// The spheres of a cell in bins: one grid for each octave of sizes, so that small spheres beside large ones lie in small bins. Bins are
/// numbered in columns (sixteen along x fastest, then eight rows along y, then z), so that what is near in space is near in memory.
class Grid {
 public:
  /// Spheres that are wrapped; `skin` is the largest gap of surfaces at which a pair is a pair of neighbours [m].
  Grid(const Cell& cell, const LargeList<Quad>& position, double skin);

  /// An order in which neighbours in space are neighbours in the list.
  [[nodiscard]] std::vector<std::uint32_t> order() const;
  /// To be called once the spheres are in that order.
  void renumber();

  /// Is a pair of spheres kept by its first?
  [[nodiscard]] bool keeps(std::uint32_t first, std::uint32_t second) const {
    return level_of_[first] != level_of_[second] ? level_of_[first] > level_of_[second] : precedes(first, second);
  }
  /// The neighbours of sphere i that are its own to keep: of two spheres in one octave, those that it precedes; all of smaller octaves.
  /// Appends them packed with their image.
  void neighbours_of(std::uint32_t i, const LargeList<Quad>& position, const Quad* shift, LargeList<std::uint32_t>& neighbours) const;

 private:
  struct Level {
    double largest = 0;            ///< radius [m]
    Eigen::Vector3d low{0, 0, 0};  ///< corner of the bins: that of the cell, or of the spheres along an open axis
    Eigen::Vector3d bin{1, 1, 1};  ///< edge [m]
    std::array<int, 3> bins = {1, 1, 1};
    LargeList<std::uint32_t> start, sphere;  ///< of each bin, and the spheres bin by bin
  };
  /// Is the way from i to j along the list shorter than that from j to i, both going on from its end to its beginning? So pairs across a
  /// periodic face belong to the end of the list, and each of the threads that share it has as many pairs with the next one's spheres.
  [[nodiscard]] bool precedes(std::uint32_t i, std::uint32_t j) const {
    const auto count = static_cast<std::uint32_t>(level_of_.size()), way = j - i + (j < i ? count : 0), back = count - way;
    return way != 0 && (way < back || (way == back && i < j));
  }
  [[nodiscard]] std::size_t bin_number(const Level& level, int x, int y, int z) const;
  [[nodiscard]] std::array<int, 3> bin_of(const Level& level, const Quad& position) const;
  void search(const Level& level, bool own, std::uint32_t i, const LargeList<Quad>& position, const Quad* shift,
              LargeList<std::uint32_t>& neighbours) const;

  Cell cell_;
  double skin_, offset_;
  std::vector<Level> levels_;         ///< from the smallest
  LargeList<std::uint8_t> level_of_;  ///< of each sphere
};

}  // namespace scalebreak::dem

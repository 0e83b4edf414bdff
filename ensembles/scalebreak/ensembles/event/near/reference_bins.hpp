#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// The reference points of spheres, sorted into bins of the cell as it is at time 0. The points move with a flow of constant rate along
/// x that grows with z, and are given by where they were at time 0; `strain` is how far that flow has come.
class ReferenceBins {
 public:
  ReferenceBins() = default;
  /// For so many spheres.
  ReferenceBins(const Cell& cell, std::size_t spheres);

  void insert(std::uint32_t sphere, const Eigen::Vector3d& reference);
  void move(std::uint32_t sphere, const Eigen::Vector3d& reference);

  /// What has been put into them, of bins that were made alike.
  void save(std::string& bytes) const;
  void load(std::string_view& bytes);

  /// Every sphere whose reference is within `reach` of a point, and some others, once each: in `space`, which grows as needed.
  [[nodiscard]] std::span<const std::uint32_t> find_near(const Eigen::Vector3d& point, double reach, double strain,
                                                         std::vector<std::uint32_t>& space) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr int lanes = 4, entries = lanes - 1;
  static constexpr float nowhere = 1e18f;

  /// A cache line: points in single precision, brought back into the cell, which is enough to tell the far from the near.
  struct alignas(64) Bin {
    std::array<float, lanes> x, y, z;
    std::array<std::uint32_t, entries> sphere;
    std::uint32_t more;  ///< a bin with those that had no room
  };
  struct Range {
    int first = 0, count = 1;
    bool all = false;  ///< of a periodic axis, so that images of one bin cannot be told from each other
  };

  [[nodiscard]] std::array<float, 3> point_in_cell(const Eigen::Vector3d& reference) const;
  [[nodiscard]] std::uint32_t bin_of(const std::array<float, 3>& point) const;
  [[nodiscard]] int inside(int axis, int bin) const;
  [[nodiscard]] Range range(int axis, double low, double high) const;
  [[nodiscard]] std::array<double, 2> above(int axis, int row, double middle, double reach) const;
  void put(std::uint32_t bin, std::uint32_t sphere, const std::array<float, 3>& point);
  void take(std::uint32_t bin, std::uint32_t sphere);
  struct Search;
  void search_row(std::size_t line, const Range& xs, double middle, Search& search) const;
  static void search_bin(const Bin& bin, Search& search);

  Cell cell_;
  std::array<int, 3> bins_ = {1, 1, 1};
  Eigen::Vector3d edge_{1, 1, 1};
  std::vector<Bin> bin_;
  std::vector<std::uint32_t> bin_of_sphere_;
};

}  // namespace scalebreak

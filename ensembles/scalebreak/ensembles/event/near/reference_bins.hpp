#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>
#include <scalebreak/ensembles/event/near/bin.hpp>
#include <scalebreak/ensembles/event/near/images.hpp>

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

  /// What find_near uses from one call to the next.
  struct Space {
    std::vector<BinVisit> visits;
    std::vector<Neighbour> found;
  };
  /// Every sphere whose reference is within `reach` of a point, once each, and few others: from the steps of the one and the other
  /// alike. Images are right where `exact`; else, in a cell that is sheared or short, some are farther, and images are left to the caller.
  struct Near {
    std::span<const Neighbour> found;  ///< in the space
    bool exact;
  };
  [[nodiscard]] Near find_near(const Eigen::Vector3d& point, double reach, double strain, Space& space) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// A point in whole steps, counted from the lower corner of its bin.
  struct Place {
    std::array<int, 3> bin;
    std::array<std::int16_t, 3> steps;
  };
  struct Range {
    int first = 0, count = 1;
    bool all = false;  ///< of a periodic axis, so that images of one bin cannot be told from each other
  };

  [[nodiscard]] Place place_of(const Eigen::Vector3d& reference) const;
  [[nodiscard]] std::uint32_t number_of(const std::array<int, 3>& bin) const;
  [[nodiscard, gnu::always_inline]] inline int inside(int axis, int bin) const;
  [[nodiscard, gnu::always_inline]] inline Range range(int axis, double low, double high) const;
  [[nodiscard, gnu::always_inline]] inline std::array<double, 2> above(int axis, int row, double middle, double reach) const;
  void put(std::uint32_t bin, std::uint32_t sphere, const Place& place);
  void take(std::uint32_t bin, std::uint32_t sphere);

  Cell cell_;
  std::array<int, 3> bins_ = {1, 1, 1};
  Eigen::Vector3d edge_{1, 1, 1}, bins_per_length_{1, 1, 1};
  LargeList<Bin> bin_;
  std::vector<std::uint32_t> bin_of_sphere_;
};

}  // namespace scalebreak

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <scalebreak/base/large_list.hpp>
#include <scalebreak/ensembles/event/near/images.hpp>

namespace scalebreak {

/// A cache line of points: whole steps from the lower corner, which is enough to tell the far from the near.
struct alignas(64) Bin {
  static constexpr std::size_t room = 6;
  static constexpr std::int32_t steps = 8192;  ///< along each edge; points beyond a wall may be a few edges outside
  static constexpr std::uint32_t none = (1u << 29) - 1;

  std::array<std::int16_t, room> x{}, y{}, z{};
  std::array<std::uint32_t, room> sphere{};
  std::uint32_t count : 3 = 0, more : 29 = none;  ///< `more`: a bin with those that had no room
};
static_assert(sizeof(Bin) == 64);

/// A bin to be looked into: which image of its spheres that would find, and how many steps its lower corner lies beyond the point in the
/// middle.
struct BinVisit {
  std::uint32_t bin = 0, image = 0;
  float x = 0, y = 0, z = 0;
};

/// What is near: |(x + strain z, y, z)|² < square, of steps of these lengths.
struct BinSearch {
  float step_x = 1, step_y = 1, step_z = 1, strain = 0, square = 0;
};

/// Appends what is near in bins and those with the rest of their spheres.
void look_into_bins(const LargeList<Bin>& bins, const std::vector<BinVisit>& visits, const BinSearch& search,
                    std::vector<Neighbour>& found);

/// The same, in the same order, all of a bin at a time: where the processor has AVX2.
void look_into_whole_bins(const LargeList<Bin>& bins, const std::vector<BinVisit>& visits, const BinSearch& search,
                          std::vector<Neighbour>& found);
[[nodiscard]] inline bool can_look_into_whole_bins() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt"); }

}  // namespace scalebreak

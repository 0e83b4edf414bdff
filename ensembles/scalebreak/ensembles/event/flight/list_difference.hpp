#pragma once

#include <span>
#include <vector>

#include <scalebreak/ensembles/event/near/images.hpp>

namespace scalebreak {

/// What a list has lost and gained, in its order.
struct ListDifference {
  std::vector<Neighbour> lost, gained;
};
void find_difference(std::span<const Neighbour> before, std::span<const Neighbour> after, ListDifference& difference);

/// The same, of at most `most_by_eights` entries after, eight at a time: where the processor has AVX2.
inline constexpr std::size_t most_by_eights = 64;
void find_difference_by_eights(std::span<const Neighbour> before, std::span<const Neighbour> after, ListDifference& difference);
[[nodiscard]] inline bool can_find_by_eights() { return __builtin_cpu_supports("avx2"); }

}  // namespace scalebreak

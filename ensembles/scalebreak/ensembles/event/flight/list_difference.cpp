#include <scalebreak/ensembles/event/flight/list_difference.hpp>

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>

namespace scalebreak {

void find_difference(std::span<const Neighbour> before, std::span<const Neighbour> after, ListDifference& difference) {
  const auto copy_missing = [](std::span<const Neighbour> from, std::span<const Neighbour> in, std::vector<Neighbour>& missing) {
    missing.clear();
    std::copy_if(from.begin(), from.end(), std::back_inserter(missing),
                 [&](Neighbour k) { return std::find(in.begin(), in.end(), k) == in.end(); });
  };
  copy_missing(before, after, difference.lost);
  copy_missing(after, before, difference.gained);
}

[[gnu::target("avx2")]] void find_difference_by_eights(std::span<const Neighbour> before, std::span<const Neighbour> after,
                                                       ListDifference& difference) {
  static_assert(sizeof(Neighbour) == sizeof(std::uint32_t));
  constexpr std::size_t lanes = 8;
  constexpr Neighbour no_entry(most_flying_spheres, 0);
  alignas(32) std::array<Neighbour, most_by_eights> entries;
  __m256i seen[most_by_eights / lanes];
  const std::size_t rows = (after.size() + lanes - 1) / lanes;
  std::copy(after.begin(), after.end(), entries.begin());
  std::fill(entries.begin() + static_cast<std::ptrdiff_t>(after.size()), entries.begin() + static_cast<std::ptrdiff_t>(rows * lanes),
            no_entry);
  for (std::size_t row = 0; row < rows; ++row) seen[row] = _mm256_setzero_si256();
  const auto* const row_of_entries = reinterpret_cast<const __m256i*>(entries.data());
  difference.lost.resize(before.size() + 1);
  std::size_t lost = 0;
  for (const Neighbour old : before) {
    const __m256i wanted = _mm256_set1_epi32(std::bit_cast<std::int32_t>(old));
    __m256i any = _mm256_setzero_si256();
    for (std::size_t row = 0; row < rows; ++row) {
      const __m256i same = _mm256_cmpeq_epi32(_mm256_load_si256(row_of_entries + row), wanted);
      seen[row] = _mm256_or_si256(seen[row], same);
      any = _mm256_or_si256(any, same);
    }
    difference.lost[lost] = old;
    lost += static_cast<std::size_t>(_mm256_testz_si256(any, any));
  }
  difference.lost.resize(lost);
  difference.gained.clear();
  for (std::size_t row = 0; row < rows; ++row) {
    auto missing = ~static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(seen[row]))) & 0xffu;
    for (; missing != 0; missing &= missing - 1) {
      const std::size_t k = row * lanes + static_cast<std::size_t>(std::countr_zero(missing));
      if (k < after.size()) difference.gained.push_back(entries[k]);
    }
  }
}

}  // namespace scalebreak

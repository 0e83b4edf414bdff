#include <immintrin.h>

#include <bit>
#include <cstddef>

#include <scalebreak/ensembles/event/near/bin.hpp>

namespace scalebreak {
namespace {

constexpr std::size_t lanes = 8;

/// For each set of lanes their numbers, and then anything.
constexpr std::array<std::array<std::uint8_t, lanes>, 1u << Bin::room> lanes_of_sets() {
  std::array<std::array<std::uint8_t, lanes>, 1u << Bin::room> lanes_of{};
  for (std::size_t set = 0; set < lanes_of.size(); ++set) {
    std::size_t count = 0;
    for (std::uint8_t lane = 0; lane < Bin::room; ++lane) {
      if (set >> lane & 1u) lanes_of[set][count++] = lane;
    }
  }
  return lanes_of;
}
constexpr auto lanes_of_set = lanes_of_sets();

/// Along one axis, from the point in the middle.
[[gnu::target("avx2,popcnt"), gnu::always_inline]] inline __m256 steps(const std::array<std::int16_t, Bin::room>& of, float corner) {
  const __m128i words = _mm_loadu_si128(reinterpret_cast<const __m128i*>(of.data()));
  return _mm256_add_ps(_mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(words)), _mm256_set1_ps(corner));
}

}  // namespace

void look_into_bins(const LargeList<Bin>& bins, const std::vector<BinVisit>& visits, const BinSearch& search,
                    std::vector<Neighbour>& found) {
  for (const BinVisit& visit : visits) {
    for (std::uint32_t at = visit.bin; at != Bin::none; at = bins[at].more) {
      const Bin& bin = bins[at];
      for (std::size_t k = 0; k < bin.count; ++k) {
        const float z = search.step_z * (static_cast<float>(bin.z[k]) + visit.z),
                    y = search.step_y * (static_cast<float>(bin.y[k]) + visit.y);
        const float x = search.step_x * (static_cast<float>(bin.x[k]) + visit.x) + search.strain * z;
        if (x * x + y * y + z * z < search.square) found.emplace_back(bin.sphere[k], visit.image);
      }
    }
  }
}

[[gnu::target("avx2,popcnt")]] void look_into_whole_bins(const LargeList<Bin>& bins, const std::vector<BinVisit>& visits,
                                                         const BinSearch& search, std::vector<Neighbour>& found) {
  static_assert(offsetof(Bin, z) + lanes * sizeof(std::int16_t) <= sizeof(Bin) && sizeof(Neighbour) == sizeof(std::uint32_t));
  // The eight words that end with the last sphere.
  constexpr int before = lanes - Bin::room;
  constexpr std::size_t spheres_from = offsetof(Bin, sphere) - before * sizeof(std::uint32_t);
  const __m256 step_x = _mm256_set1_ps(search.step_x), step_y = _mm256_set1_ps(search.step_y), step_z = _mm256_set1_ps(search.step_z);
  const __m256 strain = _mm256_set1_ps(search.strain), square = _mm256_set1_ps(search.square);
  std::size_t count = found.size();
  found.resize(count + lanes * (visits.size() + 1));
  for (const BinVisit& visit : visits) {
    for (std::uint32_t at = visit.bin; at != Bin::none; at = bins[at].more) {
      const Bin& bin = bins[at];
      const __m256 z = _mm256_mul_ps(step_z, steps(bin.z, visit.z)), y = _mm256_mul_ps(step_y, steps(bin.y, visit.y));
      const __m256 x = _mm256_add_ps(_mm256_mul_ps(step_x, steps(bin.x, visit.x)), _mm256_mul_ps(strain, z));
      const __m256 distance = _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(x, x), _mm256_mul_ps(y, y)), _mm256_mul_ps(z, z));
      const auto near =
          static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(distance, square, _CMP_LT_OQ))) & ((1u << bin.count) - 1);
      const __m256i spheres = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(reinterpret_cast<const char*>(&bin) + spheres_from));
      const __m256i words =
          _mm256_or_si256(_mm256_slli_epi32(spheres, Neighbour::image_bits), _mm256_set1_epi32(static_cast<int>(visit.image)));
      const __m256i order = _mm256_add_epi32(
          _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(lanes_of_set[near].data()))), _mm256_set1_epi32(before));
      if (found.size() < count + lanes) found.resize(2 * count + lanes);
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(found.data() + count), _mm256_permutevar8x32_epi32(words, order));
      count += static_cast<std::size_t>(std::popcount(near));
    }
  }
  found.resize(count);
}

}  // namespace scalebreak

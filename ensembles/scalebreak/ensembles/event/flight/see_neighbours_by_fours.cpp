#include <immintrin.h>

#include <array>

#include <scalebreak/ensembles/event/flight/see_neighbours.hpp>

// The expressions of see_neighbours.cpp and instants.hpp on four neighbours: without contracted multiplications, so that both give
// the same bits.

namespace scalebreak {
namespace {

/// Four rows of four numbers, which become their columns.
[[gnu::target("avx2"), gnu::always_inline]] inline void transpose(__m256d& a, __m256d& b, __m256d& c, __m256d& d) {
  const __m256d ab_low = _mm256_unpacklo_pd(a, b), ab_high = _mm256_unpackhi_pd(a, b);
  const __m256d cd_low = _mm256_unpacklo_pd(c, d), cd_high = _mm256_unpackhi_pd(c, d);
  a = _mm256_permute2f128_pd(ab_low, cd_low, 0x20), b = _mm256_permute2f128_pd(ab_high, cd_high, 0x20);
  c = _mm256_permute2f128_pd(ab_low, cd_low, 0x31), d = _mm256_permute2f128_pd(ab_high, cd_high, 0x31);
}

[[gnu::target("avx2"), gnu::always_inline]] inline __m256d dot(const __m256d (&a)[3], const __m256d (&b)[3]) {
  return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(a[0], b[0]), _mm256_mul_pd(a[1], b[1])), _mm256_mul_pd(a[2], b[2]));
}

}  // namespace

[[gnu::target("avx2")]] void see_neighbours_by_fours(const Flight& flight, std::span<const Neighbour> list, const FlyingSphere& here,
                                                     Foreseen& next) {
  static_assert(offsetof(FlyingSphere, time) == 24 && offsetof(FlyingSphere, velocity) == 32 && offsetof(FlyingSphere, radius) == 56);
  const bool falls = flight.falls();
  const __m256d now = _mm256_set1_pd(here.time), zero = _mm256_setzero_pd();
  __m256d soonest = _mm256_set1_pd(next.wait), soonest_place = _mm256_set1_pd(-1);
  for (std::size_t k = 0; k < list.size(); k += 4) {
    const std::size_t last = list.size() - 1;
    const std::array<Neighbour, 4> four = {list[k], list[std::min(k + 1, last)], list[std::min(k + 2, last)], list[std::min(k + 3, last)]};
    const auto numbers = [&](std::size_t lane) { return reinterpret_cast<const double*>(&flight.sphere[four[lane].sphere()]); };
    __m256d x = _mm256_load_pd(numbers(0)), y = _mm256_load_pd(numbers(1)), z = _mm256_load_pd(numbers(2)),
            time = _mm256_load_pd(numbers(3));
    __m256d vx = _mm256_load_pd(numbers(0) + 4), vy = _mm256_load_pd(numbers(1) + 4), vz = _mm256_load_pd(numbers(2) + 4),
            radius = _mm256_load_pd(numbers(3) + 4);
    transpose(x, y, z, time);
    transpose(vx, vy, vz, radius);
    const __m256d flown = _mm256_sub_pd(now, time);
    __m256d apart[3] = {x, y, z}, relative[3] = {vx, vy, vz};
    for (int axis = 0; axis < 3; ++axis) {
      __m256d mean = relative[axis];
      if (falls) {
        const __m256d gravity = _mm256_set1_pd(flight.gravity[axis]);
        mean = _mm256_add_pd(mean, _mm256_mul_pd(_mm256_mul_pd(flown, _mm256_set1_pd(0.5)), gravity));
        relative[axis] = _mm256_add_pd(relative[axis], _mm256_mul_pd(flown, gravity));
      }
      apart[axis] = _mm256_add_pd(apart[axis], _mm256_mul_pd(flown, mean));
      relative[axis] = _mm256_sub_pd(relative[axis], _mm256_set1_pd(here.velocity[axis]));
    }
    if (four[0].image() != Images::home || four[1].image() != Images::home || four[2].image() != Images::home ||
        four[3].image() != Images::home) {
      const auto image = [&](std::size_t lane) { return reinterpret_cast<const double*>(&flight.images[four[lane].image()]); };
      __m256d sx = _mm256_loadu_pd(image(0)), sy = _mm256_loadu_pd(image(1)), sz = _mm256_loadu_pd(image(2)),
              drift = _mm256_loadu_pd(image(3));
      transpose(sx, sy, sz, drift);
      apart[0] = _mm256_add_pd(apart[0], _mm256_add_pd(sx, _mm256_mul_pd(now, drift)));
      apart[1] = _mm256_add_pd(apart[1], sy);
      apart[2] = _mm256_add_pd(apart[2], sz);
      relative[0] = _mm256_add_pd(relative[0], drift);
    }
    for (int axis = 0; axis < 3; ++axis) apart[axis] = _mm256_sub_pd(apart[axis], _mm256_set1_pd(here.position[axis]));

    const __m256d approach = dot(apart, relative), distance = _mm256_add_pd(_mm256_set1_pd(here.radius), radius);
    const __m256d gap = _mm256_sub_pd(dot(apart, apart), _mm256_mul_pd(distance, distance));
    const __m256d discriminant = _mm256_sub_pd(_mm256_mul_pd(approach, approach), _mm256_mul_pd(dot(relative, relative), gap));
    const __m256d meet = _mm256_and_pd(_mm256_cmp_pd(approach, zero, _CMP_LT_OQ), _mm256_cmp_pd(discriminant, zero, _CMP_GE_OQ));
    if (_mm256_movemask_pd(meet) == 0) continue;
    const __m256d wait =
        _mm256_max_pd(_mm256_div_pd(gap, _mm256_sub_pd(_mm256_sqrt_pd(_mm256_max_pd(discriminant, zero)), approach)), zero);
    const __m256d sooner = _mm256_and_pd(meet, _mm256_cmp_pd(wait, soonest, _CMP_LT_OQ));
    soonest = _mm256_blendv_pd(soonest, wait, sooner);
    const double place = static_cast<double>(k);
    soonest_place = _mm256_blendv_pd(soonest_place, _mm256_setr_pd(place, place + 1, place + 2, place + 3), sooner);
  }
  alignas(32) std::array<double, 4> waits, places;
  _mm256_store_pd(waits.data(), soonest);
  _mm256_store_pd(places.data(), soonest_place);
  double first = static_cast<double>(list.size());
  for (std::size_t lane = 0; lane < 4; ++lane) {
    if (places[lane] < 0 || waits[lane] > next.wait || (waits[lane] == next.wait && places[lane] >= first)) continue;
    first = places[lane];  // of equal ones the first in the list
    next = {waits[lane], list[static_cast<std::size_t>(first)]};
  }
}

}  // namespace scalebreak

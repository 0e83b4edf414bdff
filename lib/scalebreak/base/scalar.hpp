#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

// What force laws need of their scalar beside arithmetic and square roots, so that the same lines serve double, long double and a
// pack of doubles (std::experimental::simd, which this header does not need to know).

namespace scalebreak {

/// max(x, 0), lane by lane.
template <class T>
[[nodiscard, gnu::always_inline]] inline T positive_part(const T& x) {
  if constexpr (std::is_floating_point_v<T>) {
    return x > 0 ? x : T(0);
  } else {
    return max(x, T(0));
  }
}

/// Does a condition hold in any lane?
template <class Condition>
[[nodiscard, gnu::always_inline]] inline bool any(const Condition& condition) {
  if constexpr (std::is_same_v<Condition, bool>) {
    return condition;
  } else {
    return any_of(condition);
  }
}

/// `yes` where the condition holds, else `no`, lane by lane.
template <class Condition, class T>
[[nodiscard, gnu::always_inline]] inline T choose(const Condition& condition, const T& yes, const T& no) {
  if constexpr (std::is_same_v<Condition, bool>) {
    return condition ? yes : no;
  } else {
    T chosen = no;
    where(condition, chosen) = yes;
    return chosen;
  }
}

/// x^{−1/3} of x > 0. Of a pack of doubles: minus a third of the exponent, right to 4 %, and the series of (1 − h)^{−1/3} in what is
/// left, h = 1 − x y³, twice; right to 2 units in the last place for normal numbers, without a division.
template <class T>
[[nodiscard, gnu::always_inline]] inline T inverse_cube_root(const T& x) {
  if constexpr (std::is_floating_point_v<T>) {
    return 1 / std::cbrt(x);
  } else {
    using Bits [[gnu::vector_size(sizeof(T))]] = std::uint64_t;
    const Bits high = std::bit_cast<Bits>(x) >> 32;
    const Bits third = (high * 0x55555556u) >> 32;  // high / 3, for high below 2³¹
    T y = std::bit_cast<T>(Bits((0x553ef0ffu - third) << 32));
    const T h = 1.0 - x * y * y * y;
    y += y * h * (1.0 / 3 + h * (2.0 / 9 + h * (14.0 / 81 + h * (35.0 / 243))));
    const T rest = 1.0 - x * y * y * y;
    return y + y * rest * (1.0 / 3 + rest * (2.0 / 9));
  }
}

}  // namespace scalebreak

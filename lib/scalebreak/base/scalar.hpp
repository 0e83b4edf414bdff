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

/// Cube root of x ≥ 0. Of a pack of doubles: a third of the exponent, a polynomial and one step of Halley's (the method of
/// Sun's fdlibm, s_cbrt.c); right to 2 units in the last place for normal numbers.
template <class T>
[[nodiscard, gnu::always_inline]] inline T cube_root(const T& x) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::cbrt(x);
  } else {
    using Bits [[gnu::vector_size(sizeof(T))]] = std::uint64_t;
    const Bits high = std::bit_cast<Bits>(x) >> 32;
    const Bits third = (high * 0x55555556u) >> 32;  // high / 3, for high below 2³¹
    T t = std::bit_cast<T>(Bits((third + 715094163) << 32));
    const T r = t * t * (t / x);
    t *= (1.87595182427177009643 + r * (-1.88497979543377169875 + r * 1.621429720105354466140)) +
         r * r * r * (-0.758397934778766047437 + r * 0.145996192886612446982);
    const T rest = x / (t * t);
    return choose(x > 0.0, T(t + t * (rest - t) / (t + t + rest)), T(0));
  }
}

}  // namespace scalebreak

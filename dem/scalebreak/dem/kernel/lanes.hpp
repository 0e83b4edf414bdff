// Included once per instruction set, inside that set's namespace (see kernel_*.cpp): no guard, nothing global.

using Pack = stdx::native_simd<double>;
inline constexpr std::uint32_t width = static_cast<std::uint32_t>(Pack::size());
using Vectors = Vector3Of<Pack>;

/// A Quad in a register.
using Four [[gnu::vector_size(32)]] = double;

[[gnu::always_inline]] inline Four load(const Quad& quad) {
  Four four;
  std::memcpy(&four, &quad, sizeof four);
  return four;
}
[[gnu::always_inline]] inline void store(Quad& quad, Four four) { std::memcpy(static_cast<void*>(&quad), &four, sizeof four); }
[[gnu::always_inline]] inline Four all(double x) { return Four{x, x, x, x}; }

/// Calls `work` with each lane's number, a constant.
template <class Work>
[[gnu::always_inline]] inline void each_lane(Work work) {
  [&]<std::size_t... lane>(std::index_sequence<lane...>) __attribute__((always_inline)) {
    (work(std::integral_constant<std::uint32_t, static_cast<std::uint32_t>(lane)>{}), ...);
  }
  (std::make_index_sequence<width>{});
}

/// Asks for what will be needed before long: into the second cache, as the first has room for few requests at a time. Not by the compiler's
/// builtin: a function that does nothing else is taken for one without effect, and its calls are left out.
[[gnu::always_inline]] inline void ask_for(const Quad& quad) { asm volatile("prefetcht1 %0" : : "m"(quad)); }

/// Four quads turned into their x, y, z and w, or back.
[[gnu::always_inline]] inline void transpose(const Four* from, Four* to) {
  using Order [[gnu::vector_size(32)]] = long;
  const Four even1 = __builtin_shuffle(from[0], from[1], Order{0, 4, 2, 6}), odd1 = __builtin_shuffle(from[0], from[1], Order{1, 5, 3, 7});
  const Four even2 = __builtin_shuffle(from[2], from[3], Order{0, 4, 2, 6}), odd2 = __builtin_shuffle(from[2], from[3], Order{1, 5, 3, 7});
  to[0] = __builtin_shuffle(even1, even2, Order{0, 1, 4, 5});
  to[1] = __builtin_shuffle(odd1, odd2, Order{0, 1, 4, 5});
  to[2] = __builtin_shuffle(even1, even2, Order{2, 3, 6, 7});
  to[3] = __builtin_shuffle(odd1, odd2, Order{2, 3, 6, 7});
}

/// Two quads, and eight doubles of a pack: put together and taken apart in registers, as what is stored by halves and read as a whole waits.
using Eight [[gnu::vector_size(64)]] = double;
using EightOrder [[gnu::vector_size(64)]] = long;

/// Quads 0 to 7, as 0 and 4, 1 and 5, 2 and 6, 3 and 7, turned into their x, y, z and w in the order of quads.
[[gnu::always_inline]] inline void transpose(const Eight* from, Eight* to) {
  constexpr EightOrder even{0, 8, 2, 10, 4, 12, 6, 14}, odd{1, 9, 3, 11, 5, 13, 7, 15};
  constexpr EightOrder low{0, 1, 8, 9, 4, 5, 12, 13}, high{2, 3, 10, 11, 6, 7, 14, 15};
  const Eight even1 = __builtin_shuffle(from[0], from[1], even), odd1 = __builtin_shuffle(from[0], from[1], odd);
  const Eight even2 = __builtin_shuffle(from[2], from[3], even), odd2 = __builtin_shuffle(from[2], from[3], odd);
  to[0] = __builtin_shuffle(even1, even2, low), to[1] = __builtin_shuffle(odd1, odd2, low);
  to[2] = __builtin_shuffle(even1, even2, high), to[3] = __builtin_shuffle(odd1, odd2, high);
}

/// x, y, z and w of `width` quads.
struct Columns {
  Pack x, y, z, w;
};
template <class P = Pack>
[[gnu::always_inline]] inline Columns columns(const Four* quads) {
  if constexpr (P::size() == 4) {
    Four c[4];
    transpose(quads, c);
    return {std::bit_cast<P>(c[0]), std::bit_cast<P>(c[1]), std::bit_cast<P>(c[2]), std::bit_cast<P>(c[3])};
  } else if constexpr (P::size() == 8) {
    Eight pairs[4], c[4];
    for (int k = 0; k < 4; ++k) pairs[k] = __builtin_shufflevector(quads[k], quads[k + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    transpose(pairs, c);
    return {std::bit_cast<P>(c[0]), std::bit_cast<P>(c[1]), std::bit_cast<P>(c[2]), std::bit_cast<P>(c[3])};
  } else {
    return {P([&](auto k) { return quads[k][0]; }), P([&](auto k) { return quads[k][1]; }), P([&](auto k) { return quads[k][2]; }),
            P([&](auto k) { return quads[k][3]; })};
  }
}
[[gnu::always_inline]] inline Vectors vectors(const Four* quads) {
  const Columns c = columns(quads);
  return {c.x, c.y, c.z};
}
/// Histories of the contacts from k on, a multiple of `width`.
[[gnu::always_inline]] inline Vectors histories(const double* list, std::uint32_t k) {
  const double* const x = list + history_place(k);
  return {Pack(x, stdx::element_aligned), Pack(x + history_stride, stdx::element_aligned),
          Pack(x + 2 * history_stride, stdx::element_aligned)};
}
[[gnu::always_inline]] inline void put(double* list, std::uint32_t k, const Vectors& v) {
  double* const x = list + history_place(k);
  v.x.copy_to(x, stdx::element_aligned);
  v.y.copy_to(x + history_stride, stdx::element_aligned);
  v.z.copy_to(x + 2 * history_stride, stdx::element_aligned);
}

/// Vectors turned into quads; w is 0.
template <class P = Pack>
[[gnu::always_inline]] inline void spread(const Vector3Of<P>& v, Four* quads) {
  if constexpr (P::size() == 4) {
    const Four c[4] = {std::bit_cast<Four>(v.x), std::bit_cast<Four>(v.y), std::bit_cast<Four>(v.z), all(0)};
    transpose(c, quads);
  } else if constexpr (P::size() == 8) {
    const Eight c[4] = {std::bit_cast<Eight>(v.x), std::bit_cast<Eight>(v.y), std::bit_cast<Eight>(v.z), Eight{}};
    Eight pairs[4];
    transpose(c, pairs);
    for (int k = 0; k < 4; ++k) {
      quads[k] = __builtin_shufflevector(pairs[k], pairs[k], 0, 1, 2, 3),
      quads[k + 4] = __builtin_shufflevector(pairs[k], pairs[k], 4, 5, 6, 7);
    }
  } else {
    each_lane([&](auto k) { quads[k] = Four{v.x[k], v.y[k], v.z[k], 0}; });
  }
}

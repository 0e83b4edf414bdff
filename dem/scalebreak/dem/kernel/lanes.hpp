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

[[gnu::always_inline]] inline Pack packs(const double* values) { return Pack(values, stdx::element_aligned); }
[[gnu::always_inline]] inline void put(double* values, const Pack& pack) { pack.copy_to(values, stdx::element_aligned); }

/// x, y and z of `width` neighbouring quads. Four of them are transposed in registers.
template <class P = Pack>
[[gnu::always_inline]] inline Vector3Of<P> vectors(const Quad* quads) {
  if constexpr (P::size() == 4) {
    using Order [[gnu::vector_size(32)]] = long;
    const Four a = load(quads[0]), b = load(quads[1]), c = load(quads[2]), d = load(quads[3]);
    const Four even1 = __builtin_shuffle(a, b, Order{0, 4, 2, 6}), odd1 = __builtin_shuffle(a, b, Order{1, 5, 3, 7});
    const Four even2 = __builtin_shuffle(c, d, Order{0, 4, 2, 6}), odd2 = __builtin_shuffle(c, d, Order{1, 5, 3, 7});
    return {std::bit_cast<P>(Four(__builtin_shuffle(even1, even2, Order{0, 1, 4, 5}))),
            std::bit_cast<P>(Four(__builtin_shuffle(odd1, odd2, Order{0, 1, 4, 5}))),
            std::bit_cast<P>(Four(__builtin_shuffle(even1, even2, Order{2, 3, 6, 7})))};
  } else {
    return {P([&](auto k) { return quads[k].x; }), P([&](auto k) { return quads[k].y; }), P([&](auto k) { return quads[k].z; })};
  }
}

/// Puts them there, with w = 0.
template <class P>
[[gnu::always_inline]] inline void put(Quad* quads, const Vector3Of<P>& v) {
  if constexpr (P::size() == 4) {
    using Order [[gnu::vector_size(32)]] = long;
    const Four x = std::bit_cast<Four>(v.x), y = std::bit_cast<Four>(v.y), z = std::bit_cast<Four>(v.z), none = all(0);
    const Four xy02 = __builtin_shuffle(x, y, Order{0, 4, 2, 6}), xy13 = __builtin_shuffle(x, y, Order{1, 5, 3, 7});
    const Four zw02 = __builtin_shuffle(z, none, Order{0, 4, 2, 6}), zw13 = __builtin_shuffle(z, none, Order{1, 5, 3, 7});
    store(quads[0], __builtin_shuffle(xy02, zw02, Order{0, 1, 4, 5}));
    store(quads[1], __builtin_shuffle(xy13, zw13, Order{0, 1, 4, 5}));
    store(quads[2], __builtin_shuffle(xy02, zw02, Order{2, 3, 6, 7}));
    store(quads[3], __builtin_shuffle(xy13, zw13, Order{2, 3, 6, 7}));
  } else {
    for (std::uint32_t k = 0; k < width; ++k) quads[k] = {v.x[k], v.y[k], v.z[k], 0};
  }
}

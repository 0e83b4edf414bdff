// Included once per instruction set, inside that set's namespace (see kernel_*.cpp): no guard, nothing global.

using Pack = stdx::native_simd<double>;
inline constexpr std::uint32_t width = static_cast<std::uint32_t>(Pack::size());

/// A Quad in a register.
using Four [[gnu::vector_size(32)]] = double;

[[gnu::always_inline]] inline Four load(const Quad& quad) {
  Four four;
  std::memcpy(&four, &quad, sizeof four);
  return four;
}
[[gnu::always_inline]] inline void store(Quad& quad, Four four) { std::memcpy(static_cast<void*>(&quad), &four, sizeof four); }
[[gnu::always_inline]] inline Four all(double x) { return Four{x, x, x, x}; }

/// One component of `width` neighbouring quads.
template <double Quad::*component>
[[gnu::always_inline]] inline Pack lanes(const Quad* quads) {
  return Pack([&](auto k) { return quads[k].*component; });
}
[[gnu::always_inline]] inline Vector3Of<Pack> vectors(const Quad* quads) {
  return {lanes<&Quad::x>(quads), lanes<&Quad::y>(quads), lanes<&Quad::z>(quads)};
}
[[gnu::always_inline]] inline void put(Quad* quads, const Vector3Of<Pack>& v) {
  for (std::uint32_t k = 0; k < width; ++k) {
    quads[k].x = v.x[k];
    quads[k].y = v.y[k];
    quads[k].z = v.z[k];
  }
}
[[gnu::always_inline]] inline Pack packs(const double* values) { return Pack(values, stdx::element_aligned); }
[[gnu::always_inline]] inline void put(double* values, const Pack& pack) { pack.copy_to(values, stdx::element_aligned); }

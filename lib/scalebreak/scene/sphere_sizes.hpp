#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <scalebreak/scene/flow_input.hpp>

namespace scalebreak {

/// Radii of the original system, by number. With the mean r and the spread s of [particles]:
///
///     mono        r
///     bidisperse  r and large_radius, so many that the large ones have large_mass_fraction of the mass
///     gaussian    r (1 + s x), x normal and drawn again while |x| > 3, so that no radius falls below r (1 − 3s) ≥ 0.1 r; the cut
///                 leaves the mean and takes 1.3 % of the spread
///     lognormal   exp(μ + σx), σ² = ln(1 + s²), μ = ln r − σ²/2 (Hu 2024, section 6.3), not cut
inline constexpr double gaussian_cut = 3, gaussian_spread_max = 0.3;

/// The purpose of the random stream that draws them, which no other stream has.
inline constexpr std::uint64_t sizes_purpose = 0;

/// Spheres in the order of their identity; of a bidisperse scene the small ones first.
struct Spheres {
  std::vector<double> radius;          ///< [m]
  std::vector<std::uint8_t> material;  ///< 0: of [material], 1: of [second]

  [[nodiscard]] double solids() const;  ///< their volume [m³]
};

/// Densities of [material] and [second], which turn a mass fraction into a number.
struct Densities {
  double material, second;  ///< [kg/m³]
};

/// How the radii spread: mean r³ [m³], and the least and largest radius [m], of a log-normal distribution three σ away.
struct SizeRange {
  double mean_cube, least, largest;
};
[[nodiscard]] SizeRange size_range(const Particles& particles, const Densities& densities);

/// Share of the large ones in the number of a bidisperse scene.
[[nodiscard]] double large_share(const Particles& particles, const Densities& densities);

/// So many spheres; the first of a larger number are the same.
[[nodiscard]] Spheres draw_spheres(const Particles& particles, const Densities& densities, std::size_t count, std::mt19937_64& stream);

/// As many spheres as come nearest to a volume [m³].
[[nodiscard]] Spheres fill_volume(const Particles& particles, const Densities& densities, double volume, std::mt19937_64& stream);

}  // namespace scalebreak

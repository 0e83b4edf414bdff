#include <scalebreak/scene/sphere_sizes.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scalebreak/base/random_draws.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {
namespace {

/// Variance of a normal variable cut at ± c: 1 − 2c φ(c)/erf(c/√2).
double cut_variance(double c) {
  const double density = std::exp(-c * c / 2) / std::sqrt(2 * std::numbers::pi);
  return 1 - 2 * c * density / std::erf(c / std::numbers::sqrt2);
}

double lognormal_sigma(double spread) { return std::sqrt(std::log1p(spread * spread)); }
double lognormal_radius(const Particles& particles, double x) {
  const double sigma = lognormal_sigma(particles.size_spread);
  return particles.radius * std::exp(sigma * (x - sigma / 2));
}

double draw_radius(const Particles& particles, std::mt19937_64& stream) {
  if (particles.size == SizeKind::mono) return particles.radius;
  double x = normal(stream);
  if (particles.size == SizeKind::lognormal) return lognormal_radius(particles, x);
  while (std::abs(x) > gaussian_cut) x = normal(stream);
  return particles.radius * (1 + particles.size_spread * x);
}

double volume_of(double radius) { return sphere_mass(radius, 1.0); }

Spheres bidisperse(const Particles& particles, const Densities& densities, std::size_t count) {
  const double share = large_share(particles, densities);
  const auto large = std::min(count, static_cast<std::size_t>(std::llround(share * static_cast<double>(count))));
  Spheres spheres{std::vector<double>(count, particles.radius), std::vector<std::uint8_t>(count, 0)};
  std::fill(spheres.radius.end() - static_cast<std::ptrdiff_t>(large), spheres.radius.end(), particles.large_radius);
  std::fill(spheres.material.end() - static_cast<std::ptrdiff_t>(large), spheres.material.end(), std::uint8_t{1});
  return spheres;
}

}  // namespace

double Spheres::solids() const {
  double sum = 0;
  for (const double r : radius) sum += volume_of(r);
  return sum;
}

double large_share(const Particles& particles, const Densities& densities) {
  const double small = (1 - particles.large_mass_fraction) / sphere_mass(particles.radius, densities.material);
  const double large = particles.large_mass_fraction / sphere_mass(particles.large_radius, densities.second);
  return large / (large + small);
}

SizeRange size_range(const Particles& particles, const Densities& densities) {
  const double r = particles.radius, s = particles.size_spread, cube = r * r * r;
  switch (particles.size) {
    case SizeKind::mono: break;
    case SizeKind::bidisperse: {
      const double big = particles.large_radius, share = large_share(particles, densities);
      return {(1 - share) * cube + share * big * big * big, r, big};
    }
    case SizeKind::gaussian:
      return {cube * (1 + 3 * s * s * cut_variance(gaussian_cut)), r * (1 - gaussian_cut * s), r * (1 + gaussian_cut * s)};
    case SizeKind::lognormal: return {cube * std::pow(1 + s * s, 3), lognormal_radius(particles, -3), lognormal_radius(particles, 3)};
  }
  return {cube, r, r};
}

Spheres draw_spheres(const Particles& particles, const Densities& densities, std::size_t count, std::mt19937_64& stream) {
  if (particles.size == SizeKind::bidisperse) return bidisperse(particles, densities, count);
  Spheres spheres{std::vector<double>(count), std::vector<std::uint8_t>(count, 0)};
  for (double& radius : spheres.radius) radius = draw_radius(particles, stream);
  return spheres;
}

Spheres fill_volume(const Particles& particles, const Densities& densities, double volume, std::mt19937_64& stream) {
  if (particles.size == SizeKind::mono || particles.size == SizeKind::bidisperse) {
    const double each = volume_of(std::cbrt(size_range(particles, densities).mean_cube));
    return draw_spheres(particles, densities, static_cast<std::size_t>(std::llround(volume / each)), stream);
  }
  Spheres spheres;
  for (double filled = 0; filled < volume;) {
    const double radius = draw_radius(particles, stream), more = volume_of(radius);
    if (filled + more - volume > volume - filled) break;
    spheres.radius.push_back(radius);
    filled += more;
  }
  spheres.material.assign(spheres.radius.size(), 0);
  return spheres;
}

}  // namespace scalebreak

#include <scalebreak/scene/sphere_sizes.hpp>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <scalebreak/base/random.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {
namespace {

constexpr Densities glass{2500, 2500};
constexpr std::size_t many = 200'000;
constexpr double r = 0.5e-3;

std::mt19937_64 stream(std::uint64_t seed = 1) { return random_stream(seed, sizes_purpose, 0); }

Spheres drawn(const Particles& particles, std::size_t count, std::uint64_t seed = 1) {
  auto random = stream(seed);
  return draw_spheres(particles, glass, count, random);
}

/// Mean of a power of the radius over the mean radius asked for.
double moment(const Spheres& spheres, double power) {
  double sum = 0;
  for (const double radius : spheres.radius) sum += std::pow(radius / r, power);
  return sum / static_cast<double>(spheres.radius.size());
}

double spread(const Spheres& spheres) {
  return std::sqrt(moment(spheres, 2) - moment(spheres, 1) * moment(spheres, 1)) / moment(spheres, 1);
}

TEST(SphereSizes, MonoAreAllTheSame) {
  const Spheres spheres = drawn({}, 10);
  EXPECT_EQ(spheres.radius, std::vector<double>(10, r));
  EXPECT_EQ(spheres.material, std::vector<std::uint8_t>(10, 0));
  EXPECT_NEAR(spheres.solids() / (10 * sphere_mass(r, 1)), 1, 1e-14);
}

/// The standard error of the mean is s/√N, that of the standard deviation s/√(2N) of a Gaussian.
TEST(SphereSizes, GaussianHaveMeanAndSpreadAndAreCut) {
  const double cut = std::sqrt(0.973337);  // of the spread, at three standard deviations: 1 − 6 φ(3)/erf(3/√2)
  for (const double s : {0.05, 0.3}) {
    const Particles particles{.size = SizeKind::gaussian, .size_spread = s};
    const Spheres spheres = drawn(particles, many);
    EXPECT_NEAR(moment(spheres, 1), 1, 4 * s / std::sqrt(many));
    EXPECT_NEAR(spread(spheres), s * cut, 4 * s / std::sqrt(2.0 * many));
    const auto [least, largest] = std::minmax_element(spheres.radius.begin(), spheres.radius.end());
    const SizeRange range = size_range(particles, glass);
    EXPECT_GE(*least, range.least);
    EXPECT_LE(*largest, range.largest);
    EXPECT_NEAR(range.least / r, 1 - 3 * s, 1e-14);
    EXPECT_GE(range.least, 0.1 * r * (1 - 1e-14));
    EXPECT_LT(*least / r, 1 - 2.9 * s) << "the tail is there";
    EXPECT_NEAR(moment(spheres, 3) * r * r * r / range.mean_cube, 1, 4 * 3 * s / std::sqrt(many));
  }
}

/// H section 6.3: the mean and the standard deviation are those of the sizes, not of their logarithms.
TEST(SphereSizes, LognormalHaveMeanAndSpreadAndAGaussianLogarithm) {
  const double s = 0.4, sigma = std::sqrt(std::log(1 + s * s));
  const Particles particles{.size = SizeKind::lognormal, .size_spread = s};
  const Spheres spheres = drawn(particles, many);
  EXPECT_NEAR(moment(spheres, 1), 1, 4 * s / std::sqrt(many));
  // The fourth moment about the mean of a log-normal variable, for the error of its spread: w = 1 + s².
  const double w = 1 + s * s, kurtosis = w * w * w * w + 2 * w * w * w + 3 * w * w - 3;
  EXPECT_NEAR(spread(spheres) / s, 1, 4 * std::sqrt((kurtosis - 1) / (4 * many)) + 4 * s / std::sqrt(many));
  double mean = 0, square = 0;
  for (const double radius : spheres.radius) {
    const double x = std::log(radius / r);
    mean += x / many, square += x * x / many;
  }
  EXPECT_NEAR(mean, -sigma * sigma / 2, 4 * sigma / std::sqrt(many));
  EXPECT_NEAR(std::sqrt(square - mean * mean), sigma, 4 * sigma / std::sqrt(2.0 * many));
  const double cubes = std::sqrt(std::pow(w, 15) / std::pow(w, 6) - 1);  // relative spread of r³, with ⟨r^n⟩ = w^{n(n−1)/2}
  EXPECT_NEAR(moment(spheres, 3) * r * r * r / size_range(particles, glass).mean_cube, 1, 4 * cubes / std::sqrt(many));
}

/// W section 5.2: spheres of 1 and 2 mm by mass.
TEST(SphereSizes, BidisperseHaveTheMassFractionAndTheSecondMaterial) {
  for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    for (const Densities densities : {glass, Densities{2500, 4000}}) {
      const Particles particles{.size = SizeKind::bidisperse, .large_radius = 2 * r, .large_mass_fraction = fraction};
      auto random = stream();
      const Spheres spheres = draw_spheres(particles, densities, 9000, random);
      double large = 0, all = 0, cubes = 0;
      for (std::size_t i = 0; i < spheres.radius.size(); ++i) {
        ASSERT_EQ(spheres.radius[i] == 2 * r, spheres.material[i] == 1);
        const double mass = sphere_mass(spheres.radius[i], spheres.material[i] == 1 ? densities.second : densities.material);
        all += mass, cubes += std::pow(spheres.radius[i], 3) / 9000;
        if (spheres.material[i] == 1) large += mass;
      }
      EXPECT_NEAR(large / all, fraction, 1e-3);  // to half a sphere of 9000
      EXPECT_NEAR(cubes / size_range(particles, densities).mean_cube, 1, 1e-3);
    }
  }
}

TEST(SphereSizes, AreAFunctionOfTheSeedAndTheFirstOfManyAreTheSame) {
  const Particles particles{.size = SizeKind::gaussian, .size_spread = 0.1};
  const Spheres few = drawn(particles, 100), more = drawn(particles, 1000), other = drawn(particles, 100, 2);
  EXPECT_TRUE(std::equal(few.radius.begin(), few.radius.end(), more.radius.begin()));
  EXPECT_NE(few.radius, other.radius);
}

TEST(SphereSizes, FillAVolumeToTheNearestSphere) {
  const double volume = 1234.4 * sphere_mass(r, 1);
  for (const SizeKind size : {SizeKind::mono, SizeKind::gaussian, SizeKind::lognormal, SizeKind::bidisperse}) {
    Particles particles{.size = size};
    if (size == SizeKind::gaussian || size == SizeKind::lognormal) particles.size_spread = 0.2;
    if (size == SizeKind::bidisperse) particles.large_radius = 2 * r, particles.large_mass_fraction = 0.5;
    auto random = stream();
    const Spheres spheres = fill_volume(particles, glass, volume, random);
    const double largest = *std::max_element(spheres.radius.begin(), spheres.radius.end());
    EXPECT_NEAR(spheres.solids(), volume, sphere_mass(largest, 1) * 0.51) << static_cast<int>(size);
    EXPECT_EQ(spheres.material.size(), spheres.radius.size());
  }
}

}  // namespace
}  // namespace scalebreak

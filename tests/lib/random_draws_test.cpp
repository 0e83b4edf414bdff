#include <scalebreak/base/random_draws.hpp>

#include <set>

#include <gtest/gtest.h>

namespace scalebreak {
namespace {

TEST(RandomDraws, AStreamIsAFunctionOfSeedPurposeAndReplica) {
  auto a = random_stream(1, 2, 3), again = random_stream(1, 2, 3);
  EXPECT_EQ(a, again);
  std::set<std::uint64_t> first;
  for (const std::uint64_t seed : {0ull, 1ull, 2ull, 1ull << 32}) {
    for (const std::uint64_t purpose : {0ull, 1ull, 2ull, 1ull << 32}) {
      for (const std::uint64_t replica : {0ull, 1ull, 2ull, 1ull << 32}) first.insert(random_stream(seed, purpose, replica)());
    }
  }
  EXPECT_EQ(first.size(), 64u);
}

/// The standard says what std::mt19937_64 gives, so that these are the numbers on every platform.
TEST(RandomDraws, TheNumbersAreTheSameOnEveryPlatform) {
  auto stream = random_stream(1, 1, 0);
  EXPECT_EQ(stream(), 4234340509540878914u);
}

TEST(RandomDraws, DrawsHaveTheMomentsThatTheyAreSaidTo) {
  constexpr int draws = 1'000'000;
  auto stream = random_stream(7, 1, 0);
  double mean = 0, square = 0, fourth = 0, even = 0, even_square = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = normal(stream), u = uniform(stream);
    ASSERT_TRUE(u >= 0 && u < 1);
    mean += x / draws, square += x * x / draws, fourth += x * x * x * x / draws;
    even += u / draws, even_square += u * u / draws;
  }
  // Within four standard errors.
  const double root = std::sqrt(draws);
  EXPECT_NEAR(mean, 0, 4 / root);
  EXPECT_NEAR(square, 1, 4 * std::sqrt(2) / root);
  EXPECT_NEAR(fourth, 3, 4 * std::sqrt(96) / root);
  EXPECT_NEAR(even, 0.5, 4 * std::sqrt(1.0 / 12) / root);
  EXPECT_NEAR(even_square, 1.0 / 3, 4 * std::sqrt(4.0 / 45) / root);
}

}  // namespace
}  // namespace scalebreak

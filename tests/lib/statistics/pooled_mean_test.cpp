#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <scalebreak/statistics/pooled_mean.hpp>

namespace scalebreak::tests {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

TEST(PooledMean, OfOneRunIsThatRun) {
  const Measured one = pooled_mean({{3.0, 0.2}});
  EXPECT_EQ(one.value, 3.0);
  EXPECT_EQ(one.error, 0.2);
  EXPECT_TRUE(std::isnan(pooled_mean({}).value));
  EXPECT_TRUE(std::isnan(pooled_mean({{nothing, 1}, {nothing, 1}}).value));
}

TEST(PooledMean, WeighsScatterAndOwnErrorsByTheirFreedom) {
  // Two runs with errors of 31 degrees of freedom each and one degree between them: variance (1 · 0.02 + 62 · 0.04) / 63 of a run, half of it of the mean.
  const Measured mean = pooled_mean({{1.0, 0.2}, {1.2, 0.2}});
  EXPECT_DOUBLE_EQ(mean.value, 1.1);
  EXPECT_NEAR(mean.error, std::sqrt((0.02 + 62 * 0.04) / 63 / 2), 1e-15);
}

TEST(PooledMean, GoesByTheScatterOfRunsThatAreNotAlike) {
  constexpr double two = 12.706204736432095 / 1.96;  // Student's t of one degree of freedom at 97.5 %
  EXPECT_NEAR(pooled_mean({{1.0, 0.01}, {2.0, 0.01}}).error, two * 0.5, 1e-9);
  EXPECT_NEAR(pooled_mean({{1.0, nothing}, {1.2, 0.2}}).error, two * 0.1, 1e-9);
  EXPECT_NEAR(pooled_mean({{1.0, 0.2}, {nothing, nothing}}).error, 0.2, 1e-15);
}

TEST(PooledMean, OfFourRunsGoesByTheirScatter) {
  const double scatter = std::sqrt(0.02 / 3 / 4), four = 3.182446305284263 / 1.96;
  EXPECT_NEAR(pooled_mean({{1.0, 5}, {1.1, 5}, {1.1, 5}, {1.2, 5}}).error, scatter * four, 1e-9);
}

TEST(PooledMean, IsOffByMoreThanTwoErrorsAsOftenAsItSaysByScatterAlone) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (const int count : {2, 4, 8}) {
    int off = 0;
    constexpr int trials = 20000;
    for (int t = 0; t < trials; ++t) {
      std::vector<Measured> runs;
      for (int r = 0; r < count; ++r) runs.push_back({normal(random), nothing});
      const Measured mean = pooled_mean(runs);
      off += std::abs(mean.value) > 1.96 * mean.error;
    }
    EXPECT_NEAR(static_cast<double>(off) / trials, 0.05, 0.006) << count;
  }
}

TEST(PooledMean, IsOffByMoreThanTwoErrorsAsOftenAsItSays) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::chi_squared_distribution<double> squares(31);
  int off = 0;
  constexpr int trials = 20000;
  for (int t = 0; t < trials; ++t) {
    std::vector<Measured> runs;
    for (int r = 0; r < 3; ++r) runs.push_back({normal(random), std::sqrt(squares(random) / 31)});
    const Measured mean = pooled_mean(runs);
    off += std::abs(mean.value) > 2 * mean.error;
  }
  // Of a normal value 4.55 %; 0.15 % is one standard deviation of this count.
  EXPECT_NEAR(static_cast<double>(off) / trials, 0.0455, 0.006);
}

}  // namespace
}  // namespace scalebreak::tests

#include <scalebreak/statistics/standard_error.hpp>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <lib/statistics/series.hpp>
#include <scalebreak/statistics/block_series.hpp>

namespace scalebreak {
namespace {

/// The mean of a series by blocks, as a flow measures it, each value holding for its weight.
Measured measured(const std::vector<double>& series, const std::vector<double>& weights) {
  BlockSeries blocks;
  for (std::size_t i = 0; i < series.size(); ++i) blocks.add(Eigen::Array2d(weights[i] * series[i], weights[i]));
  std::vector<double> sums, lengths;
  for (const Eigen::ArrayXd& block : blocks.blocks()) {
    sums.push_back(block[0]);
    lengths.push_back(block[1]);
  }
  return ratio_of_sums(sums, lengths);
}

struct Spread {
  double mean_square = 0;  ///< of (mean − true)/error
  double untold = 0;       ///< share of runs without an error
  double misled = 0;       ///< share of all runs that lie beyond twice their error
};

Spread spread_of(std::size_t count, double correlation, bool unequal = false) {
  constexpr int seeds = 200;
  Spread spread;
  int told = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const std::vector<double> series = autoregressive(count, correlation, random);
    std::vector<double> weights(count, 1);
    std::uniform_real_distribution<double> length(0.1, 3);
    if (unequal) std::generate(weights.begin(), weights.end(), [&] { return length(random); });
    const Measured mean = measured(series, weights);
    if (std::isnan(mean.error)) continue;
    ++told;
    spread.mean_square += std::pow(mean.value / mean.error, 2);
    spread.misled += std::abs(mean.value) > 2 * mean.error ? 1.0 / seeds : 0;
  }
  spread.mean_square /= told;
  spread.untold = 1 - told / double{seeds};
  return spread;
}

// The mean square of 200 unit normals is 1 ± √(2/200) = 0.1: three of these.
constexpr double three_sigma = 0.3;

class CorrelatedSeries : public testing::TestWithParam<std::pair<std::size_t, double>> {};

TEST_P(CorrelatedSeries, TheErrorIsThatOfTheMean) {
  const Spread spread = spread_of(GetParam().first, GetParam().second);
  EXPECT_NEAR(spread.mean_square, 1, three_sigma);
  EXPECT_LE(spread.untold, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Lengths, CorrelatedSeries,
                         testing::Values(std::pair{200, 0.0}, std::pair{1000, 0.0}, std::pair{1000, 0.5}, std::pair{4000, 0.9},
                                         std::pair{20000, 0.98}, std::pair{20000, -0.5}));

TEST(StandardError, CountsUnequalIntervalsByTheirLength) {
  const Spread spread = spread_of(4000, 0.9, true);
  EXPECT_NEAR(spread.mean_square, 1, three_sigma);
}

TEST(StandardError, IsNotGivenWhereTheRunIsTooShortToTell) {
  EXPECT_GE(spread_of(300, 0.98).untold, 0.98);   // 3 independent stretches
  EXPECT_GE(spread_of(300, 0.999).untold, 0.98);  // less than one
  EXPECT_EQ(spread_of(20, 0).untold, 1);
}

TEST(StandardError, AtTheEdgeItMisleadsNoMoreOftenThanAnHonestOne) {
  // With 20 independent stretches, those few runs that look longer than they are get too small an error.
  const Spread spread = spread_of(4000, 0.99);
  EXPECT_GE(spread.untold, 0.75);
  EXPECT_LE(spread.misled, 0.05);
}

TEST(StandardError, IsNotGivenForADrift) {
  std::vector<double> series(1000);
  std::iota(series.begin(), series.end(), 0);
  EXPECT_TRUE(std::isnan(measured(series, std::vector<double>(1000, 1)).error));
}

TEST(StandardError, OfAConstantIsZeroAndOfNothingUnknown) {
  const Measured constant = measured(std::vector<double>(100, 2.5), std::vector<double>(100, 1));
  EXPECT_EQ(constant.value, 2.5);
  EXPECT_EQ(constant.error, 0);
  const Measured never = measured(std::vector<double>(100, 0), std::vector<double>(100, 1));
  EXPECT_EQ(never.value, 0);
  EXPECT_TRUE(std::isnan(never.error));
  EXPECT_TRUE(std::isnan(ratio_of_sums({}, {}).value));
}

}  // namespace
}  // namespace scalebreak

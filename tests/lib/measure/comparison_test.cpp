#include <scalebreak/measure/comparison.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace scalebreak {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Comparison temperatures(Measured first, Measured second) {
  return compare(Quantity{"temperature", "m2/s2", first}, Quantity{"temperature", "m2/s2", second});
}

TEST(Comparison, ADifferenceExceedsTwoStandardErrorsOfBoth) {
  EXPECT_EQ(temperatures({1, 0.03}, {1.11, 0.04}).verdict, Verdict::difference);  // 0.11 over 2·0.05
  EXPECT_EQ(temperatures({1, 0.03}, {1.09, 0.04}).verdict, Verdict::no_difference);
  EXPECT_EQ(temperatures({1, 0.03}, {0.89, 0.04}).verdict, Verdict::difference);
  EXPECT_EQ(compare(Quantity{"q", "-", {1, 0.03}}, Quantity{"q", "-", {1.11, 0.04}}, 3).verdict, Verdict::no_difference);
  EXPECT_DOUBLE_EQ(temperatures({1, 0.03}, {1.11, 0.04}).difference.error, 0.05);
}

TEST(Comparison, RelativeErrorCountsThatOfTheFirstByTheRatio) {
  const Comparison c = temperatures({2, 0.02}, {4, 0.03});
  EXPECT_DOUBLE_EQ(c.relative.value, 1);
  EXPECT_DOUBLE_EQ(c.relative.error, std::hypot(0.03, 2 * 0.02) / 2);
  EXPECT_DOUBLE_EQ(temperatures({-2, 0.02}, {-4, 0.03}).relative.error, c.relative.error);
}

TEST(Comparison, ExactQuantitiesDifferBeyondRounding) {
  EXPECT_EQ(temperatures({0.4, 0}, {0.4 * (1 + 1e-15), 0}).verdict, Verdict::no_difference);
  EXPECT_EQ(temperatures({0.4, 0}, {0.4 * (1 + 1e-9), 0}).verdict, Verdict::difference);
}

TEST(Comparison, IsUnknownWithoutAnError) {
  EXPECT_EQ(temperatures({1, unknown}, {9, 0.1}).verdict, Verdict::unknown);
  EXPECT_EQ(temperatures({unknown, unknown}, {9, 0.1}).verdict, Verdict::unknown);
}

TEST(Comparison, SaysItInASentence) {
  EXPECT_EQ(sentence(temperatures({1, 0.006}, {1.081, 0.005})), "temperature differs by +8.1 % ± 0.8 %: a difference");
  EXPECT_EQ(sentence(temperatures({1, 0.02}, {0.99, 0.02})), "temperature differs by -1.0 % ± 2.8 %: no difference beyond the error");
  EXPECT_EQ(sentence(temperatures({1, 2e-4}, {1.001, 2e-4})), "temperature differs by +0.10 % ± 0.03 %: a difference");
  EXPECT_EQ(sentence(temperatures({1, 0}, {1 + 1e-9, 0})), "temperature differs by +1e-07 % ± 0 %: a difference");
  EXPECT_EQ(sentence(temperatures({0, 0.1}, {1, 0.1})), "temperature differs by +1 m2/s2 ± 0.14 m2/s2: a difference");
  EXPECT_EQ(sentence(temperatures({1, unknown}, {1.5, 0.1})), "temperature differs by +50 %, but a run is too short to tell its error");
  EXPECT_EQ(sentence(temperatures({1, 0.1}, {unknown, unknown})), "temperature is not in both runs: nothing to compare");
}

TEST(Comparison, PairsQuantitiesByName) {
  const std::vector<Quantity> first = {{"a", "-", {1, 0.1}}, {"b", "-", {2, 0.1}}}, second = {{"c", "-", {1, 0.1}}, {"b", "-", {3, 0.1}}};
  const auto both = compare(first, second);
  ASSERT_EQ(both.size(), 1U);
  EXPECT_EQ(both[0].name, "b");
  EXPECT_EQ(both[0].difference.value, 1);
}

}  // namespace
}  // namespace scalebreak

#include <gmock/gmock.h>

#include <scalebreak/collisions/papers/paper_curve.hpp>

namespace scalebreak::tests {
namespace {

TEST(PaperCurve, IsStraightBetweenItsPointsAndHeldBeyondThem) {
  const PaperCurve curve{{0, 1, 3}, {0, 2, 4}};
  EXPECT_DOUBLE_EQ(curve.at(0.25), 0.5);
  EXPECT_DOUBLE_EQ(curve.at(2), 3);
  EXPECT_DOUBLE_EQ(curve.at(1), 2);
  EXPECT_DOUBLE_EQ(curve.at(-1), 0);
  EXPECT_DOUBLE_EQ(curve.at(9), 4);
}

TEST(PaperCurve, DistanceIsTheLargestOneOverTheRangeOfTheFirst) {
  const PaperCurve ramp{{0, 10}, {0, 4}}, other{{0, 5, 10}, {0, 3, 4}};
  EXPECT_NEAR(curve_distance(ramp, other, 10).value(), 0.25, 1e-12) << "1 at the middle, over 4";
  EXPECT_NEAR(curve_distance(other, ramp, 5).value(), 1.0 / 3, 1e-12) << "up to 5 alone";
  EXPECT_EQ(curve_distance(ramp, ramp, 10), 0.0);
  EXPECT_EQ(curve_distance({{0, 1}, {2, 2}}, ramp, 1), std::nullopt) << "a constant has no range";
}

}  // namespace
}  // namespace scalebreak::tests

#include <scalebreak/contact/slider.hpp>

#include <cmath>

#include <gtest/gtest.h>

// The spring–dashpot–slider: when it holds, slides and skids, and what its force does at each change.

namespace scalebreak {
namespace {

template <class Dimension>
class SliderTest : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  using Vector = Tangent<D>;

  /// Along the first axis; `aside` along the last, if there is another.
  static Vector vector(double along, double aside = 0) {
    Vector v = Vector::Zero();
    v[0] = along;
    if (D > 1) v[D - 1] = aside;
    return v;
  }
  /// A limit on spring plus dashpot (friction), or on the spring's force alone (rolling).
  static SliderLaw friction() { return {.stiffness = 40, .damping = 0.3, .limit = 2, .dashpot_is_limited = true}; }
  static SliderLaw rolling() { return {.stiffness = 40, .damping = 0.3, .limit = 2, .incremental = true}; }
};

using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SliderTest, Dimensions);

TYPED_TEST(SliderTest, HoldsWithSpringAndDashpot) {
  const auto speed = this->vector(0.5, 0.25);
  const Slider<TestFixture::D> displaced{this->vector(0.01, -0.02)}, incremental{this->vector(0.4, -0.8)};
  EXPECT_TRUE(displaced.force(this->friction(), speed).isApprox(this->vector(40 * 0.01 + 0.3 * 0.5, 40 * -0.02 + 0.3 * 0.25), 1e-15));
  EXPECT_TRUE(incremental.force(this->rolling(), speed).isApprox(displaced.force(this->friction(), speed), 1e-15));
  EXPECT_LT(displaced.end_of_grip(this->friction(), speed, speed, 1), 0);
  EXPECT_TRUE(displaced.rate(this->friction(), speed, speed, 0.1).isApprox(0.1 * speed, 1e-15));
  EXPECT_TRUE(incremental.rate(this->rolling(), speed, speed, 0.1).isApprox(40 * 0.1 * speed, 1e-15));
}

TYPED_TEST(SliderTest, BeginsToSlideAtTheLimitWithTheForceItHad) {
  const SliderLaw law = this->friction();
  const auto speed = this->vector(0.5), still = this->vector(0);
  Slider<TestFixture::D> slider{this->vector((2 - 0.15) / 40 * (1 + 1e-9))};
  EXPECT_GT(slider.end_of_grip(law, speed, still, 1), 0);
  const auto before = slider.force(law, speed);
  slider.let_go(law, speed, still, 1);
  EXPECT_EQ(slider.grip, Grip::slides);
  EXPECT_NEAR((slider.force(law, speed) - before).norm(), 0, 1e-8);
  EXPECT_LT(slider.end_of_grip(law, speed, still, 1), 0) << "it would hold again at once";
}

TYPED_TEST(SliderTest, LosesAnUnlimitedDashpotWhereItBeginsToSlide) {
  const SliderLaw law = this->rolling();
  const auto speed = this->vector(0.5), still = this->vector(0);
  Slider<TestFixture::D> slider{this->vector(2 * (1 + 1e-9))};
  EXPECT_GT(slider.end_of_grip(law, speed, still, 1), 0);
  EXPECT_NEAR(slider.force(law, speed)[0], 2.15, 1e-8);
  slider.let_go(law, speed, still, 1);
  EXPECT_EQ(slider.grip, Grip::slides);
  EXPECT_EQ(slider.force(law, speed)[0], 2);
}

TYPED_TEST(SliderTest, HoldsAgainWithTheForceItHadWhereItsForceFallsFasterThanTheLimit) {
  for (SliderLaw law : {this->friction(), this->rolling()}) {
    const auto speed = this->vector(-0.5), still = this->vector(0);
    Slider<TestFixture::D> slider;
    slider.slide_along(this->vector(3));
    EXPECT_GT(slider.end_of_grip(law, speed, still, 1), 0);
    const auto before = slider.force(law, speed);
    slider.let_go(law, speed, still, 1);
    EXPECT_EQ(slider.grip, Grip::holds);
    const double dashpot = law.dashpot_is_limited ? 0 : 0.3 * -0.5;  // comes back where it is not part of the limit
    EXPECT_NEAR((slider.force(law, speed) - before)[0], dashpot, 1e-14);
    // A limit that falls faster still goes on sliding.
    law.limit_rate = -100;
    slider.slide_along(this->vector(3));
    EXPECT_LT(slider.end_of_grip(law, speed, still, 1), 0);
  }
}

TYPED_TEST(SliderTest, FollowsAStiffnessThatChangesOnlyWithADisplacement) {
  // k grows by a tenth per unit of time: a displacement's force grows with it, an increment's does not.
  SliderLaw law = this->friction();
  law.damping = 0;
  law.stiffness_rate = 4;
  law.limit_rate = 0.1;
  Slider<TestFixture::D> slider;
  slider.slide_along(this->vector(1));
  const auto still = this->vector(0);
  EXPECT_NEAR(slider.end_of_grip(law, still, still, 1), 0.1 - 4.0 / 40 * 2, 1e-15);
  law.incremental = true;
  EXPECT_NEAR(slider.end_of_grip(law, still, still, 1), 0.1, 1e-15);
}

TYPED_TEST(SliderTest, SkidsWhereTheDashpotAloneExceedsTheLimit) {
  const SliderLaw law = this->friction();
  const double end = law.limit / law.damping;
  const auto still = this->vector(0), faster = this->vector(1);
  Slider<TestFixture::D> slider;
  slider.slide_along(this->vector(1));
  EXPECT_LT(slider.begin_of_skid(law, this->vector(0.999 * end), faster), 0);
  const auto speed = this->vector(1.001 * end);
  EXPECT_GT(slider.begin_of_skid(law, speed, faster), 0);
  Slider<TestFixture::D> relaxes{slider};
  relaxes.grip = Grip::relaxes;
  EXPECT_GT(relaxes.begin_of_skid(law, speed, faster), 0);
  EXPECT_LT(relaxes.begin_of_skid(law, speed, this->vector(-1)), 0) << "a spring that pushes forward, less and less, goes on sliding";
  EXPECT_EQ(Slider<TestFixture::D>{slider}.begin_of_skid(this->rolling(), speed, faster), -1) << "a dashpot without limit cannot exceed it";
  const auto at_end = this->vector(end);
  const auto before = slider.force(law, at_end);
  slider.skid(law, at_end);
  EXPECT_NEAR((slider.force(law, at_end) - before).norm(), 0, 1e-14);
  EXPECT_NEAR(slider.energy(law, at_end), 0, 1e-30);
  EXPECT_EQ(slider.rate(law, speed, speed, 1), still);
  EXPECT_LT(slider.end_of_grip(law, speed, speed, 1), 0);
}

TYPED_TEST(SliderTest, KeepsASpringThatPushesForwardWhileItSkids) {
  // Whether it slips for a moment or not at all must come to the same: the spring is as it was.
  const SliderLaw law = this->friction();
  const auto stretch = this->vector(-0.01);
  const auto speed = this->vector((law.limit + 0.01 * law.stiffness) / law.damping * (1 + 1e-9));
  Slider<TestFixture::D> slider{stretch};
  const auto before = slider.force(law, speed);
  ASSERT_GT(slider.end_of_grip(law, speed, speed, 1), 0);
  slider.let_go(law, speed, speed, 1);
  EXPECT_EQ(slider.grip, Grip::skids);
  EXPECT_NEAR((slider.force(law, speed) - before).norm(), 0, 1e-7);
  EXPECT_EQ(slider.history, stretch);
  const auto slower = this->vector(speed.norm() * (1 - 1e-6)), slows = this->vector(-1e4);
  ASSERT_GT(slider.end_of_grip(law, slower, slows, 1), 0);
  slider.let_go(law, slower, slows, 1);
  EXPECT_EQ(slider.grip, Grip::holds);
  EXPECT_EQ(slider.history, stretch);
}

TYPED_TEST(SliderTest, SlidesFromASkidWithoutAJumpWhereItsDashpotFallsToTheLimit) {
  const SliderLaw law = this->friction();
  const double end = law.limit / law.damping;
  const auto speed = this->vector(end * (1 - 1e-12)), slows = this->vector(-1);
  Slider<TestFixture::D> slider{this->vector(0), Grip::skids};
  EXPECT_LT(slider.end_of_grip(law, this->vector(end * 1.01), slows, 1), 0);
  EXPECT_GT(slider.end_of_grip(law, speed, slows, 1), 0);
  const auto before = slider.force(law, speed);
  slider.let_go(law, speed, slows, 1);
  EXPECT_EQ(slider.grip, Grip::slides);  // its spring is driven at k v = 266, the dashpot falls by 0.3
  EXPECT_NEAR((slider.force(law, speed) - before).norm(), 0, 1e-12);
  EXPECT_NEAR(slider.energy(law, speed), 0, 1e-12);
}

TYPED_TEST(SliderTest, HoldsFromASkidThatSlowsTooFast) {
  const SliderLaw law = this->friction();
  const double end = law.limit / law.damping;
  const auto speed = this->vector(end * (1 - 1e-12)), slows = this->vector(-1e4);
  Slider<TestFixture::D> slider{this->vector(0), Grip::skids};
  const auto before = slider.force(law, speed);
  slider.let_go(law, speed, slows, 1);
  EXPECT_EQ(slider.grip, Grip::holds);
  EXPECT_NEAR((slider.force(law, speed) - before).norm(), 0, 1e-11);
}

TYPED_TEST(SliderTest, RestartsAlongWhatDrivesItWhereTheLimitPassesZero) {
  SliderLaw law{.stiffness = 40, .limit = 0, .limit_rate = 1, .dashpot_is_limited = true};
  const auto speed = this->vector(-0.5, 0.1), still = this->vector(0);
  Slider<TestFixture::D> slider;
  slider.slide_along(this->vector(1));
  slider.restart(law, speed, still, 1);
  EXPECT_EQ(slider.grip, Grip::slides);
  EXPECT_TRUE(slider.history.isApprox(speed / speed.norm(), 1e-15));
  // A limit that opens faster than the spring is stretched holds, from an unstretched spring.
  law.limit_rate = 100;
  slider.restart(law, speed, still, 1);
  EXPECT_EQ(slider.grip, Grip::holds);
  EXPECT_EQ(slider.history, still);
  slider.restart(law, speed, still, 1);
  EXPECT_EQ(slider.grip, Grip::holds) << "what holds is left alone";
}

TYPED_TEST(SliderTest, KeepsHalfTheStretchTimesTheForce) {
  Slider<TestFixture::D> held{this->vector(0.01)};
  EXPECT_NEAR(held.energy(this->friction(), this->vector(7)), 40 * 0.01 * 0.01 / 2, 1e-17);
  held.history = this->vector(0.4);
  EXPECT_NEAR(held.energy(this->rolling(), this->vector(7)), 40 * 0.01 * 0.01 / 2, 1e-17);
  Slider<TestFixture::D> slides;
  slides.slide_along(this->vector(1));
  EXPECT_NEAR(slides.energy(this->friction(), this->vector(0.5)), std::pow(2 - 0.15, 2) / 80, 1e-15);
}

/// A thousand small stretches, each set back to the limit, turn the force as the rate of what slides does.
TEST(Slider, TurnsItsDirectionAsAManyTimesProjectedSpring) {
  const SliderLaw law{.stiffness = 40, .limit = 2, .limit_floor = 2e-9};
  const Tangent<3> speed(0.3, 0.8, 0), still(0, 0, 0);
  constexpr int count = 20000;
  constexpr double dt = 0.1 / count;
  Slider<3> slider;
  slider.slide_along({1, 0, 0});
  Tangent<3> spring(2, 0, 0);
  for (int i = 0; i < count; ++i) {
    spring += law.stiffness * speed * dt;
    spring *= law.limit / spring.norm();
    const Tangent<3> middle = slider.history + slider.rate(law, speed, still, dt) / 2;
    slider.history += Slider<3>{middle, Grip::slides}.rate(law, speed, still, dt);
  }
  EXPECT_NEAR(slider.history.norm(), 1, 1e-8);
  EXPECT_GT(spring[1], 1.2) << "the direction must have turned for this to mean anything";
  EXPECT_NEAR((slider.force(law, speed) - spring).norm(), 0, 1e-4);
}

}  // namespace
}  // namespace scalebreak

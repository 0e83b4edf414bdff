#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/numeric/odeint/algebra/range_algebra.hpp>

#include <lib/resolving.hpp>
#include <scalebreak/collisions/bodies/few_body_system.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/event_integrator.hpp>
#include <scalebreak/collisions/steps/embedded_steps.hpp>

namespace scalebreak::tests {
namespace {

const std::string oblique = "[impact]\nnormal_speed = 0.1\ntangential_speed = 0.15\nspin1 = [0, 20, 5]\n";
const std::string dry = "[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\n";
const std::string held = "[material]\nrolling_angle_max = 0.01\n[contact]\nnormal = \"jkr\"\ndamping_on = \"contact_radius\"\n";

/// What begins and ends as JKR does in its three ranges, slides and holds, rolls and stops, is wet.
const std::vector<std::string> scenes = {
    dry,
    held + "adhesion_range = \"full\"\n",
    held + "adhesion_range = \"pull_off\"\n",
    held + "adhesion_range = \"touch\"\n",
    dry + "tangential = \"mindlin\"\n" + oblique,
    held + "tangential = \"mindlin\"\ntangential_radius = \"contact_radius\"\nrolling = \"ar\"\n" + oblique,
    dry + "tangential = \"mindlin\"\nrolling = \"cdt\"\n" + oblique,
    "[material]\nsurface_energy = 0\nsurface_tension = 0.07\nviscosity = 0.001\nliquid_volume = 2e-12\n[contact]\nnormal = \"hertz\"\n"
    "tangential = \"mindlin\"\nattraction = \"capillary+viscous\"\nattraction_range = \"bridge\"\n[impact]\nnormal_speed = 0.4\n"
    "tangential_speed = 0.1\n"};

/// Largest difference of a velocity or surface speed [m/s].
double difference(const MotionOutcome& a, const MotionOutcome& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    largest = std::max(
        {largest, (a.bodies[i].velocity - b.bodies[i].velocity).norm(), a.bodies[i].radius * (a.bodies[i].spin - b.bodies[i].spin).norm()});
  }
  return largest;
}

struct SteppersOf : testing::TestWithParam<Stepper> {};

/// Each takes every contact to the same end as the default does at its finest, with the same events on the way, as well as its tolerance says.
TEST_P(SteppersOf, EveryLawComeToTheSameEnd) {
  for (const std::string& words : scenes) {
    const Input input = resolved(words);
    const MovingScene scene = moving_scene(input);
    const double speed = std::hypot(input.normal_speed, input.tangential_speed);
    const MotionOutcome exact = scene.move({.tolerance = 1e-12});
    double coarse = 0;
    for (const double tolerance : {1e-4, 1e-7, 1e-9}) {
      const MotionOutcome found = scene.move({.tolerance = tolerance, .stepper = GetParam()});
      const double error = difference(found, exact) / speed;
      EXPECT_LT(error, 3 * tolerance) << words << tolerance;
      EXPECT_EQ(found.slides, exact.slides) << words << tolerance;
      EXPECT_EQ(found.rolls, exact.rolls) << words << tolerance;
      EXPECT_EQ(found.open_contacts, 0) << words << tolerance;
      if (tolerance == 1e-4) coarse = error;
      if (tolerance == 1e-9) {
        EXPECT_LT(error, coarse) << words;
      }
    }
  }
}

TEST_P(SteppersOf, CountTheSameWorkAgain) {
  const MovingScene scene = moving_scene(resolved(scenes[5]));
  const auto move = [&](double tolerance) { return scene.move({.tolerance = tolerance, .stepper = GetParam()}); };
  EXPECT_EQ(move(1e-6).force_evaluations, move(1e-6).force_evaluations);
  EXPECT_EQ(difference(move(1e-6), move(1e-6)), 0);
  EXPECT_GT(move(1e-10).force_evaluations, move(1e-6).force_evaluations);
}

INSTANTIATE_TEST_SUITE_P(All, SteppersOf,
                         testing::Values(Stepper::fehlberg78, Stepper::cash_karp54, Stepper::dopri5, Stepper::dopri5_dense,
                                         Stepper::bulirsch_stoer));

/// y'' = −y, which counts what it is asked.
struct Oscillator {
  using State = std::vector<double>;
  using Values = std::vector<double>;
  int rates = 0, looks = 0;

  void operator()(const State& y, State& rate, double) { ++rates, rate = {y[1], -y[0]}; }
  void event_values(const State&, Values& values) { ++looks, values = {-1.0}; }
  static double scale(std::size_t) { return 1; }
};

/// Fehlberg's twelve rates within a step and the one at its end, where the next begins; looks on the cubic and at the end.
TEST(EventIntegrator, GoesOnFromWhatTheLastStepEndedWith) {
  using Steps = EmbeddedSteps<Oscillator::State, Fehlberg78<Oscillator::State, boost::numeric::odeint::range_algebra>>;
  Oscillator system;
  EventIntegrator<Oscillator, Steps> integrator(system, 1e-3, 0.1);
  Oscillator::State y = {1, 0};
  for (int step = 1; step <= 5; ++step) {
    ASSERT_EQ(integrator.advance(y), integrator.none);
    EXPECT_EQ(system.rates, 1 + 13 * step);
    EXPECT_EQ(system.looks, 1 + 3 * step);
  }
  y[0] += 0.1;
  (void)integrator.advance(y);
  EXPECT_EQ(system.rates, 1 + 13 * 6 + 1);
}

TEST(FewBodySystem, LooksAtAStateOnceUntilItsLinksChange) {
  const MovingScene scene = moving_scene(resolved(scenes[4]));
  FewBodySystem system(
      scene.bodies, [&](int i, int j) { return scene.between(i, j); }, 0);
  FewBodySystem::State y = system.start(), rate = y;
  std::vector<FewBodySystem::Change> changes;
  ASSERT_TRUE(system.fly(y, changes));
  rate = y;
  system(y, rate, 0);
  const FewBodySystem::State first = rate;
  const long looked = system.force_evaluations();
  system(y, rate, 0);
  EXPECT_EQ(system.force_evaluations(), looked);
  EXPECT_EQ(rate, first);
  (void)system.apply(static_cast<std::size_t>(LinkEvent::turn), y);
  system(y, rate, 0);
  EXPECT_EQ(system.force_evaluations(), looked + 1);
  y[0] += 1e-9;
  system(y, rate, 0);
  EXPECT_EQ(system.force_evaluations(), looked + 2);
}

}  // namespace
}  // namespace scalebreak::tests

#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/run/run_schedule.hpp>

namespace scalebreak {
namespace {

TEST(RunSchedule, RowsFallOnWholeStepsAndTheStepIsAtMostTheAllowedOne) {
  for (const double step : {1e-7, 3.3e-7, 0.99e-5, 1e-5, 2.7e-4}) {
    for (const double interval : {1e-3, 2.5e-4, 7e-3}) {
      const RunSchedule s = run_schedule({.warmup = 0.05, .duration = 0.1, .interval = interval}, step);
      EXPECT_LE(s.step, step * (1 + 1e-9));
      EXPECT_GT(s.step, 0.4 * std::min(step, interval)) << step << ' ' << interval;
      EXPECT_LE(s.steps_per_sample, 100);
      EXPECT_NEAR(s.time_of(s.samples_per_row), interval, 1e-12 * interval);
      EXPECT_NEAR(s.time_of(s.warmup_samples), 0.05, 0.5 * s.sample_interval() * (1 + 1e-9));
      const double measured = s.time_of(s.samples) - s.time_of(s.warmup_samples);
      EXPECT_GE(measured, 0.1 * (1 - 1e-9));
      EXPECT_LT(measured, 0.1 + s.sample_interval());
      EXPECT_EQ(s.steps(), s.samples * s.steps_per_sample);
    }
  }
}

TEST(RunSchedule, MeasuresAtLeastOnceInAShortRun) {
  const RunSchedule s = run_schedule({.warmup = 0, .duration = 1e-6, .interval = 1}, 1e-3);
  EXPECT_EQ(s.warmup_samples, 0);
  EXPECT_EQ(s.samples, 1);
  EXPECT_NEAR(s.time_of(1), 1e-6, 1e-18);
}

TEST(RunSchedule, RefusesMoreStepsThanCanBeCounted) {
  EXPECT_THROW((void)run_schedule({.warmup = 0, .duration = 1e10, .interval = 1}, 1e-7), InputError);
}

}  // namespace
}  // namespace scalebreak

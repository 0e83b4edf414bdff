#include <scalebreak/ensembles/run/run_schedule.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

constexpr double most_steps = 1e15;
constexpr double rounding = 1e-9;  ///< of a whole number of samples

}  // namespace

RunSchedule run_schedule(const RunTimes& times, double largest_step) {
  if (const double steps = (times.warmup + times.duration) / largest_step; !(steps < most_steps))
    throw InputError(
        fmt::format("run.duration: found {:g} s with a warm-up of {:g} s, which is {:.3g} steps of {:.3g} s; allowed: at most {:g}",
                    times.duration, times.warmup, steps, largest_step, most_steps));
  const double interval = std::min(times.interval, times.warmup + times.duration);
  RunSchedule schedule;
  schedule.samples_per_row = std::max(1L, std::lround(std::ceil(interval / (most_steps_per_sample * largest_step))));
  const double sample = interval / static_cast<double>(schedule.samples_per_row);
  schedule.steps_per_sample = std::max(1L, std::lround(std::ceil(sample / largest_step * (1 - rounding))));
  schedule.step = sample / static_cast<double>(schedule.steps_per_sample);
  schedule.warmup_samples = std::lround(times.warmup / sample);
  schedule.samples = schedule.warmup_samples + std::max(1L, std::lround(std::ceil(times.duration / sample * (1 - rounding))));
  return schedule;
}

}  // namespace scalebreak

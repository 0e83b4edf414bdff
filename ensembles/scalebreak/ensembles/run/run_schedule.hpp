#pragma once

#include <scalebreak/scene/flow_scene.hpp>

namespace scalebreak {

inline constexpr double most_steps_per_sample = 100;

/// When a run is sampled, in whole steps, of which an event-driven engine makes no other use: rows of the series at every interval exactly, samples of the measurement between them.
struct RunSchedule {
  double step = 0;            ///< [s], at most the one that was allowed
  long steps_per_sample = 0;  ///< at most 100
  long samples_per_row = 0;
  long warmup_samples = 0;  ///< the first of the measurement is the one with this number, from 0
  long samples = 0;         ///< the last one's number

  bool operator==(const RunSchedule&) const = default;

  [[nodiscard]] double sample_interval() const { return static_cast<double>(steps_per_sample) * step; }  ///< [s]
  [[nodiscard]] double time_of(long sample) const { return static_cast<double>(sample * steps_per_sample) * step; }
  [[nodiscard]] long steps() const { return samples * steps_per_sample; }
};

/// The schedule of a run whose step is at most `largest_step` [s]. The interval between rows is kept, so the step is made a little
/// smaller; warm-up and duration are rounded to whole samples, the duration up. Throws InputError for more than 1e15 steps.
[[nodiscard]] RunSchedule run_schedule(const RunTimes& times, double largest_step);

}  // namespace scalebreak

#include <scalebreak/ensembles/event/queue/calendar_queue.hpp>

#include <algorithm>
#include <cmath>

namespace scalebreak {

void CalendarQueue::reset(std::size_t spheres) {
  entry_.assign(spheres, {});
  day_.clear();
  today_.clear();
  now_ = 0;
  operations_ = 0;
}

void CalendarQueue::begin_day() {
  ++now_;
  for (std::uint32_t sphere = day_[now_]; sphere != none; sphere = entry_[sphere].next) push_today({entry_[sphere].time, sphere});
}

void CalendarQueue::make_calendar() {
  times_.clear();
  for (const Entry& entry : entry_) {
    if (std::isfinite(entry.time)) times_.push_back(entry.time);
  }
  operations_ += entry_.size();
  day_.clear();
  now_ = 0;
  if (times_.empty()) return;
  const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() / 2);
  std::nth_element(times_.begin(), middle, times_.end());
  first_ = *std::min_element(times_.begin(), middle + 1);
  const double half = std::max(*middle - first_, std::abs(first_) * 1e-12 + std::numeric_limits<double>::min());
  // Half of the events now known lie in `half`; those to come make up for the ones that are used up.
  days_per_time_ = static_cast<double>(times_.size()) / (2 * events_a_day * half);
  day_.assign(times_.size() + 1, none);
  for (std::uint32_t sphere = 0; sphere < entry_.size(); ++sphere) {
    const std::size_t day = day_of(entry_[sphere].time);
    if (day == 0) push_today({entry_[sphere].time, sphere});
    if (day > 0 && day < day_.size()) link(day, sphere);
  }
}

}  // namespace scalebreak

#pragma once

#include <limits>
#include <vector>

#include <scalebreak/base/large_list.hpp>
#include <scalebreak/ensembles/event/queue/event_queue.hpp>

namespace scalebreak {

/// A calendar: days of equal length, each an unsorted list but today's, which is a heap. Events beyond the last day wait in no list.
/// After the last day a new calendar is made, its days cut so that about `events_a_day` fall into one (after Paul, J. Comput. Phys.
/// 221, 615 (2007)). Entries of today's heap whose sphere has been given another event are left there and passed over.
class CalendarQueue {
 public:
  void reset(std::size_t spheres);
  void schedule(std::uint32_t sphere, double time);
  [[nodiscard]] Due next();
  [[nodiscard]] double time_of(std::uint32_t sphere) const { return entry_[sphere].time; }
  [[nodiscard]] std::uint64_t operations() const { return operations_; }

  /// Spheres that are likely to be due soon, to be fetched ahead of their events.
  template <class Visit>
  void for_each_soon(Visit&& visit) const {
    for (std::size_t k = 1; k < 7 && k < today_.size(); ++k) visit(today_[k].sphere);
    if (today_.size() > 3 || now_ + 1 >= day_.size()) return;
    std::uint32_t sphere = day_[now_ + 1];
    for (int k = 0; k < 3 && sphere != none; ++k, sphere = entry_[sphere].next) visit(sphere);
  }

 private:
  static constexpr double events_a_day = 4;
  static constexpr std::uint32_t none = 0xffffffff;

  /// A sphere's event, in its day's list.
  struct Entry {
    double time = std::numeric_limits<double>::infinity();
    std::uint32_t next = none, previous = none;
  };

  [[nodiscard]] std::size_t day_of(double time) const {
    const double day = (time - first_) * days_per_time_;
    return day < static_cast<double>(day_.size()) ? static_cast<std::size_t>(day > 0 ? day : 0) : day_.size();
  }
  void link(std::size_t day, std::uint32_t sphere);
  void unlink(std::size_t day, std::uint32_t sphere);
  void push_today(Due due);
  void pop_today();
  /// Puts the next day's list into the heap.
  void begin_day();
  void make_calendar();

  LargeList<Entry> entry_;
  LargeList<std::uint32_t> day_;  ///< first of each day's list
  std::vector<Due> today_;        ///< heap, the earliest on top
  std::vector<double> times_;     ///< space for make_calendar
  double first_ = 0, days_per_time_ = 0;
  std::size_t now_ = 0;  ///< today; day_.size(): there is no calendar
  std::uint64_t operations_ = 0;
};

static_assert(EventQueue<CalendarQueue>);

inline void CalendarQueue::link(std::size_t day, std::uint32_t sphere) {
  Entry& entry = entry_[sphere];
  entry.previous = none;
  entry.next = day_[day];
  if (entry.next != none) entry_[entry.next].previous = sphere;
  day_[day] = sphere;
}

inline void CalendarQueue::unlink(std::size_t day, std::uint32_t sphere) {
  const Entry& entry = entry_[sphere];
  (entry.previous == none ? day_[day] : entry_[entry.previous].next) = entry.next;
  if (entry.next != none) entry_[entry.next].previous = entry.previous;
}

inline void CalendarQueue::push_today(Due due) {
  std::size_t place = today_.size();
  today_.push_back(due);
  for (++operations_; place > 0; ++operations_) {
    const std::size_t above = (place - 1) / 2;
    if (!(due < today_[above])) break;
    today_[place] = today_[above];
    place = above;
  }
  today_[place] = due;
}

inline void CalendarQueue::pop_today() {
  const Due last = today_.back();
  today_.pop_back();
  ++operations_;
  if (today_.empty()) return;
  std::size_t place = 0;
  for (std::size_t below = 1; below < today_.size(); below = 2 * place + 1, ++operations_) {
    if (below + 1 < today_.size() && today_[below + 1] < today_[below]) ++below;
    if (!(today_[below] < last)) break;
    today_[place] = today_[below];
    place = below;
  }
  today_[place] = last;
}

inline void CalendarQueue::schedule(std::uint32_t sphere, double time) {
  Entry& entry = entry_[sphere];
  ++operations_;
  if (now_ == day_.size()) {
    entry.time = time;
    return;
  }
  const std::size_t before = day_of(entry.time), after = day_of(time);
  if (before > now_ && before < day_.size()) unlink(before, sphere);
  entry.time = time;
  if (after <= now_) {
    push_today({time, sphere});
  } else if (after < day_.size()) {
    link(after, sphere);
  }
}

inline Due CalendarQueue::next() {
  while (true) {
    while (!today_.empty()) {
      const Due& first = today_.front();
      if (entry_[first.sphere].time == first.time) return first;
      pop_today();
    }
    if (now_ + 1 < day_.size()) {
      begin_day();
    } else {
      make_calendar();
      if (day_.empty()) return {std::numeric_limits<double>::infinity(), 0};
    }
  }
}

}  // namespace scalebreak

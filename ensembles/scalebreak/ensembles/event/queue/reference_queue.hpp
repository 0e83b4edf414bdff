#pragma once

#include <limits>
#include <set>
#include <vector>

#include <scalebreak/ensembles/event/queue/event_queue.hpp>

namespace scalebreak {

/// The slow and plain queue beside which the fast one is tested: a sorted tree.
class ReferenceQueue {
 public:
  void reset(std::size_t spheres) {
    due_.clear();
    time_.assign(spheres, std::numeric_limits<double>::infinity());
    for (std::uint32_t i = 0; i < spheres; ++i) due_.insert({time_[i], i});
    operations_ = 0;
  }
  void schedule(std::uint32_t sphere, double time) {
    due_.erase({time_[sphere], sphere});
    due_.insert({time, sphere});
    time_[sphere] = time;
    ++operations_;
  }
  [[nodiscard]] Due next() const { return *due_.begin(); }
  [[nodiscard]] double time_of(std::uint32_t sphere) const { return time_[sphere]; }
  [[nodiscard]] std::uint64_t operations() const { return operations_; }

 private:
  std::set<Due> due_;
  std::vector<double> time_;
  std::uint64_t operations_ = 0;
};

static_assert(EventQueue<ReferenceQueue>);

}  // namespace scalebreak

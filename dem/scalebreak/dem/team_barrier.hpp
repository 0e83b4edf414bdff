#pragma once

#include <atomic>

namespace scalebreak::dem {

/// Where the threads of a team wait for each other. They wait awake for some tens of microseconds, as steps are that short, and then asleep,
/// so that more threads than cores do not keep each other from working. OpenMP's own barrier calls the system each time.
class TeamBarrier {
 public:
  explicit TeamBarrier(int threads) : threads_(threads), missing_(threads) {}

  /// The last thread to come does `work`, which must not throw, before all go on.
  template <class Work>
  void wait(Work work) {
    const unsigned round = round_.load(std::memory_order_relaxed);
    if (missing_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
      work();
      missing_.store(threads_, std::memory_order_relaxed);
      round_.fetch_add(1, std::memory_order_release);
      round_.notify_all();
      return;
    }
    constexpr int looks = 2000;
    for (int look = 0; look < looks; ++look) {
      if (round_.load(std::memory_order_acquire) != round) return;
      __builtin_ia32_pause();
    }
    round_.wait(round, std::memory_order_acquire);
  }
  void wait() {
    wait([] {});
  }

 private:
  const int threads_;
  alignas(64) std::atomic<int> missing_;
  alignas(64) std::atomic<unsigned> round_{0};
};

}  // namespace scalebreak::dem

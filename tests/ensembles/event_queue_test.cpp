#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <scalebreak/base/random_draws.hpp>
#include <scalebreak/ensembles/event/queue/calendar_queue.hpp>
#include <scalebreak/ensembles/event/queue/reference_queue.hpp>

namespace scalebreak {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

template <class Queue>
class EventQueueTest : public testing::Test {
 protected:
  Queue queue_;
};
using Queues = testing::Types<CalendarQueue, ReferenceQueue>;
TYPED_TEST_SUITE(EventQueueTest, Queues);

TYPED_TEST(EventQueueTest, GivesTheEarliestAndOfEqualOnesTheFirstSphere) {
  auto& queue = this->queue_;
  queue.reset(4);
  queue.schedule(0, 3.0);
  queue.schedule(1, 1.0);
  queue.schedule(2, 1.0);
  queue.schedule(3, 2.0);
  EXPECT_EQ(queue.next(), (Due{1.0, 1}));
  queue.schedule(1, 1.0);
  EXPECT_EQ(queue.next(), (Due{1.0, 1}));
  queue.schedule(1, 5.0);
  EXPECT_EQ(queue.next(), (Due{1.0, 2}));
  queue.schedule(2, forever);
  EXPECT_EQ(queue.next(), (Due{2.0, 3}));
}

TYPED_TEST(EventQueueTest, HasNothingDueWhereAllIsForEver) {
  auto& queue = this->queue_;
  queue.reset(3);
  EXPECT_EQ(queue.next().time, forever);
  queue.schedule(2, 7.0);
  EXPECT_EQ(queue.next(), (Due{7.0, 2}));
  queue.schedule(2, forever);
  EXPECT_EQ(queue.next().time, forever);
}

TYPED_TEST(EventQueueTest, TakesAnEventOfAnotherSphereBeforeTheOneThatWasNext) {
  auto& queue = this->queue_;
  queue.reset(100);
  for (std::uint32_t i = 0; i < 100; ++i) queue.schedule(i, 10.0 + i);
  EXPECT_EQ(queue.next(), (Due{10.0, 0}));
  queue.schedule(50, 9.5);
  EXPECT_EQ(queue.next(), (Due{9.5, 50}));
}

/// Waits over twelve orders of magnitude, many of them equal, some infinite, and a spread that shrinks and grows.
TEST(EventQueues, AgreeOverAnyTimes) {
  constexpr std::uint32_t spheres = 300;
  CalendarQueue fast;
  ReferenceQueue plain;
  std::mt19937_64 random = random_stream(3, 1, 0);
  const auto wait = [&](int step) {
    const double kind = uniform(random), scale = std::pow(10.0, step / 2000 % 5 - 2);
    if (kind < 0.05) return 0.0;
    if (kind < 0.1) return scale;
    if (kind < 0.12) return forever;
    if (kind < 0.2) return scale * std::pow(10.0, 12 * uniform(random) - 8);
    return scale * uniform(random);
  };
  fast.reset(spheres), plain.reset(spheres);
  for (std::uint32_t i = 0; i < spheres; ++i) {
    const double time = wait(0);
    fast.schedule(i, time), plain.schedule(i, time);
  }
  for (int step = 0; step < 40'000; ++step) {
    const Due due = plain.next();
    ASSERT_EQ(fast.next(), due) << step;
    const double now = due.time == forever ? 0 : due.time;
    for (const std::uint32_t i : {due.sphere, static_cast<std::uint32_t>(uniform(random) * spheres)}) {
      const double time = now + wait(step);
      fast.schedule(i, time), plain.schedule(i, time);
    }
    if (due.time == forever) {
      fast.reset(spheres), plain.reset(spheres);
      fast.schedule(7, 1.0), plain.schedule(7, 1.0);
    }
  }
}

}  // namespace
}  // namespace scalebreak

#include <atomic>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <omp.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/team_barrier.hpp>

#include "dem/flows.hpp"
#include "dem/scenes.hpp"

namespace scalebreak {
namespace {

TEST(TeamBarrier, NoOneGoesOnBeforeAllHaveComeAndTheLastHasDoneTheWork) {
  // More threads than cores, so that some fall asleep.
  constexpr int threads = 7, rounds = 200;
  dem::TeamBarrier all(threads);
  int work = 0;  // by the last, seen by all
  std::atomic<int> come = 0, wrong = 0;
  std::vector<std::thread> team;
  for (int t = 0; t < threads; ++t) {
    team.emplace_back([&] {
      for (int round = 1; round <= rounds; ++round) {
        ++come;
        all.wait([&] { work = come; });
        if (work != threads * round) ++wrong;
        all.wait();
      }
    });
  }
  for (std::thread& each : team) each.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(work, threads * rounds);
}

TEST(Threads, ThatTheSystemDoesNotGrantEndTheRun) {
  DemSetup setup = test::rough(1e7, 0.8, 0.15, 0.5e-3);
  setup.threads = 2;
  Dem dem(test::filled(100, 0.3, {0.5e-3}, 0.1, 0, Boundary::periodic), setup);
  const int levels = omp_get_max_active_levels();
  omp_set_max_active_levels(1);
  std::string said;
#pragma omp parallel num_threads(2)
  {
#pragma omp single
    try {
      dem.advance(1);
    } catch (const WorkError& error) {
      said = error.what();
    }
  }
  omp_set_max_active_levels(levels);
  EXPECT_THAT(said, testing::StartsWith("the system grants 1 of 2 threads"));
}

}  // namespace
}  // namespace scalebreak

#include <algorithm>
#include <set>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>

#include "dem/flows.hpp"

// What many spheres need beside laws: no contact is missed, none is lost, and the bits are kept.

namespace scalebreak {
namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

/// The pairs that overlap, each with each.
std::set<Pair> overlapping(const System& system) {
  std::set<Pair> pairs;
  const auto n = static_cast<std::int32_t>(system.count());
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = i + 1; j < n; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const double distance = nearest_image(system.cell, system.position[b] - system.position[a]).norm();
      if (distance < system.radius[a] + system.radius[b]) pairs.insert({i, j});
    }
    for (const int axis : {0, 1, 2}) {
      const auto a = static_cast<std::size_t>(i);
      if (!system.cell.walled(axis)) continue;
      if (system.position[a][axis] < system.radius[a]) pairs.insert({i, -1 - 2 * axis});
      if (system.cell.size[axis] - system.position[a][axis] < system.radius[a]) pairs.insert({i, -2 - 2 * axis});
    }
  }
  return pairs;
}

std::set<Pair> told_of(const Dem& dem) {
  std::set<Pair> pairs;
  for (const ContactForce& contact : dem.contact_forces())
    pairs.insert(contact.second < 0 ? Pair(contact.first, contact.second) : Pair(std::minmax(contact.first, contact.second)));
  return pairs;
}

void expect_every_contact(const System& start, DemSetup setup, int looks, long steps) {
  for (const int threads : {1, 2}) {
    setup.threads = threads;
    Dem dem(start, setup);
    std::size_t contacts = 0;
    for (int look = 0; look < looks; ++look) {
      dem.advance(steps);
      const auto pairs = told_of(dem);
      contacts += pairs.size();
      ASSERT_EQ(pairs, overlapping(dem.system())) << "after " << dem.steps() << " steps on " << threads << " threads";
    }
    EXPECT_GT(contacts, 100u);
    EXPECT_GT(dem.totals().grids_made, 2);
  }
}

TEST(NearPairs, MissNoContactOfAGas) {
  expect_every_contact(test::filled(400, 0.4, {0.5e-3}, 0.3), test::smooth(1e7, 0.9, 0.15, 0.5e-3), 60, 37);
}

TEST(NearPairs, MissNoContactUnderShear) {
  expect_every_contact(test::filled(400, 0.45, {0.5e-3}, 0.1, 200), test::rough(1e7, 0.7, 0.15, 0.5e-3), 60, 53);
}

TEST(NearPairs, MissNoContactAsTheHeightFallsAndRises) {
  for (const double pressure : {5.0, 5e3}) {
    DemSetup setup = test::rough(1e7, 0.7, 0.15, 0.5e-3);
    setup.pressure = pressure;
    expect_every_contact(test::filled(400, 0.45, {0.5e-3}, 0.2, 200), setup, 60, 53);
  }
}

TEST(NearPairs, MissNoContactOfSpheresTenTimesLarger) {
  std::vector<double> radii(200, 0.1e-3);
  radii[0] = radii[100] = 1e-3;
  expect_every_contact(test::filled(800, 0.4, radii, 0.1, 100), test::rough(1e7, 0.8, 0.15, 0.1e-3), 40, 40);
}

TEST(NearPairs, MissNoContactBetweenWalls) {
  System start = test::filled(300, 0.3, {0.5e-3, 0.4e-3}, 0.1, 0, Boundary::wall);
  start.cell.wall_speed = 1;
  expect_every_contact(start, test::rough(1e7, 0.8, 0.15, 0.4e-3), 60, 40);
}

/// Radii that are all different: each contact has laws of its own.
System manifold() {
  std::vector<double> radii;
  for (int k = 0; k < 97; ++k) radii.push_back((0.3 + 0.005 * k) * 1e-3);
  return test::filled(300, 0.45, radii, 0.2, 100);
}

TEST(NearPairs, MissNoContactWhereEachSphereHasItsOwnSize) { expect_every_contact(manifold(), test::rough(1e7, 0.8, 0.1, 0.3e-3), 40, 40); }

TEST(NearPairs, GiveTheSameFlowWhicheverWayItIsCut) {
  for (const auto& [each, integrator] : {std::pair(false, Integrator::verlet), std::pair(true, Integrator::verlet),
                                         std::pair(false, Integrator::synchronized), std::pair(true, Integrator::synchronized)}) {
    const System start = each ? manifold() : test::filled(300, 0.45, {0.5e-3, 0.3e-3}, 0.2, 100);
    DemSetup setup = test::rough(1e7, 0.8, 0.1, 0.3e-3);
    setup.integrator = integrator;
    setup.gravity = {10, 0, -20};  // so that what is not pushed is seen to fall
    Dem one(start, setup);
    setup.threads = 2;
    Dem two(start, setup);
    setup.threads = 1, setup.kernel = "baseline";
    Dem plain(start, setup);
    for (Dem* dem : {&one, &two, &plain}) dem->advance(300);
    const System a = one.system(), b = two.system(), c = plain.system();
    for (std::size_t i = 0; i < a.count(); ++i) {
      EXPECT_LT((a.velocity[i] - b.velocity[i]).norm(), 1e-9);
      EXPECT_LT((a.spin[i] - c.spin[i]).norm() * a.radius[i], 1e-9);
      EXPECT_LT((a.velocity[i] - c.velocity[i]).norm(), 1e-9);
    }
    EXPECT_GT(one.totals().contact_starts, 100);
    EXPECT_EQ(one.totals().contact_starts, two.totals().contact_starts);
  }
}

TEST(SavedState, GoesOnBitForBit) {
  for (const int threads : {1, 2}) {
    for (const bool each : {false, true}) {
      const System start = each ? manifold() : test::filled(300, 0.45, {0.5e-3, 0.3e-3}, 0.2, 100);
      DemSetup setup = test::rough(1e7, 0.8, 0.1, 0.3e-3);
      setup.threads = threads;
      setup.integrator = each ? Integrator::synchronized : Integrator::verlet;
      Dem straight(start, setup);
      straight.advance(137);
      Dem resumed(straight.save(), setup);
      straight.advance(400);
      resumed.advance(400);
      const System a = straight.system(), b = resumed.system();
      for (std::size_t i = 0; i < a.count(); ++i) {
        ASSERT_EQ(a.position[i], b.position[i]);
        ASSERT_EQ(a.velocity[i], b.velocity[i]);
        ASSERT_EQ(a.spin[i], b.spin[i]);
      }
      EXPECT_EQ(straight.totals().contact_starts, resumed.totals().contact_starts);
      EXPECT_EQ(straight.totals().contact_moment, resumed.totals().contact_moment);
    }
  }
}

TEST(SavedState, OfOtherThreadsIsRefused) {
  DemSetup setup = test::smooth(1e7, 0.8, 0.1, 0.5e-3);
  const std::string saved = Dem(test::filled(100, 0.2, {0.5e-3}, 0.2), setup).save();
  setup.threads = 2;
  EXPECT_THAT([&] { Dem(saved, setup); },
              testing::ThrowsMessage<InputError>(
                  "the saved state is of 1 threads, found 2; allowed: the same number, so that the run goes on bit for bit"));
  EXPECT_THAT([&] { Dem(std::string_view(saved).substr(0, saved.size() / 2), test::smooth(1e7, 0.8, 0.1, 0.5e-3)); },
              testing::ThrowsMessage<WorkError>(testing::HasSubstr("cut short")));
}

TEST(UnstableRun, StopsWithASentence) {
  const System start = test::filled(100, 0.4, {0.5e-3}, 1);
  Dem dem(start, test::smooth(1e6, 1, 4, 0.5e-3));
  EXPECT_THAT([&] { dem.advance(100'000); }, testing::ThrowsMessage<WorkError>(testing::StartsWith("the run became unstable at t = ")));
}

TEST(NarrowCell, IsRefused) {
  System start = test::filled(2, 0.1, {0.5e-3}, 0.1);
  start.cell.size.x() = 1.9e-3;
  EXPECT_THAT([&] { Dem(start, test::smooth(1e7, 0.8, 0.1, 0.5e-3)); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("along its periodic axis x; allowed: above 0.002 m")));
}

}  // namespace
}  // namespace scalebreak

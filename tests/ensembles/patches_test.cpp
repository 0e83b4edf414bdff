#include <fmt/format.h>
#include <gmock/gmock.h>

#include <ensembles/clusters.hpp>
#include <ensembles/flows.hpp>

// The hybrid beside the exact engine of few bodies: what a collision of two is, and what is not.

namespace scalebreak::tests {
namespace {

using Eigen::Vector3d;

TableStore store() {
  static const TemporaryFolder folder;
  return {.folder = folder.path()};
}

/// The first of a row hits the second, and that one the third at a gap.
System row(double gap, double speed) {
  const Vector3d first(0.01, 0.02, 0.02), along = Vector3d(1, 0.02, 0).normalized();
  return spheres_at({first, first + (2 * radius + 1e-4) * Vector3d::UnitX(),
                     first + (2 * radius + 1e-4) * Vector3d::UnitX() + (2 * radius + gap) * along},
                    {speed * Vector3d::UnitX(), Vector3d::Zero(), Vector3d::Zero()});
}

TEST(Patches, OfARowComeOutAsTheExactEngineHasIt) {
  const double speed = 0.3, time = 0.05 * radius / speed + 1e-4 / speed + 2e-4;
  for (const char* contact : {"normal = \"hertz\"\ntangential = \"none\"", "normal = \"hertz\"\ntangential = \"mindlin\""}) {
    const Input input = flow_of(contact);
    for (const double gap : {0.0, 1e-8, 3e-7, 1e-6, 3e-6, 1e-5}) {
      const System start = row(gap, speed);
      const auto bodies = exactly(start, input, time);
      Hybrid hybrid(start, input, store());
      hybrid.flow.advance_to(time);
      const EventTotals& totals = hybrid.flow.totals();
      EXPECT_LT(deviation(hybrid.flow.system(), bodies, speed), 3e-3)
          << gap << ' ' << totals.collisions << ' ' << totals.patches << ' ' << totals.taken_back << ' ' << totals.patch_starts;
      EXPECT_EQ(static_cast<double>(totals.collisions) + totals.patch_starts, 2) << gap;
    }
  }
}

/// Quantiles of the deviations of many clusters: the median, nine in ten, the most.
struct Quantiles {
  double median, most_of_them, most;
  explicit Quantiles(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    median = values[values.size() / 2], most_of_them = values[values.size() * 9 / 10], most = values.back();
  }
};

struct Deviations {
  std::vector<double> hybrid, fine, binary;
};

Deviations deviations_of_clusters(const Input& input, unsigned seeds) {
  Deviations found;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const EngineErrors errors = errors_of(cluster(seed, spheres_of(seed)), input, store());
    EXPECT_LT(errors.momentum, 1e-12);
    found.hybrid.push_back(errors.hybrid), found.fine.push_back(errors.hybrid_fine), found.binary.push_back(errors.event);
  }
  return found;
}

TEST(Patches, OfClustersComeOutAsTheExactEngineHasItTheBetterTheSmallerTheirStep) {
  const Deviations found = deviations_of_clusters(flow_of("normal = \"hertz\"\ntangential = \"mindlin\"", 1e8), 60);
  const Quantiles hybrid(found.hybrid), fine(found.fine), binary(found.binary);
  const auto say = [](const char* name, const Quantiles& q) {
    return fmt::format("{}: {:.1e}, {:.1e}, {:.1e}; ", name, q.median, q.most_of_them, q.most);
  };
  const std::string all = say("step 0.15", hybrid) + say("0.02", fine) + say("two at a time", binary);
  testing::Test::RecordProperty("deviations", all);
  EXPECT_LT(hybrid.median, 0.01) << all;
  EXPECT_LT(hybrid.most_of_them, 0.05) << all;
  EXPECT_LT(fine.median, 1e-3) << all;
  EXPECT_LT(fine.most_of_them, 4e-3) << all;
  EXPECT_GT(binary.most_of_them, 10 * fine.most_of_them) << all;  // where a collision of two at a time is not it
}

/// Spheres that fall into a box and come to rest on its floor and on each other.
TEST(Patches, OfSpheresThatComeToRestKeepTheirEnergyAccount) {
  Input input = flow_of("normal = \"hertz\"\ntangential = \"mindlin\"", 1e7);
  input.material.restitution = 0.5;
  input.cell.gravity = {0, 0, -9.81};
  input.cell.boundary[2] = Boundary::wall;
  System start = spheres_at({}, {});
  for (int k = 0; k < 12; ++k) {
    start.position.push_back(Vector3d(0.02 + 1.5 * radius * (k % 2), 0.02 + 0.4 * radius * (k % 3), (2 + 2.4 * k) * radius));
    start.velocity.push_back(Vector3d(0.01 * (k % 5), 0, 0));
  }
  start = spheres_at(start.position, start.velocity);
  start.cell.boundary[2] = Boundary::wall;
  Hybrid hybrid(start, input, store());
  const auto energy = [&](const System& s) {
    double sum = 0;
    for (std::size_t i = 0; i < s.count(); ++i)
      sum += s.mass[i] * (s.velocity[i].squaredNorm() / 2 + 9.81 * s.position[i].z()) + 0.5 * s.inertia(i) * s.spin[i].squaredNorm();
    return sum;
  };
  const double before = energy(start);
  for (const double time : {0.02, 0.05, 0.1, 0.3}) {
    hybrid.flow.advance_to(time);
    hybrid.flow.open_contacts();
    const double now = energy(hybrid.flow.system()) + hybrid.flow.elastic_energy() + hybrid.flow.totals().dissipated;
    EXPECT_NEAR(now / before, 1, 2e-3) << time;
  }
  EXPECT_GT(hybrid.flow.patched(), 3u);
  EXPECT_GT(hybrid.flow.totals().dissipated, 0.3 * before);
}

/// Pairs that touch and come together, in a row of these gaps.
System row_of_pairs(const std::vector<double>& speeds, const std::vector<double>& gaps) {
  constexpr double overlap = 1e-9;
  std::vector<Vector3d> positions, velocities;
  double x = 0.01;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    if (k > 0) x += 2 * radius + gaps[k - 1];
    positions.emplace_back(x, edge / 2, edge / 2), velocities.push_back(speeds[k] / 2 * Vector3d::UnitX());
    x += 2 * radius - overlap;
    positions.emplace_back(x, edge / 2, edge / 2), velocities.push_back(-speeds[k] / 2 * Vector3d::UnitX());
  }
  System system = spheres_at(positions, velocities);
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(speeds.size()); ++k)
    system.contacts.push_back({.first = 2 * k, .second = 2 * k + 1});
  return system;
}

// All at one instant: the second pair reaches the first, whose haste makes the stretch so short that they part again; the third reaches the second,
// and together they could go on as long as before, reach the first again, and so on.
TEST(Patches, ThatPartAtOneInstantDoNotMeetAgainInIt) {
  const Input input = flow_of("normal = \"hertz\"\ntangential = \"none\"");
  const double fast = 1, slow = 0.05, time = 1e-4;
  const double longest = 32 * groups_setup(input).step, shortest = longest / 8;
  // What a pair may do in a stretch is its speed times that.
  const double reached_by_long = slow * longest + fast * shortest, reached_by_short = (slow + fast) * shortest;
  const System start = row_of_pairs({fast, slow, slow}, {(reached_by_long + reached_by_short) / 2, 0.8 * slow * longest});
  Hybrid hybrid(start, input, store());
  EXPECT_EQ(hybrid.flow.patched(), 6u);
  EXPECT_EQ(hybrid.flow.totals().patches, 3 + 2);  // those that were handed over, and two meetings
  hybrid.flow.advance_to(time);
  EXPECT_EQ(hybrid.flow.patched(), 0u);
  EXPECT_LT(deviation(hybrid.flow.system(), exactly(start, input, time), fast), 1e-3);
}

TEST(Patches, OfSpheresThatStickStayTogether) {
  const Input input = flow_of("normal = \"jkr\"\ntangential = \"none\"");
  const Vector3d first = Vector3d::Constant(0.02);
  const System start = spheres_at({first, first + (2 * radius + 1e-6) * Vector3d::UnitX()}, {1e-3 * Vector3d::UnitX(), Vector3d::Zero()});
  Hybrid hybrid(start, input, store());
  hybrid.flow.advance_to(0.05);
  EXPECT_EQ(hybrid.flow.patched(), 2u);
  const System end = hybrid.flow.system();
  ASSERT_EQ(end.contacts.size(), 1u);
  EXPECT_NEAR((end.velocity[0] - end.velocity[1]).norm(), 0, 1e-5);
  EXPECT_NEAR((end.velocity[0] + end.velocity[1]).x(), 1e-3, 1e-15);
}

}  // namespace
}  // namespace scalebreak::tests

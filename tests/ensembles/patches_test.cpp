#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include <ensembles/flows.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>

// The hybrid beside the exact engine of few bodies: what a collision of two is, and what is not.

namespace scalebreak::tests {
namespace {

using Eigen::Vector3d;
using Spheres = EventSpheres<CalendarQueue, TableRule>;
constexpr double radius = 0.5e-3, edge = 0.04;

TableStore store() {
  static const TemporaryFolder folder;
  return {.folder = folder.path()};
}

Input flow_of(const std::string& contact, double young = 1e9) {
  return resolved(
      fmt::format("[material]\nyoung = {:g}\n[contact]\n{}\n[particles]\ncount = 3\n[cell]\nkind = \"cooling\"\n"
                  "size = [{}, {}, {}]\n",
                  young, contact, edge, edge, edge));
}

System spheres_at(const std::vector<Vector3d>& positions, const std::vector<Vector3d>& velocities) {
  System system;
  system.cell.size = Vector3d::Constant(edge);
  system.position = positions, system.velocity = velocities;
  system.radius.assign(positions.size(), radius);
  system.mass.assign(positions.size(), sphere_mass(radius, 2500));
  system.material.assign(positions.size(), 0);
  system.spin.assign(positions.size(), Vector3d::Zero());
  return system;
}

DemSetup groups_setup(const Input& input, double fraction = 0.15) {
  DemSetup setup = dem_setup(input, 1, 1);
  setup.step = fraction * rayleigh_step(setup, radius);
  return setup;
}

struct Hybrid {
  GroupLaws laws;
  Spheres flow;
  Hybrid(const System& start, const Input& input, double fraction = 0.15)
      : laws(groups_setup(input, fraction), start.cell, {{radius, 0}}),
        flow(start, {.gravity = input.cell.gravity, .groups = &laws},
             TableRule(input, kinds_of(start), store(), {.turning = 1e-3}, Unanswered::leave)) {}
};

std::vector<MovingBody> exactly(const System& start, const Input& input, double time) {
  Input scene = input;
  scene.flow = false;
  for (std::size_t i = 0; i < start.count(); ++i)
    scene.bodies.push_back({.position = start.position[i], .velocity = start.velocity[i], .spin = start.spin[i], .radius = radius});
  return moving_scene(scene).move({.tolerance = 1e-9, .duration = time}).bodies;
}

/// Largest difference of velocities, over `speed`.
double deviation(const System& end, const std::vector<MovingBody>& bodies, double speed) {
  double most = 0;
  for (std::size_t i = 0; i < end.count(); ++i) most = std::max(most, (end.velocity[i] - bodies[i].velocity).norm() / speed);
  return most;
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
      Hybrid hybrid(start, input);
      hybrid.flow.advance_to(time);
      const EventTotals& totals = hybrid.flow.totals();
      EXPECT_LT(deviation(hybrid.flow.system(), bodies, speed), 3e-3)
          << gap << ' ' << totals.collisions << ' ' << totals.patches << ' ' << totals.taken_back << ' ' << totals.patch_starts;
      EXPECT_EQ(static_cast<double>(totals.collisions) + totals.patch_starts, 2) << gap;
    }
  }
}

/// Some spheres about the middle that fall together at random.
System cluster(std::mt19937& random, int count, double speed) {
  std::uniform_real_distribution<double> even(-1, 1);
  const auto vector = [&] { return Vector3d(even(random), even(random), even(random)); };
  std::vector<Vector3d> positions, velocities;
  const Vector3d middle = Vector3d::Constant(edge / 2);
  const double room = 1.35 * radius * std::cbrt(count);
  while (static_cast<int>(positions.size()) < count) {
    const Vector3d place = middle + room * vector();
    bool free = true;
    for (const Vector3d& other : positions) free = free && (place - other).norm() > 2.0001 * radius;
    if (!free) continue;
    positions.push_back(place);
    velocities.push_back(speed * (vector() - (place - middle) / room));
  }
  return spheres_at(positions, velocities);
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
  const double speed = 0.3, time = 0.6 * radius / speed;
  Deviations found;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    std::mt19937 random(seed);
    const int count = 3 + static_cast<int>(seed % 18);
    const System start = cluster(random, count, speed);
    const auto bodies = exactly(start, input, time);
    for (const double fraction : {0.15, 0.02}) {
      Hybrid hybrid(start, input, fraction);
      hybrid.flow.advance_to(time);
      hybrid.flow.open_contacts();
      const System end = hybrid.flow.system();
      (fraction > 0.1 ? found.hybrid : found.fine).push_back(deviation(end, bodies, speed));
      Vector3d momentum = Vector3d::Zero();
      for (std::size_t i = 0; i < start.count(); ++i) momentum += end.velocity[i] - start.velocity[i];
      EXPECT_LT(momentum.norm(), 1e-12 * speed * count);
    }
    Spheres binary(start, {}, TableRule(input, kinds_of(start), store(), {.turning = 1e-2}));
    binary.advance_to(time);
    found.binary.push_back(deviation(binary.system(), bodies, speed));
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
  Hybrid hybrid(start, input);
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

TEST(Patches, OfSpheresThatStickStayTogether) {
  const Input input = flow_of("normal = \"jkr\"\ntangential = \"none\"");
  const Vector3d first = Vector3d::Constant(0.02);
  const System start = spheres_at({first, first + (2 * radius + 1e-6) * Vector3d::UnitX()}, {1e-3 * Vector3d::UnitX(), Vector3d::Zero()});
  Hybrid hybrid(start, input);
  hybrid.flow.advance_to(0.05);
  EXPECT_EQ(hybrid.flow.patched(), 2u);
  const System end = hybrid.flow.system();
  ASSERT_EQ(end.contacts.size(), 1u);
  EXPECT_NEAR((end.velocity[0] - end.velocity[1]).norm(), 0, 1e-5);
  EXPECT_NEAR((end.velocity[0] + end.velocity[1]).x(), 1e-3, 1e-15);
}

}  // namespace
}  // namespace scalebreak::tests

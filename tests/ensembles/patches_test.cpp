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
  return resolved(fmt::format("[material]\nyoung = {:g}\n[contact]\n{}\n[particles]\ncount = 3\n[cell]\nkind = \"cooling\"\n"
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

TEST(Patches, OfClustersComeOutAsTheExactEngineHasIt) {
  const double speed = 0.3;
  for (const double young : {1e9, 1e7}) {
    const Input input = flow_of("normal = \"hertz\"\ntangential = \"mindlin\"", young);
    std::vector<double> deviations;
    for (unsigned seed = 0; seed < 40; ++seed) {
      std::mt19937 random(seed);
      const int count = 3 + static_cast<int>(seed % 10);
      const System start = cluster(random, count, speed);
      const double time = 0.6 * radius / speed;
      const auto bodies = exactly(start, input, time);
      Hybrid hybrid(start, input, std::getenv("FR") ? std::atof(std::getenv("FR")) : 0.15);
      hybrid.flow.advance_to(time);
      hybrid.flow.open_contacts();
      const System end = hybrid.flow.system();
      deviations.push_back(deviation(end, bodies, speed));
      const EventTotals& totals = hybrid.flow.totals();
      fmt::print("{} {}: {:.2e}  collisions {} patches {} back {} in patches {} patched {}\n", seed, count, deviations.back(), totals.collisions, totals.patches,
                 totals.taken_back, totals.patch_starts, hybrid.flow.patched());
      Vector3d momentum = Vector3d::Zero();
      for (std::size_t i = 0; i < start.count(); ++i) momentum += end.velocity[i] - start.velocity[i];
      EXPECT_LT(momentum.norm(), 1e-12 * speed * count);
    }
    std::sort(deviations.begin(), deviations.end());
    fmt::print("median {:.2e} 90 % {:.2e} most {:.2e}\n", deviations[20], deviations[36], deviations[39]);
  }
}

}  // namespace
}  // namespace scalebreak::tests

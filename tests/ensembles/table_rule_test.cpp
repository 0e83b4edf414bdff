#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include <ensembles/flows.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>

// Soft collisions by table in the event-driven engine, beside the exact engine.

namespace scalebreak::tests {
namespace {

using Eigen::Vector3d;
using Tables = EventSpheres<CalendarQueue, TableRule>;
constexpr double radius = 0.5e-3;

TableStore store() {
  static const TemporaryFolder folder;
  return {.folder = folder.path()};
}

Input flow_of(const std::string& contact, double young = 1e9, const std::string& more = "") {
  return resolved(
      fmt::format("[material]\nyoung = {:g}\n[contact]\n{}\n[particles]\ncount = 2\n[cell]\nkind = \"cooling\"\n"
                  "size = [0.02, 0.02, 0.02]\n{}",
                  young, contact, more));
}

/// Two spheres that will meet head on or obliquely, with spins, `far` of their radius apart.
System about_to_meet(std::mt19937& random, double speed, double sideways, double far) {
  std::uniform_real_distribution<double> even(-1, 1);
  const auto vector = [&] { return Vector3d(even(random), even(random), even(random)); };
  System system;
  system.cell.size = Vector3d::Constant(0.02);
  system.radius = {radius, radius};
  system.mass.assign(2, sphere_mass(radius, 2500));
  system.material = {0, 0};
  const Vector3d normal = vector().normalized(), drift = speed * vector();
  const Vector3d velocity = speed * (normal + sideways * normal.cross(vector()));
  const Vector3d middle(0.01, 0.01, 0.01);
  const double time = far * radius / speed;
  system.velocity = {drift + velocity, drift};
  system.position = {middle - 2 * radius * normal - time * (drift + velocity), middle - time * drift};
  system.spin = {sideways * speed / radius * vector(), sideways * speed / radius * vector()};
  return system;
}

struct Deviation {
  double path = 0, velocity = 0, spin = 0;
};

/// Largest deviations from the exact engine: of paths (over the largest displacement while in contact), of velocities over the speed, and of
/// surface speeds over it.
Deviation deviation_of(const Input& input, double speed, double sideways, int collisions) {
  std::mt19937 random(5);
  Deviation most;
  for (int k = 0; k < collisions; ++k) {
    const System start = about_to_meet(random, speed, sideways, 0.3);
    Tables flow(start, {}, TableRule(input, kinds_of(start), store()));
    const double time = 0.9 * radius / speed;
    flow.advance_to(time);
    EXPECT_EQ(flow.totals().collisions, 1);
    const System end = flow.system();
    Input scene = input;
    scene.flow = false;
    for (const std::size_t i : {0, 1})
      scene.bodies.push_back({.position = start.position[i], .velocity = start.velocity[i], .spin = start.spin[i], .radius = radius});
    const MotionOutcome exact = moving_scene(scene).move({.tolerance = 1e-10, .duration = time});
    for (const std::size_t i : {0, 1}) {
      const MovingBody& body = exact.bodies[i];
      most.path = std::max(most.path, (end.position[i] - body.position).norm() / (speed * flow.totals().contact_time));
      most.velocity = std::max(most.velocity, (end.velocity[i] - body.velocity).norm() / speed);
      most.spin = std::max(most.spin, radius * (end.spin[i] - body.spin).norm() / speed);
    }
  }
  return most;
}

TEST(TableRule, LeavesSmoothSpheresWhereTheirSoftCollisionWould) {
  for (const char* normal : {"hertz", "jkr", "linear"}) {
    const Deviation most = deviation_of(flow_of(fmt::format("normal = \"{}\"\ntangential = \"none\"", normal)), 0.3, 0, 5);
    EXPECT_LT(most.velocity, 1e-5) << normal;
    EXPECT_LT(most.path, 1e-4) << normal;
  }
}

TEST(TableRule, LeavesRoughSpheresWhereTheirSoftCollisionWould) {
  const Deviation most = deviation_of(flow_of("normal = \"hertz\"\ntangential = \"mindlin\"\ntorque_arm = \"contact\""), 0.3, 0.6, 10);
  EXPECT_LT(most.velocity, 1e-3);
  EXPECT_LT(most.path, 2e-3);
  EXPECT_LT(most.spin, 2e-3);
}

TEST(TableRule, CountsWhatItIntegrates) {
  const Input input = flow_of("normal = \"hertz\"\ntangential = \"mindlin\"", 1e5);
  std::mt19937 random(5);
  const System start = about_to_meet(random, 0.3, 0.6, 0.3);
  Tables flow(start, {}, TableRule(input, kinds_of(start), store()));
  flow.advance_to(0.5 * radius / 0.3);
  ASSERT_EQ(flow.totals().collisions, 1);
  EXPECT_EQ(flow.rule().count(Refusal::turns_too_far), 1);
  EXPECT_EQ(flow.rule().integrated(), 1);
}

TEST(TableRule, SaysThatSpheresStick) {
  const Input input = flow_of("normal = \"jkr\"\ntangential = \"none\"");
  std::mt19937 random(5);
  const System start = about_to_meet(random, 1e-4, 0, 0.3);
  Tables flow(start, {}, TableRule(input, kinds_of(start), store()));
  EXPECT_EQ(
      message_of<WorkError>([&] { flow.advance_to(0.5 * radius / 1e-4); }),
      "two spheres met at 0.0001 m/s and stick together, which an event cannot say; allowed: a flow that is faster or adheres less, or "
      "--engine dem, which integrates every contact");
}

TEST(TableRule, RefusesWhatHasNoTables) {
  std::mt19937 random(5);
  const System start = about_to_meet(random, 0.1, 0, 0.3);
  const auto message = [&](const Input& input) {
    return message_of<InputError>([&] { (void)TableRule(input, kinds_of(start), store()); });
  };
  EXPECT_EQ(
      message(flow_of("normal = \"jkr\"", 1e9, "[scaling]\nlaw = \"sup\"\nfactor = 2\n")),
      "scaling.law: found \"sup\", which maps forces and has no collision tables; allowed in an event-driven run: laws that scale the "
      "material, or --engine dem, which integrates every contact");
  EXPECT_EQ(
      message(flow_of("normal = \"hertz\"\nattraction = \"viscous\"", 1e9)),
      "contact.attraction: found a liquid, which acts at a distance and has no collision tables; allowed in an event-driven run: \"none\", "
      "or --engine dem, which integrates every contact");
}

/// A third of the smallest and of the largest sphere's radii apart, and seven between: more than have tables of their own.
System of_many_sizes(System two) {
  for (int i = 0; i < 9; ++i) {
    two.radius.push_back(radius * (0.85 + 0.0375 * i));
    two.position.push_back(Vector3d(0.002 + 0.002 * i, 0.001, 0.001));
    two.mass.push_back(sphere_mass(two.radius.back(), 2500)), two.material.push_back(0);
    for (auto* list : {&two.velocity, &two.spin}) list->push_back(Vector3d::Zero());
  }
  return two;
}

TEST(TableRule, LeavesSpheresOfManySizesWhereTheirSoftCollisionWould) {
  for (const char* contact :
       {"normal = \"jkr\"\ntangential = \"none\"\nrolling = \"ar\"", "normal = \"hertz\"\ntangential = \"mindlin\""}) {
    const Input input = flow_of(contact);
    std::mt19937 random(5);
    for (int k = 0; k < 5; ++k) {
      System start = about_to_meet(random, 0.3, 0.6, 0.3);
      start.radius = {0.93 * radius, 1.07 * radius};  // their sum is the same
      for (const std::size_t i : {0, 1}) start.mass[i] = sphere_mass(start.radius[i], 2500);
      const System all = of_many_sizes(start);
      const SphereKinds kinds = kinds_of(all);
      ASSERT_TRUE(kinds.many);
      ASSERT_EQ(kinds.kinds.size(), 2);
      Tables flow(all, {}, TableRule(input, kinds, store(), {.turning = 1e-2}));
      const double time = 0.9 * radius / 0.3;
      flow.advance_to(time);
      ASSERT_EQ(flow.totals().collisions, 1);
      EXPECT_EQ(flow.rule().integrated(), 0);
      const System end = flow.system();
      Input scene = input;
      scene.flow = false;
      for (const std::size_t i : {0, 1})
        scene.bodies.push_back(
            {.position = start.position[i], .velocity = start.velocity[i], .spin = start.spin[i], .radius = start.radius[i]});
      const MotionOutcome exact = moving_scene(scene).move({.tolerance = 1e-10, .duration = time});
      for (const std::size_t i : {0, 1}) {
        const MovingBody& body = exact.bodies[i];
        // What they have come past each other while in touch is off by the first order of how far they turned (docs/tables.md).
        EXPECT_LT((end.position[i] - body.position).norm(), 1e-2 * 0.3 * flow.totals().contact_time) << contact << k;
        EXPECT_LT((end.velocity[i] - body.velocity).norm(), 5e-3 * 0.3) << contact << k;
        EXPECT_LT(radius * (end.spin[i] - body.spin).norm(), 5e-3 * 0.3) << contact << k;
      }
    }
  }
}

/// A sphere that cannot turn while it touches is braked with all of its mass, not with 2/7 of it as by its table.
TEST(TableRule, LeavesWallsThatStopSpins) {
  const auto walled = [](const char* tangential) {
    return resolved(
        fmt::format("[contact]\nnormal = \"hertz\"\ntangential = \"{}\"\n[particles]\nvolume_fraction = 0.1\n"
                    "[cell]\nkind = \"couette\"\nsize = [0.01, 0.01, 0.01]\nwall_speed = 1\nwall_no_slip = true\n",
                    tangential));
  };
  const SphereKinds kinds{.kinds = {{radius, 0}}};
  const Meeting at_wall{.normal = -Vector3d::UnitZ(),
                        .first = {.mass = sphere_mass(radius, 2500), .radius = radius, .velocity = {0.1, 0, -0.1}},
                        .distance = radius,
                        .wall = true};
  TableRule rough(walled("mindlin"), kinds, store(), {.turning = 1e-2}, Unanswered::leave);
  EXPECT_TRUE(rough.collide(at_wall).unresolved);
  EXPECT_EQ(rough.count(Refusal::no_table), 1);
  TableRule smooth(walled("none"), kinds, store(), {.turning = 1e-2}, Unanswered::leave);
  EXPECT_FALSE(smooth.collide(at_wall).unresolved);
  EXPECT_EQ(
      message_of<InputError>([&] { (void)TableRule(walled("mindlin"), kinds, store()); }),
      "cell.wall_no_slip: found true beside friction or rolling resistance: a sphere that cannot turn while it touches has no collision "
      "table; allowed in an event-driven run: false, or --engine hybrid, or --engine dem, which integrates every contact");
}

TEST(TableRule, RefusesSizesThatShareNoTables) {
  std::mt19937 random(5);
  const System many = of_many_sizes(about_to_meet(random, 0.1, 0, 0.3));
  EXPECT_EQ(
      message_of<InputError>([&] {
        (void)TableRule(flow_of("normal = \"hertz\"\ntangential = \"mindlin\"\ntorque_arm = \"contact\""), kinds_of(many), store());
      }),
      "contact: between spheres of radii 0.000425 and 0.000575 m no collision table can serve (no table); allowed in an event-driven run: "
      "laws and sizes that have one, or --engine dem, which integrates every contact");
}

}  // namespace
}  // namespace scalebreak::tests

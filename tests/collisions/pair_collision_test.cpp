#include <cmath>

#include <gtest/gtest.h>

#include <scalebreak/collisions/pair_collision.hpp>

namespace scalebreak {
namespace {

Input two_bodies() {
  Input input;
  input.bodies = {{.position = {0, 0, 0}, .velocity = {0.1, 0, 0}, .radius = 1e-3},
                  {.position = {5e-3, 0, 0}, .velocity = {-0.05, 0, 0}, .radius = 2e-3}};
  return input;
}

Eigen::Vector3d momentum(const Input& input, const std::vector<Eigen::Vector3d>& velocity) {
  return sphere_mass(input.bodies[0].radius, input.material.density) * velocity[0] +
         sphere_mass(input.bodies[1].radius, input.material.density) * velocity[1];
}

TEST(ResolveCollision, KeepsMomentumAndReturnsTheRestitution) {
  const Input input = two_bodies();
  const CollisionResult r = resolve_collision(input);
  const Eigen::Vector3d before = momentum(input, {input.bodies[0].velocity, input.bodies[1].velocity}),
                        after = momentum(input, {r.bodies[0].velocity, r.bodies[1].velocity});
  EXPECT_NEAR((after - before).norm() / before.norm(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(r.speed, 0.15);
  EXPECT_NEAR((r.bodies[1].velocity - r.bodies[0].velocity).x() / 0.15, r.collision.restitution, 1e-13);
  // Energy lost is (1 − e²) of the relative motion's.
  const NormalPair pair = sphere_pair(input.material, 1e-3, input.material, 2e-3);
  EXPECT_NEAR((r.energy_before - r.energy_after) / (pair.mass / 2 * 0.15 * 0.15 * (1 - std::pow(r.collision.restitution, 2))), 1, 1e-12);
}

TEST(ResolveCollision, LeavesBodiesWhereTheyPart) {
  const Input input = two_bodies();
  const CollisionResult r = resolve_collision(input);
  // The gap of 2 mm closes at 0.15 m/s; the centre of mass moves on all the while; they part at the fold, a little apart.
  const double time = 2e-3 / 0.15 + *r.collision.contact_time;
  const double share = 1.0 / 9;
  const double centre = (1 - share) * 5e-3 + (share * 0.1 + (1 - share) * -0.05) * time;
  EXPECT_NEAR((share * r.bodies[0].position + (1 - share) * r.bodies[1].position).x(), centre, 1e-15);
  const double distance = (r.bodies[1].position - r.bodies[0].position).norm();
  EXPECT_GT(distance, 3e-3);
  EXPECT_LT(distance, 3e-3 + 1e-6);
}

TEST(ResolveCollision, EnlargesBodiesAboutTheirCentreOfMass) {
  Input input = two_bodies();
  input.scaling_law = "sup", input.scaling_factor = 4;
  const CollisionResult original = resolve_collision(two_bodies()), scaled = resolve_collision(input);
  EXPECT_NEAR(scaled.collision.restitution, original.collision.restitution, 1e-9);
  EXPECT_NEAR(*scaled.collision.contact_time / *original.collision.contact_time, 4, 1e-8);
  EXPECT_NEAR(scaled.energy_before / original.energy_before, 64, 1e-10);
  EXPECT_NEAR(
      (scaled.bodies[1].position - scaled.bodies[0].position).norm() / (original.bodies[1].position - original.bodies[0].position).norm(),
      4, 1e-8);
}

TEST(ResolveCollision, AgainstAWallTurnsTheSphereAround) {
  Input input;
  input.against_wall = true, input.radius = {1e-3};
  const CollisionResult r = resolve_collision(input);
  EXPECT_NEAR(r.bodies[0].velocity.z(), 0.1 * r.collision.restitution, 1e-15);
  EXPECT_EQ(r.bodies[1].velocity.norm(), 0);
  EXPECT_NEAR(r.energy_after / r.energy_before, std::pow(r.collision.restitution, 2), 1e-13);
}

TEST(ResolveCollision, OfAPairThatSticksGivesTheCommonMotion) {
  Input input;
  input.normal_speed = 1e-4;
  const CollisionResult r = resolve_collision(input);
  EXPECT_TRUE(r.collision.stuck);
  EXPECT_EQ(r.collision.restitution, 0);
  EXPECT_FALSE(r.collision.contact_time.has_value());
  EXPECT_NEAR(r.bodies[0].velocity.z(), -0.5e-4, 1e-18);
  EXPECT_NEAR(r.bodies[1].velocity.z(), -0.5e-4, 1e-18);
}

TEST(Trajectory, RunsFromTouchToSeparationWithTheOutcome) {
  const auto [contact, speed] = contact_of(Input{});
  const PairCollision c = contact.collide(speed, 1e-10, true);
  const auto path = contact.trajectory(speed, 1e-10, 400);
  EXPECT_GT(path.size(), 200u);
  EXPECT_LT(path.size(), 900u);
  EXPECT_EQ(path.front().time, 0);
  EXPECT_NEAR(path.front().speed, speed, 1e-15);
  EXPECT_NEAR(path.back().time / *c.contact_time, 1, 1e-8);
  EXPECT_NEAR(-path.back().speed / speed, c.restitution, 1e-8);
  double deepest = 0, strongest = 0;
  for (const TrajectoryPoint& p : path)
    deepest = std::max(deepest, p.overlap), strongest = std::max(strongest, p.elastic_force + p.damping_force);
  EXPECT_NEAR(deepest / c.max_overlap, 1, 1e-3);
  EXPECT_NEAR(strongest / c.max_force, 1, 1e-3);
}

}  // namespace
}  // namespace scalebreak

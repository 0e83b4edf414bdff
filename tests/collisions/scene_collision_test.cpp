#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/motion_record.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/bodies/scene_collision.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>

namespace scalebreak {
namespace {

using Eigen::Vector3d;

Input two_bodies() {
  Input input;
  input.bodies = {{.position = {0, 0, 0}, .velocity = {0.1, 0, 0}, .radius = 1e-3},
                  {.position = {5e-3, 0, 0}, .velocity = {-0.05, 0, 0}, .radius = 2e-3}};
  return input;
}

/// Of the default pair, with friction.
Input oblique() {
  Input input;
  input.tangential_speed = 0.15;
  input.surface.tangential = TangentialModel::mindlin;
  input.tolerance = 1e-10;
  return input;
}

double sum_error(const SceneCollision& r) { return r.motion.after.total() / r.motion.before.total() - 1; }

TEST(ResolveCollision, KeepsMomentumAndReturnsTheRestitution) {
  const SceneCollision r = resolve_collision(two_bodies());
  const Vector3d before = momentum(r.before);
  EXPECT_NEAR((momentum(r.after) - before).norm() / before.norm(), 0, 1e-12);
  EXPECT_NEAR(r.pair->impact_speed, 0.15, 1e-15);
  EXPECT_NEAR((r.after[1].velocity - r.after[0].velocity).x() / 0.15, *r.pair->restitution_normal, 1e-13);
  EXPECT_NEAR(*r.pair->restitution_normal, contact_of(two_bodies()).collide(0.15, 1e-10).restitution, 1e-8);
  // Energy lost is (1 − e²) of the relative motion's.
  const NormalPair pair = sphere_pair(Material{}, 1e-3, Material{}, 2e-3);
  EXPECT_NEAR((r.energy_before() - r.energy_after()) / (pair.mass / 2 * 0.15 * 0.15 * (1 - std::pow(*r.pair->restitution_normal, 2))), 1,
              1e-12);
}

TEST(ResolveCollision, LeavesBodiesWhereTheyPart) {
  const SceneCollision r = resolve_collision(two_bodies());
  // The gap of 2 mm closes at 0.15 m/s; the centre of mass moves on all the while; they part at the fold, a little apart.
  const double time = 2e-3 / 0.15 + *r.pair->contact_time;
  const double share = 1.0 / 9;
  const double centre = (1 - share) * 5e-3 + (share * 0.1 + (1 - share) * -0.05) * time;
  EXPECT_NEAR((share * r.after[0].position + (1 - share) * r.after[1].position).x(), centre, 1e-15);
  const double distance = (r.after[1].position - r.after[0].position).norm();
  EXPECT_NEAR(distance, 3e-3 + contact_of(two_bodies()).end_gap(0.15), 1e-12);
  EXPECT_GT(distance, 3e-3);
}

TEST(ResolveCollision, EnlargesBodiesAboutTheirCentreOfMass) {
  Input input = two_bodies();
  input.scaling_law = "sup", input.scaling_factor = 4;
  const SceneCollision original = resolve_collision(two_bodies()), scaled = resolve_collision(input);
  EXPECT_NEAR(*scaled.pair->restitution_normal, *original.pair->restitution_normal, 1e-9);
  EXPECT_NEAR(*scaled.pair->contact_time / *original.pair->contact_time, 4, 1e-8);
  EXPECT_NEAR(scaled.energy_before() / original.energy_before(), 64, 1e-10);
  const double centre = 8.0 / 9 * 5e-3;
  for (const std::size_t b : {0, 1}) {
    EXPECT_NEAR(scaled.before[b].position.x() - centre, 4 * (original.before[b].position.x() - centre), 1e-15);
  }
}

TEST(ResolveCollision, AgainstAWallTurnsTheSphereAround) {
  Input input;
  input.against_wall = true, input.radius = {1e-3};
  const SceneCollision r = resolve_collision(input);
  EXPECT_NEAR(r.after[0].velocity.z(), 0.1 * *r.pair->restitution_normal, 1e-15);
  EXPECT_EQ(r.after[1].velocity.norm(), 0);
  EXPECT_NEAR(r.energy_after() / r.energy_before(), std::pow(*r.pair->restitution_normal, 2), 1e-13);
}

TEST(ResolveCollision, AHeadOnPairIsWhatTheMovingBodiesDo) {
  for (const bool wall : {false, true}) {
    for (const double speed : {0.1, 1e-4}) {
      Input input;
      input.tolerance = 1e-10;
      input.normal_speed = speed;
      if (wall) input.against_wall = true, input.radius = {1e-3};
      const SceneCollision r = resolve_collision(input);
      EXPECT_TRUE(r.head_on);
      EXPECT_NEAR(sum_error(r), 0, 1e-14);
      const MotionOutcome moved = moving_scene(input).move({.tolerance = 1e-10, .find_max_force = true});
      EXPECT_EQ(moved.resting, r.pair->stuck);
      EXPECT_NEAR(moved.max_overlap / r.motion.max_overlap, 1, 1e-9);
      EXPECT_NEAR(moved.max_force / r.motion.max_force, 1, 1e-9);
      EXPECT_NEAR(moved.max_depth / r.motion.max_depth, 1, 1e-9);
      if (r.pair->stuck) continue;
      EXPECT_NEAR((moved.bodies[0].position - r.after[0].position).norm(), 0, 1e-8 * r.motion.max_overlap);
      EXPECT_NEAR(moved.bodies[0].velocity.z(), r.after[0].velocity.z(), 1e-9 * speed);
      EXPECT_NEAR(moved.after.damping / r.motion.after.damping, 1, 1e-8);
      EXPECT_NEAR(moved.after.adhesion / r.motion.after.adhesion, 1, 1e-12);
    }
  }
}

TEST(ResolveCollision, OfAPairThatSticksGivesTheCommonMotion) {
  Input input;
  input.normal_speed = 1e-4;
  const SceneCollision r = resolve_collision(input);
  EXPECT_TRUE(r.pair->stuck);
  EXPECT_EQ(r.pair->restitution_normal, 0);
  EXPECT_FALSE(r.pair->contact_time.has_value());
  EXPECT_NEAR(r.after[0].velocity.z(), -0.5e-4, 1e-18);
  EXPECT_NEAR(r.after[1].velocity.z(), -0.5e-4, 1e-18);
}

TEST(ResolveCollision, AnObliquePairThatSticksTurnsAsOneBody) {
  Input input = oblique();
  input.normal_speed = 1e-4, input.tangential_speed = 2e-4;
  const SceneCollision r = resolve_collision(input);
  ASSERT_TRUE(r.pair->stuck);
  EXPECT_EQ(r.pair->restitution_normal, 0);
  EXPECT_EQ(r.pair->restitution_tangential, 0);
  EXPECT_EQ(r.pair->restitution_surface, 0);
  EXPECT_FALSE(r.pair->contact_time.has_value());
  EXPECT_EQ(r.after[0].spin, r.after[1].spin);
  const Vector3d between = r.after[0].position - r.after[1].position;
  EXPECT_NEAR((r.after[0].velocity - r.after[1].velocity - r.after[0].spin.cross(between)).norm(), 0, 1e-17) << "rigid";
  EXPECT_NEAR((momentum(r.after) - momentum(r.before)).norm(), 0, 1e-12 * momentum(r.before).norm());
  const Vector3d turning = angular_momentum(r.motion.bodies);
  EXPECT_NEAR((angular_momentum(r.after) - turning).norm(), 0, 1e-12 * turning.norm());
  EXPECT_GT(r.internal, 0) << "a rigid body has the least energy";
  EXPECT_NEAR(r.energy_after() + r.internal, r.motion.after.kinetic, 1e-12 * r.energy_after());
}

TEST(ResolveCollision, WhatSticksWithoutFrictionSlidesOn) {
  Input input;
  input.against_wall = true, input.radius = {1e-3};
  input.normal_speed = 1e-4, input.tangential_speed = 2e-4, input.spin1 = {0, 3, 0};
  const SceneCollision r = resolve_collision(input);
  ASSERT_TRUE(r.pair->stuck);
  EXPECT_TRUE(r.idle_spins);
  EXPECT_EQ(r.after[0].velocity, Vector3d(2e-4, 0, 0));
  EXPECT_EQ(r.after[0].spin, Vector3d(0, 3, 0));
  input.surface.tangential = TangentialModel::mindlin;
  const SceneCollision held = resolve_collision(input);
  ASSERT_TRUE(held.pair->stuck);
  EXPECT_FALSE(held.idle_spins);
  EXPECT_EQ(held.after[0].velocity, Vector3d(0, 0, 0));
}

TEST(ResolveCollision, RestitutionsAreAlongTheDirectionsAtFirstTouch) {
  Input input = oblique();
  input.spin1 = {0, 20, 0};
  const SceneCollision r = resolve_collision(input);
  EXPECT_FALSE(r.head_on);
  const double radius = 0.5e-3, surface = 0.15 - radius * 20;
  EXPECT_NEAR(r.pair->surface_speed, surface, 1e-15);
  const Vector3d past = r.after[0].velocity - r.after[1].velocity;
  EXPECT_NEAR(*r.pair->restitution_tangential, past.x() / 0.15, 1e-14);
  EXPECT_NEAR(*r.pair->restitution_normal, past.z() / 0.1, 1e-14);
  const double after = past.x() - radius * (r.after[0].spin.y() + r.after[1].spin.y());
  EXPECT_NEAR(*r.pair->restitution_surface, -after / surface, 1e-13);
  EXPECT_NEAR(sum_error(r), 0, 1e-8);
  EXPECT_GT(r.motion.after.friction, 0);
}

// A pair that slides throughout: the impulse of friction is μ times that of F_N, and an undamped contact's is 2 m* v_n.
TEST(ResolveCollision, SurfacesThatSlideThroughoutLoseWhatCoulombTakes) {
  Input input = oblique();
  input.against_wall = true, input.radius = {1e-3};
  input.contact = canonical({.normal = NormalModel::hertz});
  input.surface.tangential_radius = DampingOn::overlap;
  input.wall.rigid = true;
  input.wall.material.restitution = 1;
  input.wall.material.sliding_friction = 0.05;
  input.tangential_speed = 0, input.spin1 = {0, 100, 0};
  const SceneCollision r = resolve_collision(input);
  EXPECT_FALSE(r.pair->restitution_tangential.has_value()) << "the centres do not pass each other";
  EXPECT_NEAR(*r.pair->restitution_surface, 3.5 * 0.05 * 2 * 0.1 / 0.1 - 1, 1e-7);
  EXPECT_EQ(r.motion.slides, 1) << "from the start";
}

TEST(ResolveCollision, AFixedBodyStaysAndTheOtherKeepsItsRestitution) {
  Input input = two_bodies();
  input.bodies[1].fixed = true, input.bodies[1].velocity.setZero();
  const SceneCollision r = resolve_collision(input);
  EXPECT_EQ(r.after[1].velocity, Vector3d(0, 0, 0));
  EXPECT_NEAR(*r.pair->restitution_normal, contact_of(input).collide(0.1, 1e-10).restitution, 1e-7);
}

TEST(ResolveCollision, AnUndampedBridgedPairThatCannotTearItsBridgeSticks) {
  Input input;
  input.contact = canonical({.normal = NormalModel::hertz});
  input.material.restitution = input.second.restitution = 1;
  input.surface.attraction = Attraction::capillary;
  input.normal_speed = 0.01;
  const SceneCollision r = resolve_collision(input);
  EXPECT_TRUE(r.pair->stuck);
  EXPECT_EQ(r.motion.ruptures, 0);
  EXPECT_FALSE(r.pair->sticking_speed.has_value());
  EXPECT_NEAR(r.after[0].velocity.z(), -0.005, 1e-12);
  input.normal_speed = 0.3;
  const SceneCollision free = resolve_collision(input);
  EXPECT_FALSE(free.pair->stuck);
  EXPECT_EQ(free.motion.ruptures, 1);
  EXPECT_NEAR(sum_error(free), 0, 1e-7);
}

TEST(ResolveCollision, EveryContactIsCountedOnce) {
  Input input;
  for (const double x : {0.0, 1.2e-3, 2.4e-3}) input.bodies.push_back({.position = {x, 0, 0}, .radius = 0.5e-3});
  input.bodies[0].velocity = {0.2, 0, 0};
  const SceneCollision r = resolve_collision(input);
  EXPECT_FALSE(r.pair.has_value());
  const MotionRecord record = record_motion(input, 40);
  const auto touches =
      std::count_if(record.changes.begin(), record.changes.end(), [](const auto& c) { return c.what == ContactChange::touch; });
  EXPECT_EQ(r.motion.touches, touches);
  EXPECT_EQ(touches, 3) << "the first catches up with the second again";
}

// Each contact alone holds less than it takes to tear it; the two together hold more, and one of them tears.
TEST(ResolveCollision, BodiesThatCanStillPartDoNotRest) {
  Input input;
  input.material.restitution = input.second.restitution = 1;
  for (const double x : {-1.2e-3, 0.0, 1.2e-3}) input.bodies.push_back({.position = {x, 0, 0}, .radius = 0.5e-3});
  input.bodies[0].velocity = {5e-4, 0, 0};
  input.bodies[2].velocity = {-4.9e-4, 0, 0};
  const SceneCollision r = resolve_collision(input);
  EXPECT_EQ(r.motion.open_contacts, 1);
  EXPECT_GT(r.motion.last_separation, 0);
}

TEST(RecordMotion, EndsWithTheOutcomeAndShowsTheForces) {
  Input input = oblique();
  input.contact = canonical({.normal = NormalModel::hertz});
  input.surface.tangential_radius = DampingOn::overlap;
  const SceneCollision r = resolve_collision(input);
  const MotionRecord record = record_motion(input, 200);
  EXPECT_GT(record.instants.size(), 200u);
  EXPECT_LT(record.instants.size(), 1000u);
  EXPECT_NEAR((record.instants.back().bodies[0].velocity - r.after[0].velocity).norm(), 0, 1e-9);
  double strongest = 0, friction = 0;
  bool slides = false, holds = false;
  for (const auto& instant : record.instants) {
    EXPECT_NEAR(instant.energy.total() / r.motion.before.total(), 1, 1e-7);
    for (const ContactState& c : instant.contacts) {
      strongest = std::max(strongest, c.normal_force);
      friction = std::min(friction, c.tangential_force.x());
      const double coulomb = 0.3 * std::abs(c.normal_force);
      EXPECT_LE(c.tangential_force.norm(), coulomb + 1e-7 * r.motion.max_force);
      if (c.slides) {
        EXPECT_NEAR(c.tangential_force.norm(), coulomb, 1e-9 * r.motion.max_force);
      }
      (c.slides ? slides : holds) = true;
    }
  }
  EXPECT_NEAR(strongest / r.motion.max_force, 1, 1e-3);
  EXPECT_LT(friction, 0) << "against the first body's motion";
  EXPECT_TRUE(slides && holds);
}

}  // namespace
}  // namespace scalebreak

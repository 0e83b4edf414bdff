#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <collisions/scenes.hpp>
#include <scalebreak/collisions/oblique/oblique_collision.hpp>

// The engine of one pair in its plane against the engine of bodies in space: they share the laws and the integrator, and neither
// the variables nor the equations of motion.

namespace scalebreak {
namespace {

using namespace tests;

class Planar : public testing::TestWithParam<const char*> {};

TEST_P(Planar, CollidesAsBodiesInSpace) {
  const Input input = resolved("[contact]\n" + std::string(GetParam()) +
                               "[pair]\nradius = [0.5e-3, 0.8e-3]\n[impact]\nnormal_speed = 0.1\ntangential_speed = 0.06\n"
                               "spin1 = [0, -30, 0]\nspin2 = [0, -20, 0]\n");
  const MovingScene scene = moving_scene(input);
  const MovingBody &a = scene.bodies[0], &b = scene.bodies[1];
  const ObliquePair pair{.laws = scene.laws[0].laws,
                         .mass = a.mass * b.mass / (a.mass + b.mass),
                         .radius = {a.radius, b.radius},
                         .inertia = {a.inertia, b.inertia},
                         .distance = a.radius + b.radius};
  const ObliqueOutcome planar = resolve_oblique_collision(pair, {0.1, 0.06, {30, 20}}, 1e-11);
  const MotionOutcome motion = scene.move({.tolerance = 1e-11});
  const MovingBody &c = motion.bodies[0], &d = motion.bodies[1];
  const Eigen::Vector3d normal = (d.position - c.position).normalized(), velocity = c.velocity - d.velocity;
  const Eigen::Vector3d along = -Eigen::Vector3d::UnitY().cross(normal);
  EXPECT_NEAR(-velocity.dot(normal) / 0.1, planar.normal_speed / 0.1, 1e-9);
  EXPECT_NEAR(velocity.dot(along) / 0.1, planar.tangential_speed / 0.1, 1e-9);
  EXPECT_NEAR(-c.spin.y() / 30, planar.spin[0] / 30, 1e-8);
  EXPECT_NEAR(-d.spin.y() / 30, planar.spin[1] / 30, 1e-8);
  EXPECT_NEAR((motion.last_separation - motion.first_touch) / planar.contact_time, 1, 1e-9);
  EXPECT_NEAR(motion.turned, std::abs(planar.turned), 1e-11);
  EXPECT_GT(planar.turned, 1e-4);
  EXPECT_EQ(motion.slides, planar.slips);
  EXPECT_EQ(motion.rolls, planar.rolls);
}

INSTANTIATE_TEST_SUITE_P(Laws, Planar,
                         testing::Values("normal = \"linear\"\ntangential = \"linear\"\ntorque_arm = \"contact\"\n",
                                         "normal = \"hertz\"\ntangential = \"mindlin\"\n",
                                         "normal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"epsd\"\ntorque_arm = \"contact\"\n",
                                         "normal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"ar\"\n",
                                         "normal = \"jkr\"\ntangential = \"mindlin\"\ntangential_radius = \"overlap\"\n",
                                         "normal = \"jkr\"\ndamping_on = \"overlap\"\ntangential = \"linear\"\nrolling = \"epsd2\"\n"));

}  // namespace
}  // namespace scalebreak

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <collisions/kinds.hpp>
#include <collisions/scenes.hpp>
#include <scalebreak/collisions/bodies/few_bodies.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>

// The engine of a few bodies against the engine of one normal contact, and against itself: turned, carried along, renamed,
// and at other tolerances.

namespace scalebreak {
namespace {

using namespace tests;

class HeadOn : public testing::TestWithParam<ContactKind> {};

/// The two engines have nothing in common but the laws.
void expect_same_as_normal_collision(const Input& input) {
  const PairCollision normal = contact_of(input).collide(input.normal_speed, input.tolerance);
  ASSERT_FALSE(normal.stuck);
  const MovingScene scene = moving_scene(input);
  const MotionOutcome end = scene.move({.tolerance = 1e-11});
  const double before = (scene.bodies[1].velocity - scene.bodies[0].velocity)[2];
  const double after = (end.bodies[0].velocity - end.bodies[1].velocity)[2];
  EXPECT_NEAR(after / before, normal.restitution, 1e-8);
  EXPECT_NEAR((end.last_separation - end.first_touch) / *normal.contact_time, 1, 1e-8);
  EXPECT_NEAR(end.max_overlap / normal.max_overlap, 1, 1e-8);
  EXPECT_EQ(end.touches, 1);
  EXPECT_FALSE(end.resting);
}

TEST_P(HeadOn, PairCollidesAsItsNormalContact) {
  Input input{.contact = GetParam(), .radius = {0.5e-3, 0.3e-3}, .normal_speed = 0.15, .tolerance = 1e-11};
  input.second.young = 3e9, input.second.density = 4000;
  expect_same_as_normal_collision(input);
}

TEST_P(HeadOn, SphereAndWallCollideAsTheirNormalContact) {
  Input input{.contact = GetParam(), .radius = {0.5e-3}, .against_wall = true, .normal_speed = 0.15, .tolerance = 1e-11};
  input.wall.material.young = 2e9;
  expect_same_as_normal_collision(input);
}

TEST_P(HeadOn, ScaledByForceCollidesAsItsNormalContact) {
  Input input{.contact = GetParam(), .radius = {0.5e-3, 0.3e-3}, .normal_speed = 0.3, .tolerance = 1e-11};
  input.scaling_law = "torque_cubed", input.scaling_factor = 3;
  expect_same_as_normal_collision(input);
  input.scaling_law = "overlap_kept", input.scaling_factor = 1.5;
  expect_same_as_normal_collision(input);
}

INSTANTIATE_TEST_SUITE_P(Kinds, HeadOn, testing::ValuesIn(all_contact_kinds()), [](const auto& test) { return kind_name(test.param); });

TEST(FewBodies, SlowAdhesivePairRests) {
  Input input{.normal_speed = 1e-4};
  ASSERT_TRUE(contact_of(input).collide(input.normal_speed, input.tolerance).stuck);
  const MotionOutcome end = moving_scene(input).move({.tolerance = 1e-9});
  EXPECT_TRUE(end.resting);
  EXPECT_EQ(end.open_contacts, 1);
  EXPECT_EQ(end.touches, 1);
  EXPECT_LT(end.last_separation, 0);
}

/// Everything at once: three skew spheres that meet, with friction, rolling, adhesion and liquid.
struct Skew {
  std::vector<Eigen::Vector3d> position = {{0.1e-3, 0.05e-3, 0.93e-3}, {0, 0, 0}, {0.2e-3, -0.1e-3, -0.96e-3}};
  std::vector<Eigen::Vector3d> velocity = {{0.05, 0.12, -0.3}, {0.02, -0.05, 0}, {-0.06, 0, 0.25}};
  std::vector<Eigen::Vector3d> spin = {{100, -200, 150}, {-80, 50, 200}, {0, 120, -60}};
  std::vector<double> radius = {0.5e-3, 0.4e-3, 0.5e-3};
  std::string contact = "normal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"epsd\"\nattraction = \"capillary+viscous\"\n";

  [[nodiscard]] std::vector<MovingBody> end(double tolerance = 1e-11, int* touches = nullptr) const {
    std::string text = "[contact]\n" + contact + "[material]\nliquid_volume = 1e-14\n";
    for (std::size_t b = 0; b < position.size(); ++b) text += body_text(position[b], velocity[b], spin[b], radius[b]);
    const MotionOutcome outcome = moving_scene(resolved(text)).move({.tolerance = tolerance});
    if (touches) *touches = outcome.touches;
    return outcome.bodies;
  }
};

constexpr double speed_size = 0.3, spin_size = speed_size / 0.5e-3;

TEST(FewBodies, TurnWithTheirScene) {
  std::mt19937 random(20240611);
  std::normal_distribution<double> gauss;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond(gauss(random), gauss(random), gauss(random), gauss(random)).normalized();
    const Skew scene;
    Skew turned = scene;
    for (auto* vectors : {&turned.position, &turned.velocity, &turned.spin}) {
      for (Eigen::Vector3d& v : *vectors) v = turn * v;
    }
    int touches = 0;
    const auto a = scene.end(1e-11, &touches), b = turned.end();
    ASSERT_GE(touches, 2);
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_LT((turn * a[k].velocity - b[k].velocity).norm(), 1e-8 * speed_size);
      EXPECT_LT((turn * a[k].spin - b[k].spin).norm(), 1e-8 * spin_size);
    }
  }
}

TEST(FewBodies, DoNotFeelAVelocityThatAllOfThemHave) {
  const Eigen::Vector3d wind(3, -2, 5);
  const Skew scene;
  Skew carried = scene;
  for (Eigen::Vector3d& v : carried.velocity) v += wind;
  const auto a = scene.end(), b = carried.end();
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_LT((a[k].velocity + wind - b[k].velocity).norm(), 1e-8 * speed_size);
    EXPECT_LT((a[k].spin - b[k].spin).norm(), 1e-8 * spin_size);
  }
}

TEST(FewBodies, DoNotDependOnTheirOrder) {
  const Skew scene;
  Skew reversed = scene;
  for (auto* vectors : {&reversed.position, &reversed.velocity, &reversed.spin}) std::reverse(vectors->begin(), vectors->end());
  std::reverse(reversed.radius.begin(), reversed.radius.end());
  const auto a = scene.end(), b = reversed.end();
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_LT((a[k].velocity - b[2 - k].velocity).norm(), 1e-8 * speed_size);
    EXPECT_LT((a[k].spin - b[2 - k].spin).norm(), 1e-8 * spin_size);
    EXPECT_LT((a[k].position - b[2 - k].position).norm(), 1e-8 * 0.5e-3);
  }
}

class Convergence : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Convergence, ErrorFollowsTheTolerance) {
  Skew scene;
  scene.contact = GetParam().second;
  const auto exact = scene.end(1e-13);
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto found = scene.end(tolerance);
    double error = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      error = std::max(
          {error, (found[k].velocity - exact[k].velocity).norm() / speed_size, (found[k].spin - exact[k].spin).norm() / spin_size});
    }
    RecordProperty("error", fmt::format("{:.1e}", error));
    EXPECT_LT(error, 10 * tolerance) << "at tolerance " << tolerance;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, Convergence,
    testing::Values(std::pair{"HertzMindlin", "normal = \"hertz\"\ntangential = \"mindlin\"\n"},
                    std::pair{"LinearEpsd2", "normal = \"linear\"\ntangential = \"linear\"\nrolling = \"epsd2\"\n"},
                    std::pair{"JkrOnOverlapCdt",
                              "normal = \"jkr\"\ndamping_on = \"overlap\"\ntangential = \"mindlin\"\nrolling = \"cdt\"\n"},
                    std::pair{"JkrAr", "normal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"ar\"\ntorque_arm = \"contact\"\n"},
                    std::pair{"Wet", "normal = \"hertz\"\ntangential = \"mindlin\"\nattraction = \"capillary\"\n"}),
    [](const auto& test) { return test.param.first; });

}  // namespace
}  // namespace scalebreak

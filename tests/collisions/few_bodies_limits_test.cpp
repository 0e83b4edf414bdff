#include <cmath>
#include <utility>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <collisions/scenes.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/bodies/few_bodies.hpp>

// The ends of what a motion may be asked: laws without friction, rolling that a rigid law stops, closed loops that it holds,
// overlaps as large as the bodies, and rest in a moving frame.

namespace scalebreak {
namespace {

using namespace tests;

MotionOutcome moved(const std::string& toml, double duration = 0) {
  return moving_scene(resolved(toml)).move({.tolerance = 1e-10, .duration = duration});
}

/// What the energies are compared with: adhesion may hold far more than the bodies bring along.
double energy_size(const EnergyAccount& account) { return account.kinetic + std::abs(account.elastic) + account.damping; }

void expect_energy_kept(const MotionOutcome& end) {
  EXPECT_NEAR(end.after.total(), end.before.total(), 1e-9 * std::max(energy_size(end.before), energy_size(end.after)));
}

class WithoutFriction : public testing::TestWithParam<const char*> {};

TEST_P(WithoutFriction, IsAsIfTheLawWereNotThere) {
  const auto scene = [&](const std::string& laws) {
    return "[contact]\nnormal = \"hertz\"\n" + laws + "[material]\nsliding_friction = 0\nrolling_friction = 0\n" + skew_pair(0.2);
  };
  const MotionOutcome with = moved(scene(GetParam())), without = moved(scene(""));
  expect_energy_kept(with);
  EXPECT_EQ(with.slides, 0);
  EXPECT_EQ(with.rolls, 0);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_LT((with.bodies[b].velocity - without.bodies[b].velocity).norm(), 1e-9 * 0.2);
    EXPECT_EQ(with.bodies[b].spin, moving_scene(resolved(scene(""))).bodies[b].spin);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, WithoutFriction,
                         testing::Values("tangential = \"mindlin\"\n", "tangential = \"linear\"\n", "rolling = \"cdt\"\n",
                                         "rolling = \"epsd\"\n", "rolling = \"epsd2\"\n", "tangential = \"mindlin\"\nrolling = \"cdt\"\n"));

/// Spheres of a micrometre, whose inertia is 1e-28 kg m², that stick.
constexpr const char* latex =
    "[contact]\nnormal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"cdt\"\ntorque_arm = \"contact\"\n"
    "[material]\nyoung = 1.5e9\npoisson = 0.33\ndensity = 1050\nsurface_energy = 0.023\nrestitution = 0.5\nrolling_friction = 0.01\n";

TEST(RigidRolling, OfMicrometreSpheresStopsAndIsHeld) {
  const MotionOutcome end = moved(std::string(latex) +
                                  "[pair]\nradius = [0.8e-6, 1e-6]\n[impact]\nnormal_speed = 0.02\n"
                                  "spin1 = [1800, -1800, 8]\nspin2 = [-1700, 170, -1300]\n");
  expect_energy_kept(end);
  EXPECT_TRUE(end.resting);
  EXPECT_LT(end.rolls, 20) << "no chatter";
  EXPECT_LT(end.steps, 2000);
  const Eigen::Vector3d normal = (end.bodies[1].position - end.bodies[0].position).normalized();
  EXPECT_LT((end.bodies[0].spin - end.bodies[1].spin).cross(normal).norm(), 1e-5 * 1800);
}

TEST(RigidRolling, HoldsAClosedLoopOfContacts) {
  constexpr double r = 0.5e-6;
  const double height = std::sqrt(3.0) * r;
  const std::string text = std::string(latex) + body_text({-r, 0, 0}, {0.02, 0, 0.001}, {900, 0, 300}, r) +
                           body_text({r, 0, 0}, {-0.02, 0, 0}, {0, 400, 0}, r) +
                           body_text({0, height, 0}, {0, -0.02, 0.002}, {-500, 300, 100}, r);
  const MovingScene scene = moving_scene(resolved(text));
  const MotionOutcome end = scene.move({.tolerance = 1e-10, .duration = 8e-10});
  expect_energy_kept(end);
  EXPECT_EQ(end.open_contacts, 3);
  EXPECT_LT((momentum(end.bodies) - momentum(scene.bodies)).norm(), 1e-12 * momentum_size(scene.bodies));
  EXPECT_LT((angular_momentum(end.bodies) - angular_momentum(scene.bodies)).norm(), 1e-12 * angular_momentum_size(scene.bodies));
  // All three contacts roll no more: the spins differ by twists about the lines of centres alone.
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    const Eigen::Vector3d normal = (end.bodies[j].position - end.bodies[i].position).normalized();
    EXPECT_LT((end.bodies[i].spin - end.bodies[j].spin).cross(normal).norm(), 1e-5 * 900);
  }
}

/// The same three to their rest: around the loop torques are shared out, and contacts that must roll at once are let go at once.
TEST(RigidRolling, OfAClosedLoopLetsGoWithoutRepeatingItself) {
  constexpr double r = 0.5e-6;
  for (const double friction : {1e-2, 1e-3, 1e-4}) {
    for (const double duration : {0.0, 1e-7}) {
      SCOPED_TRACE(fmt::format("{} {}", friction, duration));
      const std::string text = std::string(latex) + body_text({-r, 0, 0}, {0.02, 0, 0.001}, {900, 0, 300}, r) +
                               body_text({r, 0, 0}, {-0.02, 0, 0}, {0, 400, 0}, r) +
                               body_text({0, std::sqrt(3.0) * r, 0}, {0, -0.02, 0.002}, {-500, 300, 100}, r);
      const MovingScene scene = moving_scene(resolved(text, {fmt::format("material.rolling_friction={}", friction)}));
      int changes = 0;
      const MotionOutcome end =
          scene.move({.tolerance = 1e-8, .duration = duration, .on_change = [&](double, int, int, ContactChange) { ++changes; }});
      EXPECT_NEAR(end.after.total(), end.before.total(), 1e-7 * std::max(energy_size(end.before), energy_size(end.after)));
      EXPECT_LT((angular_momentum(end.bodies) - angular_momentum(scene.bodies)).norm(), 1e-12 * angular_momentum_size(scene.bodies));
      EXPECT_EQ(end.open_contacts, 3);
      EXPECT_LT(changes, 40);
      EXPECT_LT(end.steps, 40'000);
    }
  }
}

TEST(DeepOverlap, IsRefusedInASentence) {
  const std::string text = "[contact]\nnormal = \"hertz\"\n[scaling]\nlaw = \"none\"\nfactor = 1e-5\n[impact]\nnormal_speed = 20\n";
  try {
    (void)moved(text);
    FAIL() << "it was accepted";
  } catch (const WorkError& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.find("bodies 1 and 2 overlap by "), 0u) << sentence;
    EXPECT_NE(sentence.find(" m, more than the smaller radius of 0.0005 m, where no contact law holds; give a stiffer material, less "
                            "softening or slower bodies"),
              std::string::npos)
        << sentence;
  }
}

/// A drop holds the pair, and its viscosity lets it creep: the end is that nothing moves any more, wherever the pair flies to.
TEST(Settled, IsJudgedAboutTheCentreOfMass) {
  const auto scene = [](const Eigen::Vector3d& drift) {
    constexpr double r = 0.5e-3;
    return "[contact]\nnormal = \"hertz\"\nattraction = \"capillary+viscous\"\nattraction_range = \"contact\"\n"
           "[material]\nyoung = 1e8\nviscosity = 0.05\nliquid_volume = 1e-13\nseparation_min_ratio = 0.001\n" +
           body_text({0, 0, 2 * r}, drift + Eigen::Vector3d(0, 0, -0.001), {0, 0, 0}, r) + body_text({0, 0, 0}, drift, {0, 0, 0}, r);
  };
  const MotionOutcome still = moved(scene({0, 0, 0})), flying = moved(scene({0.5, 0.3, -0.2}));
  expect_energy_kept(still);
  expect_energy_kept(flying);
  EXPECT_TRUE(still.resting);
  EXPECT_TRUE(flying.resting);
  const auto apart = [](const MotionOutcome& end) {
    return Eigen::Vector3d((end.bodies[0].position - end.bodies[1].position) / end.max_overlap);
  };
  EXPECT_LT((apart(still) - apart(flying)).norm(), 1e-5);
}

}  // namespace
}  // namespace scalebreak

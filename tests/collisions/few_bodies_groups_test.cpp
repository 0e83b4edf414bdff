#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <collisions/scenes.hpp>
#include <scalebreak/collisions/bodies/few_bodies.hpp>

// More than two bodies: many contacts at once, bodies that do not give way, bridges that form and rupture, and the end.

namespace scalebreak {
namespace {

using namespace tests;

struct Followed {
  MovingScene scene;
  MotionOutcome end;
  std::map<ContactChange, int> changes;
  std::size_t most_links = 0;
};

Followed follow(const std::string& toml, double duration = 0, double tolerance = 1e-10) {
  Followed followed{.scene = moving_scene(resolved(toml))};
  std::size_t links = 0;
  followed.end = followed.scene.move({.tolerance = tolerance, .duration = duration, .on_change = [&](double, int, int, ContactChange what) {
                                        ++followed.changes[what];
                                        links += what == ContactChange::touch;
                                        links -= what == ContactChange::separation;
                                        followed.most_links = std::max(followed.most_links, links);
                                      }});
  EXPECT_NEAR(followed.end.after.total() / followed.end.before.total(), 1, 1e-9);
  EXPECT_EQ(followed.changes[ContactChange::touch], followed.end.touches);
  EXPECT_EQ(followed.changes[ContactChange::rupture], followed.end.ruptures);
  EXPECT_EQ(followed.changes[ContactChange::touch] - followed.changes[ContactChange::separation], followed.end.open_contacts);
  return followed;
}

void expect_momentum_kept(const Followed& f) {
  EXPECT_LT((momentum(f.end.bodies) - momentum(f.scene.bodies)).norm(), 1e-12 * momentum_size(f.scene.bodies));
}

constexpr double r = 0.5e-3;

TEST(Groups, CradlePassesTheImpactToItsLastSphere) {
  std::string text = "[contact]\nnormal = \"hertz\"\n[material]\nrestitution = 1\n";
  for (int k = 0; k < 5; ++k) text += body_text({2 * r * k, 0, 0}, {k == 0 ? 0.1 : 0.0, 0, 0}, {0, 0, 0}, r);
  const Followed f = follow(text);
  expect_momentum_kept(f);
  EXPECT_GE(f.most_links, 3u) << "the spheres touch: several contacts at once";
  EXPECT_NEAR(f.end.after.kinetic / f.end.before.kinetic, 1, 1e-9);
  // A Hertz cradle of touching spheres is no perfect one: the last takes nearly all, the first goes back a little.
  EXPECT_GT(f.end.bodies[4].velocity[0], 0.09);
  EXPECT_LT(f.end.bodies[0].velocity[0], 0);
  for (int k = 1; k < 5; ++k)
    EXPECT_GE(f.end.bodies[static_cast<std::size_t>(k)].velocity[0], f.end.bodies[static_cast<std::size_t>(k) - 1].velocity[0]);
}

/// A regular ring whose members fly to its middle: what each does, all do, turned.
TEST(Groups, RingKeepsItsSymmetry) {
  constexpr int count = 5;
  std::string text = "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\ntorque_arm = \"contact\"\n";
  const auto at = [&](int k, double radius) {
    return Eigen::Vector3d(radius * std::cos(2 * M_PI * k / count), radius * std::sin(2 * M_PI * k / count), 0);
  };
  for (int k = 0; k < count; ++k) text += body_text(at(k, 1.75 * r), -at(k, 0.2), {0, 0, 100}, r);
  const Followed f = follow(text);
  EXPECT_EQ(f.end.touches, count);
  const double out = f.end.bodies[0].velocity.dot(at(0, 1)), spin = f.end.bodies[0].spin[2];
  EXPECT_GT(out, 0.05);
  for (int k = 0; k < count; ++k) {
    const MovingBody& body = f.end.bodies[static_cast<std::size_t>(k)];
    EXPECT_NEAR(body.velocity.dot(at(k, 1)), out, 1e-8 * 0.2);
    EXPECT_NEAR(body.spin[2], spin, 1e-6 * 100);
  }
  EXPECT_LT((angular_momentum(f.end.bodies) - angular_momentum(f.scene.bodies)).norm(), 1e-12 * angular_momentum_size(f.scene.bodies));
}

TEST(Groups, CohesiveClumpRests) {
  std::string text =
      "[contact]\nnormal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"epsd\"\n[material]\nsurface_energy = 0.2\nrestitution = 0.5\n";
  const Eigen::Vector3d corners[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const Eigen::Vector3d& corner : corners) text += body_text(corner * (r / std::sqrt(2.0) * 1.0001), -corner * 1e-3, {0, 0, 0}, r);
  const Followed f = follow(text);
  expect_momentum_kept(f);
  EXPECT_TRUE(f.end.resting);
  EXPECT_EQ(f.end.open_contacts, 6);
  EXPECT_GT(f.end.after.damping, 0);
}

TEST(Groups, FixedBodiesStayAndTheOthersComeBack) {
  // A sphere shot into the gap between three that are fixed.
  std::string text = "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\n";
  for (int k = 0; k < 3; ++k)
    text += body_text({1.2 * r * std::cos(2.1 * k), 1.2 * r * std::sin(2.1 * k), 0}, {0, 0, 0}, {0, 0, 0}, r, true);
  text += body_text({1e-4 * r, -5e-5 * r, 1.7 * r}, {0, 0, -0.3}, {50, 0, 0}, r);
  const Followed f = follow(text);
  EXPECT_GE(f.end.touches, 3);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(f.end.bodies[k].position, f.scene.bodies[k].position);
  EXPECT_GT(f.end.bodies[3].velocity[2], 0.1);
  EXPECT_FALSE(f.end.resting);
}

TEST(Groups, BridgesFormAndRupture) {
  // One through two: it leaves a bridge to each, and each ruptures.
  const std::string text =
      "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nattraction = \"capillary+viscous\"\n[material]\nliquid_volume = 1e-15\n" +
      body_text({-2.05 * r, 0, 0}, {0.4, 0, 0}, {0, 0, 0}, r) + body_text({0, 0.99 * r, 0}, {0, 0, 0}, {0, 0, 0}, r) +
      body_text({0, -1.02 * r, 0}, {0, 0, 0}, {0, 0, 0}, r);
  Followed f = follow(text);
  expect_momentum_kept(f);
  EXPECT_GE(f.changes[ContactChange::bridge], 2);
  EXPECT_EQ(f.changes[ContactChange::bridge], f.end.ruptures);
  EXPECT_EQ(f.end.open_contacts, 0);
  EXPECT_GT(f.end.after.liquid, 0);
}

TEST(Groups, BoundPairRestsWhileAThirdFliesAwayForGood) {
  // 2 hits 1 out of the way of 0 and stays bound to what it hit.
  const std::string wet = "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nattraction = \"capillary+viscous\"\n";
  const std::string pair = body_text({0, 0, 2.02 * r}, {0, 0, -0.01}, {0, 0, 30}, r) + body_text({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, r);
  const Followed f = follow(wet + pair + body_text({4 * r, 0, 0}, {1, 0, 0}, {0, 0, 0}, r));
  EXPECT_TRUE(f.end.resting);
  EXPECT_EQ(f.end.open_contacts, 1);
  EXPECT_EQ(f.end.bodies[2].velocity[0], 1);
}

TEST(Groups, BoundPairDoesNotRestWhileAThirdIsOnItsWay) {
  const std::string wet = "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nattraction = \"capillary+viscous\"\n";
  const std::string pair = body_text({0, 0, 2.02 * r}, {0, 0, -0.01}, {0, 0, 30}, r) + body_text({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, r);
  const Followed f = follow(wet + pair + body_text({3 * r, 0, 0}, {-0.001, 0, 0}, {0, 0, 0}, r));
  EXPECT_GE(f.end.touches, 2);
}

TEST(Groups, StopAtTheirDuration) {
  const std::string text = "[contact]\nnormal = \"hertz\"\n" + body_text({0, 0, 2.2 * r}, {0, 0, -0.1}, {0, 0, 0}, r) +
                           body_text({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, r);
  const double flight = 0.2 * r / 0.1;
  for (const double duration : {0.5 * flight, flight + 2e-6, 3 * flight}) {
    const Followed f = follow(text, duration);
    EXPECT_NEAR(f.end.time / duration, 1, 1e-9);
    EXPECT_EQ(f.end.touches, duration > flight ? 1 : 0);
    EXPECT_EQ(f.end.open_contacts, duration > flight && duration < 2 * flight ? 1 : 0);
  }
}

}  // namespace
}  // namespace scalebreak

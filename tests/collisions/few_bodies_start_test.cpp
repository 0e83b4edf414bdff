#include <cmath>

#include <gtest/gtest.h>

#include <collisions/scenes.hpp>
#include <scalebreak/collisions/bodies/few_bodies.hpp>

// Contacts in their first instant: bodies that touch at rest and attract each other, and what slides or rolls from there on.

namespace scalebreak {
namespace {

using namespace tests;

constexpr double r = 0.5e-3;

std::string at_rest(const std::string& laws, double gap) {
  return "[contact]\n" + laws + body_text({0, 0, 2 * r + gap}, {0, 0, 0}, {0, 0, 0}, r) + body_text({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, r);
}

/// Without damping the pull takes the pair to where the potential is what it was at first touch, and back.
TEST(AtRest, AnAdhesivePairIsPulledTogether) {
  for (const char* range : {"full", "pull_off", "touch"}) {
    for (const double gap : {0.0, 4e-13 * r, -4e-10 * r}) {
      SCOPED_TRACE(fmt::format("{} {}", range, gap));
      const std::string laws = setting("normal", "jkr") + setting("adhesion_range", range) + setting("tangential", "mindlin");
      const MovingScene scene = moving_scene(resolved(at_rest(laws + "[material]\nrestitution = 1\n[run]\nduration = 1e-4\n", gap)));
      const MotionOutcome end = scene.move({.tolerance = 1e-10, .duration = 1e-4});
      EXPECT_GE(end.touches, 1);
      EXPECT_EQ(end.first_touch, 0);
      EXPECT_LT((momentum(end.bodies)).norm(), 1e-12 * scene.bodies[0].mass * 1e-3);
      const double deepest = std::visit(
          [](const auto& law) {
            double low = law.touch() * 1.01, high = 10 * low;
            for (int i = 0; i < 100; ++i) {
              const double middle = (low + high) / 2;
              (law.energy(middle) < 0 ? low : high) = middle;
            }
            return law.overlap(low);
          },
          scene.laws[0].laws.normal);
      EXPECT_NEAR(end.max_overlap / deepest, 1, 1e-2) << "as the steps see it";
      EXPECT_LT(std::abs(end.after.total()), 1e-9 * std::abs(end.after.elastic) + 1e-9 * end.after.kinetic);
    }
  }
}

TEST(AtRest, AnAdhesivePairSettlesWhereItsForceIsZero) {
  for (const std::string& normal : all_normals()) {
    if (normal.find("jkr") == std::string::npos) continue;
    SCOPED_TRACE(normal);
    const MovingScene scene = moving_scene(resolved(at_rest(normal + setting("rolling", "cdt") + "[material]\nrestitution = 0.3\n", 0)));
    const MotionOutcome end = scene.move({.tolerance = 1e-10});
    EXPECT_TRUE(end.resting);
    EXPECT_EQ(end.touches, 1);
    EXPECT_EQ(end.open_contacts, 1);
    EXPECT_LT(end.after.kinetic, 0.01 * end.after.damping);
    EXPECT_NEAR(end.after.total(), 0, 1e-9 * end.after.damping);
  }
}

TEST(AtRest, ADropPullsAPairTogether) {
  for (const char* range : {"contact", "bridge"}) {
    const std::string laws = setting("normal", "hertz") + setting("attraction", "capillary") + setting("attraction_range", range);
    const MotionOutcome end = moving_scene(resolved(at_rest(laws + "[material]\nrestitution = 0.5\nliquid_volume = 1e-14\n", 0)))
                                  .move({.tolerance = 1e-10, .duration = 1e-4});
    EXPECT_GE(end.touches, 1) << range;
    EXPECT_GT(end.max_overlap, 0) << range;
    EXPECT_NEAR(end.after.total(), 0, 1e-9 * std::abs(end.after.liquid)) << range;
  }
}

TEST(AtRest, AThirdBodyJoinsAnAdhesivePair) {
  const std::string text = "[contact]\nnormal = \"jkr\"\n" + body_text({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, r) +
                           body_text({2 * r, 0, 0}, {0, 0, 0}, {0, 0, 0}, r) +
                           body_text({r, std::sqrt(3.0) * r, 0}, {0, 0, 0}, {0, 0, 0}, r);
  const MovingScene scene = moving_scene(resolved(text));
  const MotionOutcome end = scene.move({.tolerance = 1e-10});
  EXPECT_EQ(end.touches, 3);
  EXPECT_EQ(end.open_contacts, 3);
  EXPECT_TRUE(end.resting);
  // Three alike: each goes to the middle by the same way.
  const Eigen::Vector3d middle(r, r / std::sqrt(3.0), 0);
  for (const MovingBody& body : end.bodies)
    EXPECT_NEAR((body.position - middle).norm(), (end.bodies[0].position - middle).norm(), 1e-8 * end.max_overlap);
}

TEST(AtRest, WithoutAttractionNothingBegins) {
  const std::string text = "[contact]\nnormal = \"hertz\"\n" + body_text({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, r) +
                           body_text({2 * r, 0, 0}, {0, 0, 0}, {0, 0, 0}, r) + body_text({9 * r, 9 * r, 0}, {0, -0.1, 0}, {0, 0, 0}, r);
  EXPECT_EQ(moving_scene(resolved(text)).move({}).touches, 0);
}

TEST(AtRest, AGapHoweverSmallIsNoContact) {
  const std::string text = at_rest(setting("normal", "jkr"), 1e-11 * r) + body_text({9 * r, 9 * r, 0}, {0, -0.1, 0}, {0, 0, 0}, r) +
                           body_text({9 * r, 6 * r, 0}, {0, 0, 0}, {0, 0, 0}, r);
  EXPECT_EQ(moving_scene(resolved(text)).move({.duration = 1e-4}).touches, 0);
}

/// Counted once: a contact that slides from its first instant to its last has begun to slide once.
TEST(FirstInstant, SlidingAndRollingFromItAreCounted) {
  const auto counts = [](double tangential_speed, double friction, double spin) {
    std::vector<ContactChange> changes;
    const MotionOutcome end =
        moving_scene(resolved(fmt::format("[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"cdt\"\n[material]\n"
                                          "sliding_friction = {}\n[impact]\ntangential_speed = {}\nspin1 = [0, {}, 0]\n",
                                          friction, tangential_speed, spin)))
            .move({.tolerance = 1e-9, .on_change = [&](double, int, int, ContactChange what) { changes.push_back(what); }});
    EXPECT_EQ(std::count(changes.begin(), changes.end(), ContactChange::slide), end.slides);
    EXPECT_EQ(std::count(changes.begin(), changes.end(), ContactChange::roll), end.rolls);
    EXPECT_EQ(changes.at(0), ContactChange::touch);
    return end;
  };
  EXPECT_EQ(counts(0.5, 0.05, 30).slides, 1);
  EXPECT_GE(counts(0.5, 0.05, 30).rolls, 1);
  EXPECT_EQ(counts(0, 0.05, 0).rolls, 0);
}

}  // namespace
}  // namespace scalebreak

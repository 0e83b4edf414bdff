#include <cmath>

#include <gtest/gtest.h>

#include <collisions/scenes.hpp>
#include <scalebreak/collisions/bodies/few_bodies.hpp>

// Oblique collisions under scaling laws against the original's, and the closed form of a linear contact.

namespace scalebreak {
namespace {

using namespace tests;

Input oblique(const std::string& contact, double speed, double young = 1e10) {
  return resolved(
      fmt::format("[contact]\n{}[material]\nyoung = {}\nsurface_energy = 0.002\n[pair]\nradius = [0.5e-3, 0.4e-3]\n[impact]\n"
                  "normal_speed = {}\ntangential_speed = {}\nspin1 = [0, {}, 0]\n",
                  contact, young, speed, 0.6 * speed, -300 * speed));
}

struct Outcome {
  MotionOutcome end;
  double normal, tangential, spin;  ///< relative speeds, and body 1's spin times the size factor
};

Outcome collide(const Input& input, const char* law, double factor) {
  const ScalingLaw& scaling = *find_scaling_law(law);
  Outcome outcome{.end = moving_scene(input, scaling, factor).move({.tolerance = 1e-11})};
  const auto& b = outcome.end.bodies;
  outcome.normal = (b[0].velocity - b[1].velocity)[2];
  outcome.tangential = (b[0].velocity - b[1].velocity)[0];
  outcome.spin = b[0].spin[1] * size_factor(scaling, factor);
  return outcome;
}

double deviation(const Outcome& scaled, const Outcome& original, double speed) {
  return std::max({std::abs(scaled.normal - original.normal), std::abs(scaled.tangential - original.tangential),
                   0.5e-3 * std::abs(scaled.spin - original.spin)}) /
         speed;
}

constexpr const char* sliding = "normal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"epsd2\"\ntorque_arm = \"contact\"\n";
constexpr const char* adhesive = "normal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"ar\"\ntorque_arm = \"contact\"\n";

/// RPS keeps a pair's outcome but for the geometry: what it changes is of the order of the overlap over the radius, which grows
/// as Ω^{−2/5}.
TEST(FewBodiesScaling, RpsDeviatesByTheOverlapOverTheRadius) {
  for (const char* contact : {sliding, adhesive}) {
    constexpr double speed = 0.3;
    const Input input = oblique(contact, speed);
    const Outcome original = collide(input, "rps", 1);
    for (const double factor : {1e-1, 1e-2, 1e-3}) {
      const Outcome scaled = collide(input, "rps", factor);
      const double overlap = scaled.end.max_overlap / 0.4e-3;
      EXPECT_NEAR(scaled.end.max_overlap / original.end.max_overlap / std::pow(factor, -0.4), 1, 10 * overlap);
      EXPECT_LT(deviation(scaled, original, speed), 10 * overlap) << factor;
    }
    const double coarse = deviation(collide(input, "rps", 1e-3), original, speed),
                 fine = deviation(collide(input, "rps", 1e-2), original, speed);
    EXPECT_LT(fine, 0.7 * coarse);
  }
}

/// SUP is m_S = l³ m_O under l² F_O over a time l times longer: every speed of the centres is the original's, whatever the overlap.
TEST(FewBodiesScaling, SupKeepsTheNormalOutcomeExactly) {
  const Input head_on = resolved("[contact]\nnormal = \"jkr\"\n[pair]\nradius = [0.5e-3, 0.4e-3]\n[impact]\nnormal_speed = 0.3\n");
  const Outcome original = collide(head_on, "sup", 1), scaled = collide(head_on, "sup", 4);
  EXPECT_NEAR(scaled.normal / original.normal, 1, 1e-9);
  EXPECT_NEAR(scaled.end.max_overlap / original.end.max_overlap, 4, 1e-8);
  EXPECT_NEAR((scaled.end.last_separation - scaled.end.first_touch) / (original.end.last_separation - original.end.first_touch), 4, 1e-8);
  EXPECT_NEAR(scaled.end.max_force / original.end.max_force, 16, 1e-3);
}

/// A linear pair without damping that never slides: the tangential speed of the surfaces is a cosine of frequency √(k_t/m_t),
/// 1/m_t = (1 + 5/2)/m*, for the time π √(m*/k) that the contact lasts; with k_t = n² k/3.5 the spring is at rest at its end, so that
/// no last sliding disturbs it. The line of centres turns by the overlap over the distance, which a slow impact makes small.
TEST(FewBodies, LinearSpringsWithoutSlidingFollowTheirCosine) {
  for (const int n : {1, 2}) {
    double last = 1;
    for (const double speed : {10.0, 0.1, 1e-3}) {
      constexpr double k = 1e11;
      const auto input = resolved(
          fmt::format("[contact]\nnormal = \"linear\"\ntangential = \"linear\"\n[material]\nrestitution = 1\nsliding_friction = 1000\n"
                      "spring_constant = {}\nspring_constant_tangential = {:.17g}\n[pair]\nradius = [0.5e-3, 0.5e-3]\n"
                      "[impact]\nnormal_speed = {}\ntangential_speed = {}\n",
                      k, n * n / 3.5 * k, speed, 0.1 * speed));
      const MotionOutcome end = moving_scene(input).move({.tolerance = 1e-12});
      const auto& b = end.bodies;
      const double surface = (b[0].velocity - b[1].velocity)[0] - 0.5e-3 * (b[0].spin[1] + b[1].spin[1]);
      last = std::abs(surface / (0.1 * speed) - std::cos(n * M_PI));
      EXPECT_LT(last, 20 * end.max_overlap / 1e-3 + 1e-9) << speed;
      EXPECT_NEAR((end.last_separation - end.first_touch) / (M_PI * std::sqrt(sphere_mass(0.5e-3, 2500) / 2 / k)), 1,
                  1e-9 + 20 * end.max_overlap / 1e-3);
    }
    EXPECT_LT(last, 1e-8);
  }
}

}  // namespace
}  // namespace scalebreak

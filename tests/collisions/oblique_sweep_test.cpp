#include <cmath>

#include <gtest/gtest.h>

#include <collisions/scenes.hpp>
#include <scalebreak/collisions/oblique/oblique_collision.hpp>

// Outcomes of oblique impacts as a function of the angle are continuous, with kinks where a slide or a roll begins or ends: a step that
// does not shrink with the angle's is a jump, and a mistake of the engine.

namespace scalebreak {
namespace {

using namespace tests;

constexpr double degree = M_PI / 180, speed = 0.1;

/// Tangential speed, surface speeds of both spins and normal speed after, over the impact's.
using Outcome = std::array<double, 4>;

struct Sweep {
  MovingScene scene;
  ObliquePair pair;

  explicit Sweep(const std::string& laws)
      : scene(moving_scene(resolved("[contact]\n" + laws + "[pair]\nradius = [0.5e-3, 0.8e-3]\n[impact]\ntangential_speed = 0.01\n"))) {
    const MovingBody &a = scene.bodies[0], &b = scene.bodies[1];
    pair = {.laws = scene.laws[0].laws,
            .mass = a.mass * b.mass / (a.mass + b.mass),
            .radius = {a.radius, b.radius},
            .inertia = {a.inertia, b.inertia},
            .distance = a.radius + b.radius};
  }
  [[nodiscard]] Outcome at(double angle) const {
    const ObliqueOutcome o = resolve_oblique_collision(pair, {speed * std::cos(angle), speed * std::sin(angle), {20, -35}}, 1e-9);
    EXPECT_FALSE(o.stuck);
    return {o.tangential_speed / speed, o.spin[0] * pair.radius[0] / speed, o.spin[1] * pair.radius[1] / speed, o.normal_speed / speed};
  }
};

double step(const Outcome& a, const Outcome& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

class AngleSweep : public testing::TestWithParam<std::string> {};

TEST_P(AngleSweep, HasNoJump) {
  const Sweep sweep(GetParam());
  constexpr int steps = 320, halvings = 14;
  constexpr double last = 80 * degree;
  std::vector<Outcome> all;
  for (int i = 0; i <= steps; ++i) all.push_back(sweep.at(last * i / steps));
  std::vector<std::pair<double, int>> sizes;
  for (int i = 0; i < steps; ++i) {
    const auto n = static_cast<std::size_t>(i);
    // How much a step differs from the ones beside it.
    const double own = step(all[n], all[n + 1]), before = i > 0 ? step(all[n - 1], all[n]) : own,
                 after = i + 1 < steps ? step(all[n + 1], all[n + 2]) : own;
    sizes.emplace_back(own - std::min(before, after), i);
  }
  std::sort(sizes.rbegin(), sizes.rend());
  for (std::size_t k = 0; k < 6; ++k) {
    const int i = sizes[k].second;
    double low = last * i / steps, high = last * (i + 1) / steps;
    Outcome at_low = all[static_cast<std::size_t>(i)], at_high = all[static_cast<std::size_t>(i) + 1];
    const double whole = step(at_low, at_high);
    for (int h = 0; h < halvings; ++h) {
      const double middle = (low + high) / 2;
      const Outcome at_middle = sweep.at(middle);
      if (step(at_low, at_middle) > step(at_middle, at_high)) {
        high = middle, at_high = at_middle;
      } else {
        low = middle, at_low = at_middle;
      }
    }
    // A step shrinks as the angle's, at worst as its square root.
    EXPECT_LT(step(at_low, at_high), whole / 50 + 1e-7) << "at " << low / degree << " degrees, of " << whole;
  }
}

std::vector<std::string> laws() {
  std::vector<std::string> all;
  for (const std::string& normal : {setting("normal", "hertz"), setting("normal", "jkr") + setting("damping_on", "overlap") +
                                                                    setting("tangential_radius", "overlap")}) {
    for (const char* rolling : {"none", "cdt", "epsd", "epsd2", "ar"})
      all.push_back(normal + setting("tangential", "mindlin") + setting("rolling", rolling));
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Laws, AngleSweep, testing::ValuesIn(laws()));

}  // namespace
}  // namespace scalebreak

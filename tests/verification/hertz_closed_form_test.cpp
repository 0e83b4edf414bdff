#include <cmath>

#include <gtest/gtest.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>

// Hertz: the undamped collision in closed form (Landau & Lifshitz), and the damped one, whose restitution is that put
// in (Antypov & Elliott, EPL 94 (2011) 50004).

namespace scalebreak {
namespace {

ScaledContact hertz(const Bodies& bodies) { return {canonical({.normal = NormalModel::hertz}), bodies, *find_scaling_law("none"), 1}; }

Bodies pair_of(double restitution, double radius1 = 0.5e-3, double radius2 = 0.8e-3) {
  Material m;
  m.restitution = restitution, m.surface_energy = 0;
  return {m, m, {}, {radius1, radius2}};
}

TEST(Hertz, UndampedHasTheClosedFormOverlapForceAndTime) {
  const Bodies bodies = pair_of(1);
  const NormalPair p = bodies.pair();
  for (const double v : {1e-3, 0.1, 7.0}) {
    const double overlap = std::pow(15.0 / 16, 0.4) * std::pow(p.mass * v * v / (p.young * std::sqrt(p.radius)), 0.4);
    const double force = 1.2826894 * std::pow(std::pow(p.mass, 3) * std::pow(v, 6) * std::pow(p.young, 2) * p.radius, 0.2);
    const PairCollision c = hertz(bodies).collide(v, 1e-10, true);
    EXPECT_NEAR(c.restitution, 1, 1e-8);
    EXPECT_NEAR(c.max_overlap / overlap, 1, 1e-8);
    EXPECT_NEAR(c.max_force / force, 1, 3e-8);  // the constant is given to eight digits
    EXPECT_NEAR(*c.contact_time / (2.9432752 * overlap / v), 1, 3e-8);
  }
}

TEST(Hertz, DampedReturnsTheRestitutionPutInAtEverySpeed) {
  for (const double e : {0.05, 0.1, 0.3, 0.5, 0.81, 0.97, 1.0}) {
    for (const double v : {1e-4, 1e-2, 0.3, 4.0, 100.0}) EXPECT_NEAR(hertz(pair_of(e)).collide(v, 1e-10).restitution, e, 1e-8);
  }
}

TEST(Linear, DampedIsTheDampedOscillatorsHalfPeriod) {
  for (const double e : {0.05, 0.5, 0.9, 1.0}) {
    const Bodies bodies = pair_of(e);
    const NormalPair p = bodies.pair();
    const ScaledContact contact(canonical({.normal = NormalModel::linear}), bodies, *find_scaling_law("none"), 1);
    const PairCollision c = contact.collide(0.2, 1e-10);
    const double frequency = std::sqrt(p.spring_constant / p.mass * (1 - p.damping_ratio * p.damping_ratio));
    EXPECT_NEAR(c.restitution, e, 1e-8);
    EXPECT_NEAR(*c.contact_time * frequency, 3.14159265358979, 1e-8);
  }
}

}  // namespace
}  // namespace scalebreak

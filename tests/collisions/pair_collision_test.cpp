#include <gtest/gtest.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>

namespace scalebreak {
namespace {

TEST(Trajectory, RunsFromTouchToSeparationWithTheOutcome) {
  const ScaledContact contact = contact_of(Input{});
  const double speed = Input{}.normal_speed;
  const PairCollision c = contact.collide(speed, 1e-10, true);
  const auto path = contact.trajectory(speed, 1e-10, 400);
  EXPECT_GT(path.size(), 200u);
  EXPECT_LT(path.size(), 900u);
  EXPECT_EQ(path.front().time, 0);
  EXPECT_NEAR(path.front().speed, speed, 1e-15);
  EXPECT_NEAR(path.back().time / *c.contact_time, 1, 1e-8);
  EXPECT_NEAR(-path.back().speed / speed, c.restitution, 1e-8);
  EXPECT_NEAR(-path.back().overlap, contact.end_gap(speed), 1e-8 * c.max_overlap);
  double deepest = 0, strongest = 0;
  for (const TrajectoryPoint& p : path)
    deepest = std::max(deepest, p.overlap), strongest = std::max(strongest, p.elastic_force + p.damping_force);
  EXPECT_NEAR(deepest / c.max_overlap, 1, 1e-3);
  EXPECT_NEAR(strongest / c.max_force, 1, 1e-3);
}

TEST(ScaledContact, AgainstAFixedBodyIsThatOfTheOtherOneAlone) {
  const Material glass;
  const ScaledContact fixed({}, {glass, glass, {}, {1e-3, 2e-3}}, *find_scaling_law("none"), 1, {true, false});
  const ScaledContact free({}, {glass, glass, {}, {1e-3, 2e-3}}, *find_scaling_law("none"), 1);
  EXPECT_DOUBLE_EQ(fixed.scaled().pair.mass, sphere_mass(2e-3, glass.density));
  EXPECT_DOUBLE_EQ(fixed.scaled().pair.radius, free.scaled().pair.radius);
  EXPECT_LT(*fixed.sticking_speed(1e-10), *free.sticking_speed(1e-10)) << "the heavier pair is harder to hold";
}

TEST(ScaledContact, TearingTakesWhatTheUndampedStickingSpeedBrings) {
  Input input;
  input.material.restitution = input.second.restitution = 1;
  for (const char* law : {"none", "sakai"}) {
    input.scaling_law = law, input.scaling_factor = law == std::string("none") ? 1 : 3;
    const ScaledContact contact = contact_of(input);
    const ScaledPair& scaled = contact.scaled();
    const double stick = *contact.sticking_speed(1e-12);
    EXPECT_NEAR(contact.tearing_energy() / (scaled.pair.mass * stick * stick / 2 * scaled.force * scaled.overlap), 1, 1e-9) << law;
    EXPECT_GT(contact.well_depth(), 0);
  }
}

}  // namespace
}  // namespace scalebreak

#include <cmath>

#include <gmock/gmock.h>

#include <scalebreak/ensembles/prediction/scale_groups.hpp>

#include <ensembles/prediction_scenes.hpp>

namespace scalebreak::tests {
namespace {

TEST(ScaleGroups, HaveTheContactTimeOfHertz) {
  const ScaleGroups groups = scale_groups(resolved(undamped));
  const Input input = resolved(undamped);
  const NormalPair pair = sphere_pair(input.material, 0.5e-3, input.material, 0.5e-3);
  // δ_max = (15/16)^{2/5} (m* v²/(E* √R*))^{2/5}, t_c = 2.9432752 δ_max / v.
  const double v = groups.impact_speed;
  const double depth = std::pow(15.0 / 16 * pair.mass * v * v / (pair.young * std::sqrt(pair.radius)), 0.4);
  EXPECT_NEAR(groups.contact_time / (2.9432752 * depth / v), 1, 1e-5);
  EXPECT_NEAR(groups.overlap / (depth / pair.radius), 1, 1e-5);
  EXPECT_EQ(groups.busy, groups.contact_time * groups.collision_rate);
  EXPECT_TRUE(std::isinf(groups.impact_over_sticking));
  EXPECT_EQ(groups.collisional_share, 1);
  EXPECT_EQ(groups.bond, 0);
}

TEST(ScaleGroups, SofteningStretchesTheContactTime) {
  const ScaleGroups original = scale_groups(resolved(undamped)), soft = scale_groups(with(undamped, "rps", 1e-3));
  EXPECT_NEAR(soft.busy / original.busy, std::pow(1e-3, -0.4), 1e-4);
  EXPECT_EQ(soft.collision_rate, original.collision_rate);
}

TEST(ScaleGroups, EnlargedSpheresMoveFasterInShear) {
  const ScaleGroups original = scale_groups(resolved(undamped)), large = scale_groups(with(undamped, "sup", 2));
  EXPECT_NEAR(large.impact_speed / original.impact_speed, 2, 1e-9);
  EXPECT_NEAR(large.collision_rate / original.collision_rate, 1, 1e-9);
  EXPECT_NEAR(large.contact_time / original.contact_time, 2 * std::pow(2, -0.2), 1e-4);  // t_c ∝ l v^{−1/5}
  EXPECT_EQ(large.size, 2);
  EXPECT_EQ(large.torque_lack, 1);  // force × l², torque × l² where l³ would keep it
  EXPECT_EQ(scale_groups(with(undamped, "torque_cubed", 2)).torque_lack, 0);
}

TEST(ScaleGroups, OnlyRpsKeepsTheStickingSpeed) {
  const ScaleGroups original = scale_groups(resolved(cohesive));
  ASSERT_GT(original.impact_over_sticking, 1);
  EXPECT_NEAR(scale_groups(with(cohesive, "rps", 1e-2)).impact_over_sticking / original.impact_over_sticking, 1, 1e-4);
  EXPECT_NEAR(scale_groups(with(cohesive, "none", 1e-2)).impact_over_sticking / original.impact_over_sticking, std::pow(1e-2, 1.0 / 3),
              1e-3);
  // Pull-off force over pressure × d²: kept by softening alone, lowered by RPS with γ.
  EXPECT_NEAR(scale_groups(with(cohesive, "none", 1e-2)).bond / original.bond, 1, 1e-9);
  EXPECT_NEAR(scale_groups(with(cohesive, "rps", 1e-2)).bond / original.bond, std::pow(1e-2, 0.4), 1e-9);
}

TEST(ScaleGroups, ImposedPressureSetsTheInertialNumber) {
  Input input = resolved(undamped);
  input.cell.pressure = 1e6;
  const ScaleGroups groups = scale_groups(input);
  EXPECT_NEAR(groups.inertial_number, 100 * 1e-3 * std::sqrt(input.material.density / 1e6), 1e-12);
  EXPECT_LT(groups.collisional_share, 0.01);  // what collisions carry of such a pressure
}

TEST(ScaleGroups, LoadPressesSpheresTogether) {
  const ScaleGroups original = scale_groups(pressed("none", 1, 0.1)), large = scale_groups(pressed("sup", 2, 0.1)),
                    soft = scale_groups(pressed("rps", 0.1, 0.1));
  EXPECT_EQ(original.regime, FlowRegime::pressed);
  // Hertz: F = 4/3 E* √R* δ^{3/2} with F = P d² and d = 4 R*.
  const double young = 1e8 / (2 * (1 - 0.25 * 0.25)), force = 1000 * 1e-6, radius = 0.25e-3;
  EXPECT_NEAR(original.pressed_overlap, std::pow(0.75 * force / (young * std::sqrt(radius)), 2.0 / 3) / radius,
              1e-6 * original.pressed_overlap);
  EXPECT_NEAR(large.pressed_overlap / original.pressed_overlap, 1, 1e-9);  // forces grow as l², as the load
  EXPECT_NEAR(soft.pressed_overlap / original.pressed_overlap, std::pow(10, 2.0 / 3), 1e-6);
}

TEST(ScaleGroups, GasCoolsByHaffsLaw) {
  const ScaleGroups original = scale_groups(resolved(cooling)), large = scale_groups(with(cooling, "none", 2));
  EXPECT_EQ(original.regime, FlowRegime::cooling);
  EXPECT_EQ(original.jamming_share, 0);
  const double haff = (1 - 0.81) / 6 * original.collision_rate * 0.05;
  EXPECT_NEAR(original.cooled / haff, 1, 1e-4);
  EXPECT_NEAR(large.cooled / haff, 0.5, 1e-4);  // twice as large spheres meet half as often
  Input sticky = resolved(cooling);
  sticky.contact.normal = NormalModel::jkr, sticky.material.surface_energy = 0.02;
  const ScaleGroups long_after = scale_groups(sticky);
  EXPECT_NEAR(long_after.gas.collision.restitution, 0.9, 2e-3);  // what adhesion takes is not the dashpot's
  sticky.run.warmup_duration = 0, sticky.run.duration = 1e-9;
  const double slower = long_after.impact_over_sticking / scale_groups(sticky).impact_over_sticking;
  EXPECT_NEAR(slower * (1 + long_after.cooled), 1, 1e-6);
  EXPECT_LT(slower, 1 / (1 + haff));  // what sticks is lost
}

TEST(ScaleGroups, GasHasTheInertiaThatItsTorquesMeet) {
  EXPECT_NEAR(scale_groups(with(cooling, "none", 2)).gas.collision.inertia, 0.4, 1e-12);
  EXPECT_NEAR(scale_groups(with(cooling, "sup", 2)).gas.collision.inertia, 0.8, 1e-12);
}

}  // namespace
}  // namespace scalebreak::tests

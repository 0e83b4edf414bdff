#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <Eigen/Dense>

#include <scalebreak/ensembles/prediction/cooling_gas.hpp>

namespace scalebreak::tests {
namespace {

using Eigen::Vector3d;

CoolingGas smooth_gas() {
  return {.collision = {.restitution = 0.9}, .temperature = 2e-3, .collision_rate = 400, .begin = 0.05, .end = 0.2};
}

TEST(CoolingGas, SmoothSpheresCoolByHaffsLaw) {
  const CoolingGas gas = smooth_gas();
  const CooledGas cooled = cool(gas, -0.3);
  const double rate = (1 - 0.81) / 6 * gas.collision_rate, begin = 1 + rate * gas.begin, end = 1 + rate * gas.end;
  EXPECT_NEAR(cooled.last_temperature / gas.temperature, 1 / (end * end), 1e-6);
  EXPECT_NEAR(cooled.mean.translational / gas.temperature, 1 / (begin * end), 1e-6);  // ∫dt/(1 + rt)² between
  EXPECT_NEAR(cooled.collision_rate / gas.collision_rate, std::log(end / begin) / (end - begin), 1e-6);
  EXPECT_EQ(cooled.mean.rotational, 0);
}

TEST(CoolingGas, ContactsThatLastSlowIt) {
  CoolingGas gas = smooth_gas();
  gas.busy = 0.5, gas.contact_time_power = 1;  // then it stays busy as it cools
  const CooledGas cooled = cool(gas, -2);
  const double rate = (1 - 0.81) / 6 * gas.collision_rate / (1.5 * 1.5);
  EXPECT_NEAR(cooled.last_temperature / gas.temperature, std::pow(1 + rate * gas.end, -2), 1e-6);
  EXPECT_NEAR(cooled.busy, 0.5, 1e-12);
  gas.contact_time_power = 0.2;
  EXPECT_NEAR(cool(gas, 0).busy, 0.5 * std::pow(cool(gas, 0).mean.translational / gas.temperature, 0.4), 1e-12);
}

TEST(CoolingGas, ThatIsNotAskedForALaterTimeIsTheOneAtTheStart) {
  CoolingGas gas = smooth_gas();
  gas.begin = gas.end = 0;
  EXPECT_EQ(cool(gas, -0.3).mean.translational, gas.temperature);
  EXPECT_EQ(cool(gas, 0).collision_rate, gas.collision_rate);
}

/// What one collision of two spheres of mass 1 and radius 1 does, vector by vector: half of what 2E changes by, in translation and rotation.
GasTemperatures change(const RoughCollision& c, const Vector3d& motion, const Vector3d& spins, const Vector3d& normal) {
  const double approach = motion.dot(normal);
  const Vector3d surface = motion - approach * normal + spins.cross(normal);
  const double bounce = approach > c.sticking_speed ? std::sqrt(1 - std::pow(c.sticking_speed / approach, 2)) * c.restitution : 0;
  // Friction goes by the impact without adhesion.
  const double sliding = c.friction * (1 + c.restitution) * approach / 2, holding = surface.norm() / (2 * (1 + 1 / c.inertia));
  const Vector3d impulse = -(1 + bounce) * approach / 2 * normal - std::min(sliding, holding) * surface.normalized();
  // Of relative velocity u, u²/2 of 2E is in translation; both spins change by (n × P)/I, their sum by twice that.
  const Vector3d after = motion + 2 * impulse, turned = 2 / c.inertia * normal.cross(impulse);
  return {(after.squaredNorm() - motion.squaredNorm()) / 4, c.inertia * ((spins + turned).squaredNorm() - spins.squaredNorm()) / 4};
}

TEST(CoolingGas, ChangeIsTheMeanOverCollisions) {
  std::mt19937_64 stream(3);
  std::normal_distribution<double> normal;
  const auto vector = [&](double variance) -> Vector3d {
    return Vector3d(normal(stream), normal(stream), normal(stream)) * std::sqrt(variance);
  };
  for (const auto& [c, at] : std::vector<std::pair<RoughCollision, GasTemperatures>>{
           {{.restitution = 0.8, .friction = 0.3}, {1, 0.01}},
           {{.restitution = 0.8, .friction = 0.3}, {1, 3}},
           {{.restitution = 0.9, .friction = 0.1, .inertia = 0.8, .sticking_speed = 0.7}, {1.5, 0.5}}}) {
    double weight = 0, t = 0, r = 0, tt = 0, rr = 0;
    constexpr int collisions = 400000;
    for (int i = 0; i < collisions; ++i) {
      const Vector3d motion = vector(2 * at.translational), spins = vector(2 * at.rotational / c.inertia);
      const double approach = motion.z();
      if (approach <= 0) continue;
      const GasTemperatures d = change(c, motion, spins, Vector3d::UnitZ());
      weight += approach, t += approach * d.translational, r += approach * d.rotational;
      tt += std::pow(approach * d.translational, 2), rr += std::pow(approach * d.rotational, 2);
    }
    const GasTemperatures expected = change_by_collision(c, at);
    EXPECT_NEAR(t / weight, expected.translational, 4 * std::sqrt(tt) / weight);
    EXPECT_NEAR(r / weight, expected.rotational, 4 * std::sqrt(rr) / weight);
    EXPECT_LT(4 * std::sqrt(rr) / weight, 0.05 * std::abs(expected.rotational));
  }
}

TEST(CoolingGas, SticksBelowItsStickingSpeed) {
  // Of approach speeds v, collisions have v exp(−v²/4T).
  const double temperature = 0.7, sticking = 0.5;
  double stuck = 0, all = 0;
  for (double v = 0.0005; v < 20; v += 0.001) {
    const double w = v * std::exp(-v * v / (4 * temperature));
    all += w, stuck += v < sticking ? w : 0;
  }
  EXPECT_NEAR(sticking_share(sticking, temperature), stuck / all, 1e-4);
}

}  // namespace
}  // namespace scalebreak::tests

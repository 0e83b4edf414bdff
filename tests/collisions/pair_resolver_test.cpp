#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <collisions/scenes.hpp>
#include <lib/surroundings.hpp>
#include <scalebreak/collisions/tables/pair_resolver.hpp>

// Outcomes of pairs by table against the engine of bodies in space, which shares neither variables nor equations of motion with the
// planar engine that made the tables.

namespace scalebreak {
namespace {

using Eigen::Vector3d;
using tests::resolved;

/// One folder for all tests of a run: most share their tables.
TableStore store() {
  static const tests::TemporaryFolder folder;
  return {.folder = folder.path()};
}

struct Laws {
  const char* normal;
  const char* rolling;
};

Input glass(const Laws& laws, double young, const std::string& more = "") {
  // The adhesion that keeps the reduced numbers.
  return resolved(
      fmt::format("[material]\nyoung = {:g}\nsurface_energy = {:g}\n[contact]\nnormal = \"{}\"\nrolling = \"{}\"\n"
                  "tangential = \"mindlin\"\ntorque_arm = \"contact\"\n{}",
                  young, 0.02 * std::pow(young / 1e10, 0.4), laws.normal, laws.rolling, more));
}

constexpr double radius = 0.5e-3;

/// Impacts in space: sliding, rolling and twist in any direction, the centres moving past each other in another.
struct Impacts {
  std::mt19937 random{23};
  std::uniform_real_distribution<double> uniform{-1, 1};
  double slowest, fastest;

  Vector3d vector() { return {uniform(random), uniform(random), uniform(random)}; }
  PairImpact in_space() {
    const double speed = slowest * std::pow(fastest / slowest, std::abs(uniform(random)));
    const Vector3d normal = vector().normalized(), past = vector(), drift = speed * vector();
    PairImpact impact{.normal = normal};
    impact.velocity = {drift + speed * (normal + 1.5 * (past - normal * past.dot(normal))), drift};
    impact.spin = {speed / radius * vector(), speed / radius * vector()};
    return impact;
  }
  /// All in one plane, without rolling.
  PairImpact in_plane() {
    PairImpact impact = in_space();
    const Vector3d along = impact.normal.unitOrthogonal(), across = impact.normal.cross(along);
    const double speed = (impact.velocity[0] - impact.velocity[1]).dot(impact.normal);
    impact.velocity[0] = impact.velocity[1] + speed * (impact.normal + 1.5 * uniform(random) * along);
    impact.spin[0] = impact.spin[1] = speed / radius * uniform(random) * across;
    return impact;
  }
};

double normal_speed(const PairImpact& impact) { return (impact.velocity[0] - impact.velocity[1]).dot(impact.normal); }
double slide_ratio(const PairImpact& impact) {
  const Vector3d v = impact.velocity[0] - impact.velocity[1] + (radius * (impact.spin[0] + impact.spin[1])).cross(impact.normal);
  return (v - impact.normal * v.dot(impact.normal)).norm() / normal_speed(impact);
}

double centres_ratio(const PairImpact& impact) {
  return (impact.velocity[0] - impact.velocity[1]).cross(impact.normal).norm() / normal_speed(impact);
}

double difference(const PairOutcome& a, const PairOutcome& b, const PairImpact& impact) {
  double largest = 0;
  for (std::size_t i = 0; i < 2; ++i)
    largest = std::max({largest, (a.velocity[i] - b.velocity[i]).norm(), radius * (a.spin[i] - b.spin[i]).norm()});
  return largest / normal_speed(impact);
}

class Resolver : public testing::TestWithParam<Laws> {
 protected:
  bool adhesive_ = std::string(GetParam().normal) == "jkr";
  PairTolerance tolerance_{.oblique = adhesive_ ? 1e-3 : 1e-4, .turning = 1, .exact = 1e-9};  // at 1e-4 a JKR table takes half a minute
  Impacts impacts_{.slowest = adhesive_ ? 0.02 : 0.1, .fastest = adhesive_ ? 0.5 : 0.1};
};

/// Within the tables' tolerance and what the turning leaves out, by its estimate: sliding and rolling in any two directions.
TEST_P(Resolver, LooksUpWhatTheEngineOfBodiesFinds) {
  for (const double young : {1e12, 1e8}) {
    const PairResolver pair(glass(GetParam(), young), store(), tolerance_);
    std::vector<double> all;
    for (int i = 0; i < 200; ++i) {
      const PairImpact impact = impacts_.in_space();
      const PairOutcome found = pair.look_up(impact), exact = pair.integrate(impact);
      ASSERT_EQ(found.refusal, Refusal::none) << to_string(found.refusal);
      const double error = difference(found, exact, impact);
      EXPECT_LT(error, (1 + slide_ratio(impact)) * tolerance_.oblique + found.turning_error) << young << ' ' << i;
      // Contact time and displacement know nothing of the turning: their error is its first order.
      const double turned = found.displacement.cross(impact.normal).norm() / (2 * radius), way = 1 + centres_ratio(impact);
      EXPECT_NEAR(found.contact_time / exact.contact_time, 1, 1e-5 + turned * way);
      EXPECT_LT((found.displacement - exact.displacement).norm(),
                exact.contact_time * normal_speed(impact) * (2 * tolerance_.oblique + turned * way * way));
      all.push_back(error);
    }
    std::nth_element(all.begin(), all.begin() + 100, all.end());
    EXPECT_LT(all[100], young > 1e10 ? 0.5 * tolerance_.oblique : 2e-3);
  }
}

/// In one plane the first order is corrected: at overlaps of 2e-3 of the distance, which turn the normal by a per cent, less than 1e-3 is left.
TEST_P(Resolver, LeavesASecondOrderInOnePlane) {
  const PairResolver pair(glass(GetParam(), 1e8), store(), tolerance_);
  for (int i = 0; i < 200; ++i) {
    const PairImpact impact = impacts_.in_plane();
    const PairOutcome found = pair.look_up(impact);
    EXPECT_LT(difference(found, pair.integrate(impact), impact), (1 + slide_ratio(impact)) * tolerance_.oblique + 1e-3) << i;
  }
}

TEST_P(Resolver, KeepsMomentumAndAngularMomentum) {
  const PairResolver pair(glass(GetParam(), 1e8), store(), tolerance_);
  const CollidingPair& p = pair.pair();
  const double mass = p.mass[0] / 2, distance = p.radius[0] + p.radius[1];
  for (int i = 0; i < 50; ++i) {
    const PairImpact impact = impacts_.in_space();
    const PairOutcome found = pair.look_up(impact);
    const double size = normal_speed(impact);
    EXPECT_LT((found.velocity[0] + found.velocity[1] - impact.velocity[0] - impact.velocity[1]).norm(), 1e-14 * size * 10);
    const auto turning = [&](const Vector3d& apart, const auto& velocity, const auto& spin) {
      return Vector3d(mass * apart.cross(velocity[0] - velocity[1]) + p.inertia[0] * (spin[0] + spin[1]));
    };
    const Vector3d apart = -distance * impact.normal;
    EXPECT_LT((turning(apart + found.displacement, found.velocity, found.spin) - turning(apart, impact.velocity, impact.spin)).norm(),
              1e-13 * mass * distance * size);
  }
}

INSTANTIATE_TEST_SUITE_P(LawPairs, Resolver,
                         testing::Values(Laws{"hertz", "none"}, Laws{"hertz", "cdt"}, Laws{"hertz", "epsd"}, Laws{"hertz", "epsd2"},
                                         Laws{"jkr", "none"}, Laws{"jkr", "cdt"}, Laws{"jkr", "epsd"}, Laws{"jkr", "epsd2"},
                                         Laws{"jkr", "ar"}),
                         [](const auto& test) { return std::string(test.param.normal) + "_" + test.param.rolling; });

TEST(PairResolver, IntegratesAndCountsWhatTheTablesRefuse) {
  const Laws hertz_cdt{"hertz", "cdt"};
  const auto once = [](const Input& input, Refusal reason, double speed, const PairTolerance& tolerance) {
    PairResolver pair(input, store(), tolerance);
    Impacts impacts{.slowest = speed, .fastest = speed};
    const PairImpact impact = impacts.in_space();
    const PairOutcome outcome = pair.collide(impact);
    EXPECT_EQ(outcome.refusal, reason) << to_string(outcome.refusal);
    EXPECT_EQ(pair.count(reason), 1);
    EXPECT_EQ(difference(outcome, pair.integrate(impact), impact), 0);
    return outcome;
  };
  const PairTolerance rough{.normal = 1e-4, .oblique = 1e-3, .turning = 1e-2};
  once(glass(hertz_cdt, 1e10, "[pair]\nradius = [0.5e-3, 0.4e-3]\n"), Refusal::coupled, 0.1, rough);
  once(glass(hertz_cdt, 1e10, "attraction = \"capillary\"\n"), Refusal::liquid, 0.1, rough);
  once(glass({"hertz", "none"}, 1e8), Refusal::turns_too_far, 0.1, {.normal = 1e-4, .oblique = 1e-3, .turning = 1e-6});
  once(glass({"hertz", "ar"}, 1e10), Refusal::no_table, 0.1, rough);
  EXPECT_TRUE(once(glass({"jkr", "none"}, 1e10), Refusal::sticks, 1e-4, rough).stuck);
  // Unlike spheres have their table as long as nothing resists their rolling.
  PairResolver unlike(glass({"hertz", "none"}, 1e12, "[pair]\nradius = [0.5e-3, 0.4e-3]\n"), store(), rough);
  Impacts impacts{.slowest = 0.1, .fastest = 0.1};
  for (int i = 0; i < 20; ++i) {
    const PairImpact impact = impacts.in_space();
    EXPECT_LT(difference(unlike.collide(impact), unlike.integrate(impact), impact), 3e-3);
  }
  EXPECT_EQ(unlike.count(Refusal::none), 20);
}

TEST(PairResolver, LooksUpAWall) {
  for (const char* arm : {"radius", "contact"}) {
    const Input input =
        resolved(std::string("[material]\nyoung = 1e11\n[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\ntorque_arm = \"") + arm +
                 "\"\n[pair]\npartner = \"wall\"\nradius = [0.5e-3]\n");
    PairResolver pair(input, store(), {.exact = 1e-9});
    Impacts impacts{.slowest = 0.1, .fastest = 0.1};
    for (int i = 0; i < 50; ++i) {
      PairImpact impact = impacts.in_space();
      impact.velocity[0] -= impact.velocity[1];
      impact.velocity[1] = impact.spin[1] = Vector3d::Zero();
      const PairOutcome found = pair.collide(impact), exact = pair.integrate(impact);
      EXPECT_LT(difference(found, exact, impact), 5e-4) << arm << ' ' << i;
      EXPECT_EQ(found.velocity[1].norm(), 0);
      EXPECT_LT((found.displacement - exact.displacement).norm(), 1e-3 * exact.contact_time * normal_speed(impact));
    }
    EXPECT_EQ(pair.count(Refusal::none), 50);
  }
}

}  // namespace
}  // namespace scalebreak

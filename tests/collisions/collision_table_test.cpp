#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/collisions/tables/table_builder.hpp>
#include <scalebreak/contact/damping.hpp>

#include "collisions/kinds.hpp"

namespace scalebreak {
namespace {

class TableOfEveryKind : public testing::TestWithParam<ContactKind> {};

double speed_of(std::mt19937_64& random) { return std::pow(10.0, std::uniform_real_distribution(-1.5, 4.9)(random)); }

/// Points that the builder never saw, by an engine a thousand times finer: their errors lie below the tolerance asked for.
TEST_P(TableOfEveryKind, HoldsItsToleranceAtRandomPoints) {
  const ContactKind kind = GetParam();
  const CollisionTable table = build_collision_table({kind, 1e-6});
  EXPECT_LT(table.quality().error_max, 1e-6);
  EXPECT_GT(table.quality().error_max, 0);
  EXPECT_LE(table.quality().error_rms, table.quality().error_max);
  std::mt19937_64 random(20);
  int compared = 0;
  for (int i = 0; i < 1500; ++i) {
    const double beta = damping_ratio(std::uniform_real_distribution(0.0501, 1.0)(random)),
                 speed = kind.adhesive() ? speed_of(random) : 1.0;
    const auto found = table.find(beta, speed);
    const TableOutcome exact = exact_table_outcome(kind, beta, speed, 1e-13);
    if (!found) {  // only just above the sticking speed, or beyond the end
      const double stick = reduced_sticking_speed<double>(kind, beta);
      EXPECT_LT(std::abs(speed * speed - stick * stick), 1.001e-4 * (1 + stick * stick));
      continue;
    }
    ASSERT_EQ(found->stuck, exact.stuck) << beta << ' ' << speed;
    if (exact.stuck) continue;
    ++compared;
    EXPECT_NEAR(found->restitution * found->restitution, exact.restitution * exact.restitution, 1e-6) << beta << ' ' << speed;
    EXPECT_NEAR(found->contact_time / exact.contact_time, 1, 1e-6) << beta << ' ' << speed;
    EXPECT_NEAR(found->max_overlap / exact.max_overlap, 1, 1e-6) << beta << ' ' << speed;
  }
  EXPECT_GT(compared, 500);
}

TEST_P(TableOfEveryKind, IsCoarserForACoarserTolerance) {
  if (!GetParam().adhesive()) return;
  const CollisionTable coarse = build_collision_table({GetParam(), 1e-3});
  EXPECT_LT(coarse.quality().error_max, 1e-3);
  EXPECT_LT(coarse.nodes().size(), build_collision_table({GetParam(), 1e-6}).nodes().size());
}

INSTANTIATE_TEST_SUITE_P(Kinds, TableOfEveryKind, testing::ValuesIn(all_contact_kinds()),
                         [](const auto& test) { return tests::kind_name(test.param); });

TEST(CollisionTable, HasTheSameBitsForAnyNumberOfThreads) {
  const CollisionTable one = build_collision_table({ContactKind{}, 1e-5}, 1), three = build_collision_table({ContactKind{}, 1e-5}, 3);
  ASSERT_EQ(one.nodes().size(), three.nodes().size());
  EXPECT_EQ(std::memcmp(one.nodes().data(), three.nodes().data(), one.nodes().size() * sizeof(TableNode)), 0);
  EXPECT_EQ(one.sticking().squared, three.sticking().squared);
  EXPECT_EQ(one.quality().error_max, three.quality().error_max);
  EXPECT_EQ(one.quality().error_rms, three.quality().error_rms);
}

TEST(CollisionTable, RowAgreesWithTheTable) {
  const CollisionTable table = build_collision_table({ContactKind{}, 1e-6});
  for (const double e : {1.0, 0.81, 0.06}) {
    const double beta = damping_ratio(e);
    const TableRow row = table.row(beta).value();
    EXPECT_NEAR(row.sticking_speed() / reduced_sticking_speed<double>({}, beta), 1, 1e-8);
    for (double speed = 0.1; speed < 9e4; speed *= 1.07) {
      const auto a = table.find(beta, speed), b = row.find(speed);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      EXPECT_EQ(a->stuck, b->stuck);
      EXPECT_NEAR(a->restitution, b->restitution, 2e-8);
      if (a->stuck) continue;
      EXPECT_NEAR(a->contact_time / b->contact_time, 1, 2e-8);
      EXPECT_NEAR(a->max_overlap / b->max_overlap, 1, 2e-8);
    }
  }
}

TEST(CollisionTable, ReachesNoFurtherThanItsBounds) {
  const CollisionTable table = build_collision_table({ContactKind{}, 1e-4});
  const double beta = damping_ratio(0.9), stick = table.row(beta)->sticking_speed();
  EXPECT_TRUE(table.find(beta, 0.9 * stick)->stuck);
  EXPECT_FALSE(table.find(beta, stick).has_value());
  EXPECT_FALSE(table.find(beta, std::sqrt(stick * stick + 0.99e-4 * (1 + stick * stick))).has_value());
  EXPECT_TRUE(table.find(beta, std::sqrt(stick * stick + 1.01e-4 * (1 + stick * stick))).has_value());
  EXPECT_TRUE(table.find(beta, 0.99e5).has_value());
  EXPECT_FALSE(table.find(beta, 1.01e5).has_value());
  EXPECT_TRUE(table.find(damping_ratio(0.05001), 10).has_value());
  EXPECT_FALSE(table.find(damping_ratio(0.0499), 10).has_value());
  EXPECT_FALSE(table.row(damping_ratio(0.0499)).has_value());
  EXPECT_FALSE(table.find(1.5, 10).has_value());
  EXPECT_FALSE(table.find(beta, std::nan("")).has_value());
}

TEST(CollisionTable, OfHertzIsOneCurveForAllSpeeds) {
  const CollisionTable table = build_collision_table({ContactKind{.normal = NormalModel::hertz}, 1e-6});
  EXPECT_EQ(table.speed_axis().count, 1);
  EXPECT_NEAR(table.find(damping_ratio(0.6), 1.0)->restitution, 0.6, 1e-6);
}

TEST(CollisionTable, RefusesAToleranceItCannotReach) {
  for (const double tolerance : {1e-16, 0.1, 0.0, std::nan("")})
    EXPECT_THROW((void)build_collision_table({ContactKind{}, tolerance}), WorkError);
}

}  // namespace
}  // namespace scalebreak

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include <collisions/scenes.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>
#include <scalebreak/contact/reduced.hpp>
#include <scalebreak/table/rolling_table_file.hpp>

namespace scalebreak {
namespace {

using tests::resolved;

struct Laws {
  const char* normal;
  const char* rolling;
};

class Rolls : public testing::TestWithParam<Laws> {
 protected:
  static constexpr double tolerance = 1e-4;
  static Input input(const std::string& more = "") {
    return resolved(std::string("[contact]\nnormal = \"") + GetParam().normal + "\"\nrolling = \"" + GetParam().rolling +
                    "\"\ntangential = \"mindlin\"\n" + more);
  }
  RollingKey key_ = *rolling_key(input(), tolerance).key;
  RollingTable table_ = build_rolling_table(key_, 0);
};

TEST_P(Rolls, IsWithinItsToleranceOfTheExactEngine) {
  EXPECT_LT(table_.quality().error_max, tolerance);
  EXPECT_GT(table_.quality().error_max, 0);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 200; ++i) {
    const double speed = key_.kind.adhesive() ? 1.7 * std::pow(1e3, uniform(random)) : 1.0, ratio = std::pow(10, 5 * uniform(random) - 3);
    const auto found = table_.find(speed, ratio);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, exact_rolling_entry(key_, speed, ratio, 1e-9), tolerance) << speed << ' ' << ratio;
  }
}

/// The SI pair with friction and spins that slide and roll, of other size: its rolling is the table's, whatever its sliding does.
TEST_P(Rolls, ServesEverySizeAndSpeedOfEqualSpheres) {
  const bool adhesive_rolling = key_.model == RollingModel::ar;
  const Input other = input(adhesive_rolling ? "" : "[pair]\nradius = [0.1e-3, 0.1e-3]\n");
  const NormalPair normal = other.colliding().pair();
  const double radius = other.radius[0], mass = sphere_mass(radius, other.material.density), inertia = 0.4 * mass * radius * radius;
  const ObliquePair pair{.laws = contact_laws(key_.kind, other.surface, normal, other.colliding().surfaces()),
                         .mass = mass / 2,
                         .radius = {radius, radius},
                         .inertia = {inertia, inertia}};
  const double speed = key_.kind.adhesive() ? 4 * reduce(key_.kind, normal, 1.0).scales.speed() : 0.1;
  for (const double ratio : {0.02, 0.3, 5.0}) {
    const double half = ratio * speed / normal.radius / 2, common = 1.3 * speed / radius;
    const auto outcome = resolve_oblique_collision(pair, {speed, 0.2 * speed, {common + half, common - half}}, 1e-10);
    EXPECT_NEAR((outcome.spin[0] - outcome.spin[1]) / (2 * half), exact_rolling_entry(key_, 4, ratio, 1e-10), 1e-8) << ratio;
  }
}

TEST_P(Rolls, ComesBackFromItsFiles) {
  const auto folder = std::filesystem::path(testing::TempDir()) / ("rolling_" + rolling_table_file_name(key_));
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(read_rolling_table(folder, key_).table);
  write_rolling_table(folder, table_);
  const auto read = read_rolling_table(folder, key_);
  ASSERT_TRUE(read.table) << read.problem;
  EXPECT_EQ(read.table->quality(), table_.quality());
  for (const double ratio : {0.001, 0.1, 7.0}) EXPECT_EQ(read.table->find(5, ratio), table_.find(5, ratio));
  RollingKey other = key_;
  other.limit += 0.1;
  EXPECT_FALSE(read_rolling_table(folder, other).table);
  std::fstream file(folder / (rolling_table_file_name(key_) + ".npy"), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(-5, std::ios::end);
  file.put('x');
  file.close();
  EXPECT_EQ(read_rolling_table(folder, key_).problem, "its checksum does not fit");
}

INSTANTIATE_TEST_SUITE_P(LawPairs, Rolls,
                         testing::Values(Laws{"hertz", "cdt"}, Laws{"hertz", "epsd"}, Laws{"hertz", "epsd2"}, Laws{"jkr", "cdt"},
                                         Laws{"jkr", "epsd"}, Laws{"jkr", "epsd2"}, Laws{"jkr", "ar"}),
                         [](const auto& test) { return std::string(test.param.normal) + "_" + test.param.rolling; });

TEST(RollingKeys, SayWhyThereIsNoTable) {
  const auto reason = [](const std::string& toml) { return rolling_key(resolved(toml), 1e-4).reason; };
  EXPECT_EQ(reason(""), "nothing resists rolling");
  EXPECT_EQ(reason("[contact]\nnormal = \"hertz\"\nrolling = \"ar\"\n"),
            "adhesive rolling beside a contact without adhesion is another one at every speed");
  EXPECT_EQ(reason("[contact]\nrolling = \"sds\"\n"), "the rolling spring of \"sds\" is another one at every size and speed");
  EXPECT_EQ(reason("[contact]\nrolling = \"cdt\"\n[pair]\npartner = \"wall\"\nradius = [0.5e-3]\n"), "");
}

}  // namespace
}  // namespace scalebreak

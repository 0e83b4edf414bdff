#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/patch_builder.hpp>
#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/contact/reduced.hpp>
#include <scalebreak/table/oblique_table_file.hpp>

namespace scalebreak {
namespace {

TEST(Patches, HoldTheToleranceAcrossAKink) {
  const auto function = [](double x, double y) { return Eigen::Array2d(0.1 * std::abs(std::sin(3 * x) - 1.5 * y), std::cos(2 * x * y)); };
  const auto table = build_patches<2>(function, {.tolerance = 1e-4});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  double largest = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double x = uniform(random), y = uniform(random);
    largest = std::max(largest, (table.at(x, y) - function(x, y)).abs().maxCoeff());
  }
  EXPECT_LT(largest, 1e-4);
  EXPECT_LT(table.cells(), 3000u);
}

TEST(Patches, GiveBackACubicExactlyAndAreTheSameForAnyThreads) {
  const auto cubic = [](double x, double y) { return Eigen::Array2d(x * x * x - 2 * x * y * y + y, 1 - x * y * y * y); };
  const auto table = build_patches<2>(cubic, {.tolerance = 1e-12});
  for (const double x : {0.0, 0.1, 0.37, 0.999, 1.0}) {
    for (const double y : {0.0, 0.24, 0.76, 1.0}) EXPECT_LT((table.at(x, y) - cubic(x, y)).abs().maxCoeff(), 1e-14);
  }
  const auto kink = [](double x, double y) { return Eigen::Array2d(std::max(x, y), x); };
  const auto one = build_patches<2>(kink, {.tolerance = 1e-3, .threads = 1}),
             two = build_patches<2>(kink, {.tolerance = 1e-3, .threads = 2});
  EXPECT_EQ(one.tree(), two.tree());
  EXPECT_TRUE(std::equal(one.values().begin(), one.values().end(), two.values().begin(),
                         [](const auto& a, const auto& b) { return (a == b).all(); }));
}

TEST(Patches, RefuseWhatTheyCannotHold) {
  const auto jump = [](double x, double y) { return Eigen::Array2d(x > 0.3 + 0.1 * y ? 1.0 : 0.0, 0.0); };
  EXPECT_THROW((void)build_patches<2>(jump, {.tolerance = 1e-4, .most_cells = 2000}), WorkError);
}

Input glass(NormalModel normal) {
  Input input;
  input.contact = canonical({.normal = normal});
  input.surface.tangential = normal == NormalModel::linear ? TangentialModel::linear : TangentialModel::mindlin;
  input.surface.torque_arm = TorqueArm::contact;
  return input;
}

class Oblique : public testing::TestWithParam<NormalModel> {
 protected:
  static const ObliqueTable& table() {
    static std::map<NormalModel, ObliqueTable> tables;
    const auto [at, missing] = tables.try_emplace(GetParam());
    if (missing) at->second = build(GetParam());
    return at->second;
  }
  static ObliqueTable build(NormalModel normal) {
    const double tolerance = normal == NormalModel::jkr ? 1e-3 : 1e-4;  // at 1e-4 a JKR table takes half a minute
    return build_oblique_table(*oblique_key(glass(normal), tolerance).key, 0);
  }
};

TEST_P(Oblique, IsWithinItsToleranceOfTheExactEngine) {
  const ObliqueTable& t = table();
  EXPECT_LT(t.quality().error_max, t.key().tolerance);
  EXPECT_GT(t.quality().error_max, 0);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 300; ++i) {
    const double speed = t.key().kind.adhesive() ? 1.7 * std::pow(1e3, uniform(random)) : 1.0,
                 ratio = std::pow(10, 4 * uniform(random) - 2);
    const auto found = t.find(speed, ratio);
    ASSERT_TRUE(found);
    const ObliqueEntry exact = exact_oblique_entry(t.key(), speed, ratio, 1e-9);
    EXPECT_NEAR(found->surface_restitution, exact.surface_restitution, t.key().tolerance);
    EXPECT_NEAR(found->lag, exact.lag, t.key().tolerance);
  }
}

/// With the first order of the turning what is left falls with the square of overlap over distance.
TEST_P(Oblique, TurningLeavesASecondOrder) {
  const ObliqueTable& t = table();
  std::vector<double> left, plain;
  for (const double share : {1e-3, 1e-4}) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform;
    std::vector<double> with, without;
    for (int i = 0; i < 150; ++i) {
      const double speed = t.key().kind.adhesive() ? 1.8 * std::pow(100, uniform(random)) : 1.0;
      const double psi = std::pow(10, 2 * uniform(random) - 1), tau = psi * (2 * uniform(random) - 0.5);
      const double deepest = resolve_normal_collision<double>(t.key().kind, t.key().damping_ratio, speed, {.tolerance = 1e-9}).max_overlap;
      const auto outcome = [&](double depth) -> Eigen::Array3d {
        const ObliquePair pair = reduced_oblique_pair(t.key(), depth);
        const double spin = (psi - tau) * speed / (2 * pair.radius[0]);
        const auto end = resolve_oblique_collision(pair, {speed, tau * speed, {spin, spin}}, 1e-10);
        return Eigen::Array3d(end.normal_speed, end.tangential_speed, end.tangential_speed + pair.radius[0] * (end.spin[0] + end.spin[1])) /
               speed;
      };
      const auto turning = t.turning(speed, psi);
      ASSERT_TRUE(turning);
      const auto at_tau = [&](const Eigen::Array3d& c) { return c[0] + tau * (c[1] + tau * c[2]); };
      const Eigen::Array3d correction(at_tau(turning->normal), at_tau(turning->tangential), at_tau(turning->sliding));
      const Eigen::Array3d exact = outcome(share / deepest), flat = outcome(0);
      without.push_back((exact - flat).abs().maxCoeff());
      with.push_back((exact - flat - share * correction).abs().maxCoeff());
    }
    for (auto* list : {&with, &without}) std::nth_element(list->begin(), list->begin() + 75, list->end());
    left.push_back(with[75]), plain.push_back(without[75]);
  }
  EXPECT_LT(left[0], plain[0] / 100);
  EXPECT_LT(left[1], plain[1] / 200);
  EXPECT_LT(left[1], left[0] / 8);
}

TEST_P(Oblique, ComesBackFromItsFiles) {
  const auto folder = std::filesystem::path(testing::TempDir()) / ("oblique_" + std::to_string(static_cast<int>(GetParam())));
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(read_oblique_table(folder, table().key()).table);
  write_oblique_table(folder, table());
  const auto read = read_oblique_table(folder, table().key());
  ASSERT_TRUE(read.table) << read.problem;
  EXPECT_EQ(read.table->quality(), table().quality());
  for (const double ratio : {0.01, 0.5, 3.0, 100.0}) {
    EXPECT_EQ(read.table->find(5, ratio)->surface_restitution, table().find(5, ratio)->surface_restitution);
    EXPECT_EQ(read.table->turning(5, ratio)->normal[0], table().turning(5, ratio)->normal[0]);
  }
  ObliqueKey other = table().key();
  other.friction += 0.1;
  EXPECT_FALSE(read_oblique_table(folder, other).table);
  std::fstream file(folder / (oblique_table_file_name(table().key()) + "-entries.npy"), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(-5, std::ios::end);
  file.put('x');
  file.close();
  EXPECT_EQ(read_oblique_table(folder, table().key()).problem, "its checksum does not fit");
}

INSTANTIATE_TEST_SUITE_P(Kinds, Oblique, testing::Values(NormalModel::linear, NormalModel::hertz, NormalModel::jkr),
                         [](const auto& test) { return std::string(to_string(test.param)); });

TEST(ObliqueKeys, SayWhyThereIsNoTable) {
  Input input = glass(NormalModel::hertz);
  input.surface.tangential = TangentialModel::linear;
  EXPECT_EQ(oblique_key(input, 1e-4).reason, "a linear tangential spring beside contact.normal = \"hertz\" is another one at every speed");
  input = glass(NormalModel::jkr);
  input.surface.tangential = TangentialModel::none;
  EXPECT_EQ(oblique_key(input, 1e-4).reason, "nothing acts tangentially");
}

/// Pairs of other sizes and stiffnesses have the table of their numbers.
TEST(ObliqueKeys, ServeEverySizeAndSpeed) {
  const Input input = glass(NormalModel::jkr);
  const auto key = *oblique_key(input, 1e-4).key;
  Input other = input;
  other.radius = {0.1e-3, 0.1e-3};
  const auto same = *oblique_key(other, 1e-4).key;
  EXPECT_NEAR(same.stiffness, key.stiffness, 1e-15);
  EXPECT_EQ(same.friction, key.friction);
  // The exact collision of the SI pair at this v̂ and angle has the entry of the key.
  const NormalPair pair = other.colliding().pair();
  const double speed = 4 * reduce(other.contact, pair, 1.0).scales.speed(), mass = sphere_mass(0.1e-3, other.material.density);
  const double inertia = 0.4 * mass * 1e-8;
  ObliquePair si{.laws = contact_laws(other.contact, other.surface, pair, other.colliding().surfaces()),
                 .mass = pair.mass,
                 .radius = {0.1e-3, 0.1e-3},
                 .inertia = {inertia, inertia}};
  si.laws.arm = TorqueArm::radius;
  const auto outcome = resolve_oblique_collision(si, {speed, 1.5 * speed, {0, 0}}, 1e-10);
  const double sliding = outcome.tangential_speed + 0.1e-3 * (outcome.spin[0] + outcome.spin[1]);
  EXPECT_NEAR(sliding / (1.5 * speed), exact_oblique_entry(key, 4, 1.5, 1e-10).surface_restitution, 1e-9);
}

}  // namespace
}  // namespace scalebreak

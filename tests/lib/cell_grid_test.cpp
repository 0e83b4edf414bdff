#include <scalebreak/cell/cell_grid.hpp>

#include <map>
#include <random>

#include <gtest/gtest.h>

namespace scalebreak {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

struct Scene {
  Cell cell;
  std::vector<Eigen::Vector3d> position;
  std::vector<double> radius;
  double reach = 0;
};

/// Every pair that is near, by trying all.
std::map<Pair, Eigen::Vector3d> near_pairs(const Scene& scene) {
  std::map<Pair, Eigen::Vector3d> pairs;
  for (std::uint32_t j = 1; j < scene.position.size(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      const Eigen::Vector3d difference = nearest_image(scene.cell, scene.position[j] - scene.position[i]);
      if (difference.norm() < scene.radius[i] + scene.radius[j] + scene.reach) pairs[{i, j}] = difference;
    }
  }
  return pairs;
}

void expect_same_pairs(const Scene& scene, const std::string& what) {
  std::map<Pair, Eigen::Vector3d> found;
  CellGrid(scene.cell, scene.position, scene.radius, scene.reach).for_each_pair([&](auto i, auto j, const Eigen::Vector3d& difference) {
    const Eigen::Vector3d forward = i < j ? difference : Eigen::Vector3d(-difference);
    ASSERT_TRUE(found.emplace(Pair(std::min(i, j), std::max(i, j)), forward).second) << what << ": visited twice";
  });
  const auto wanted = near_pairs(scene);
  ASSERT_EQ(found.size(), wanted.size()) << what;
  const double size = scene.cell.size.maxCoeff();
  for (const auto& [pair, difference] : wanted) {
    ASSERT_EQ(found.count(pair), 1u) << what << ": missed " << pair.first << ", " << pair.second;
    ASSERT_NEAR((found.at(pair) - difference).norm(), 0, 1e-12 * size) << what;
  }
}

/// Centres in the cell and around it, radii of up to a ratio.
Scene random_scene(std::mt19937_64& random, double ratio) {
  const auto within = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Scene scene;
  scene.cell.size = {within(1, 9), within(1, 9), within(1, 9)};
  for (Boundary& boundary : scene.cell.boundary) boundary = static_cast<Boundary>(random() % 3);
  if (scene.cell.periodic(0) && scene.cell.periodic(2) && random() % 2 == 0) scene.cell.shear_offset = within(0, scene.cell.size.x());
  const double smallest = within(0.01, 0.4);
  for (std::size_t count = 2 + random() % 150; scene.position.size() < count;) {
    scene.position.emplace_back(within(-1.3, 2.4) * scene.cell.size.x(), within(-1.3, 2.4) * scene.cell.size.y(),
                                within(-1.3, 2.4) * scene.cell.size.z());
    scene.radius.push_back(smallest * std::pow(ratio, within(0, 1)));
  }
  scene.reach = random() % 2 == 0 ? 0 : within(0, 0.5);
  return scene;
}

/// Twice the farthest reach fits the cell along periodic axes: only then is one image the nearest in every sense.
bool is_wide(const Scene& scene) {
  const double farthest = 2 * *std::max_element(scene.radius.begin(), scene.radius.end()) + scene.reach;
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.cell.periodic(axis) && scene.cell.size[axis] < 2 * farthest) return false;
  }
  return true;
}

TEST(CellGrid, FindsThePairsThatTryingAllFinds) {
  std::mt19937_64 random(11);
  int wide = 0, narrow = 0, sheared = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Scene scene = random_scene(random, trial % 3 == 0 ? 1 : 10);
    ++(is_wide(scene) ? wide : narrow);
    sheared += scene.cell.shear_offset > 0 ? 1 : 0;
    expect_same_pairs(scene, "scene " + std::to_string(trial));
  }
  EXPECT_GT(wide, 300);
  EXPECT_GT(narrow, 300);
  EXPECT_GT(sheared, 60);
}

TEST(CellGrid, FindsEachOfManyPairsInManyBins) {
  std::mt19937_64 random(12);
  Scene scene;
  scene.cell.size = {20, 30, 25};
  scene.cell.shear_offset = 7.3;
  for (int i = 0; i < 3000; ++i) {
    const auto within = [&](double high) { return std::uniform_real_distribution(0.0, high)(random); };
    scene.position.emplace_back(within(20), within(30), within(25));
    scene.radius.push_back(i % 40 == 0 ? 2 : 0.2 + within(0.3));
  }
  ASSERT_GT(near_pairs(scene).size(), 1000u);
  expect_same_pairs(scene, "many");
}

TEST(CellGrid, WithoutRadiiTheReachIsTheDistanceOfCentres) {
  const Cell cell{.size = {4, 4, 4}};
  const std::vector<Eigen::Vector3d> position = {{0.1, 1, 1}, {3.9, 1, 1}, {2, 1, 1}};
  const std::vector<double> radius(3, 0.0);
  int pairs = 0;
  CellGrid(cell, position, radius, 0.21).for_each_pair([&](auto i, auto j, const Eigen::Vector3d& difference) {
    ++pairs;
    EXPECT_EQ(i + j, 1u);
    EXPECT_NEAR(difference.norm(), 0.2, 1e-14);
  });
  EXPECT_EQ(pairs, 1);
  CellGrid(cell, position, radius, 0.19).for_each_pair([](auto, auto, const Eigen::Vector3d&) { ADD_FAILURE() << "too far apart"; });
}

TEST(CellGrid, OrderHoldsEverySphereOnce) {
  std::mt19937_64 random(13);
  const Scene scene = random_scene(random, 10);
  auto order = CellGrid(scene.cell, scene.position, scene.radius, 0).order();
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), scene.position.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

}  // namespace
}  // namespace scalebreak

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include <scalebreak/ensembles/event/flight/list_difference.hpp>
#include <scalebreak/ensembles/event/near/reference_bins.hpp>

namespace scalebreak {
namespace {

std::vector<Eigen::Vector3d> points_in(const Cell& cell, std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Eigen::Vector3d> points(count);
  for (Eigen::Vector3d& point : points)
    point = {share(random) * cell.size.x(), share(random) * cell.size.y(), share(random) * cell.size.z()};
  return points;
}

TEST(EventReferenceBins, FindWhatIsNearAndFromBothSides) {
  Cell cell{.size = {9, 11, 10}};
  std::mt19937_64 random(3);
  auto points = points_in(cell, 400, random);
  ReferenceBins bins(cell, points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) bins.insert(i, points[i]);
  for (std::uint32_t i = 0; i < points.size(); i += 2) bins.move(i, points[i] = points_in(cell, 1, random)[0]);
  constexpr double reach = 1.7, farthest = reach * 1.01;
  ReferenceBins::Space space;
  const Images images(cell);
  std::vector<std::vector<Neighbour>> near(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto [found, exact] = bins.find_near(points[i], reach, 0, space);
    EXPECT_TRUE(exact);
    near[i].assign(found.begin(), found.end());
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t within = 0, listed = 0;
    for (const Eigen::Vector3d& other : points) within += nearest_image(cell, other - points[i]).norm() < reach ? 1u : 0u;
    for (const Neighbour k : near[i]) {
      const double distance = (points[k.sphere()] + images[k.image()].shift - points[i]).norm();
      EXPECT_LT(distance, farthest);
      listed += distance < reach ? 1u : 0u;
      const Neighbour back(i, Images::opposite(k.image()));
      EXPECT_EQ(std::count(near[k.sphere()].begin(), near[k.sphere()].end(), back), 1);
    }
    EXPECT_EQ(listed, within);
  }
}

TEST(EventReferenceBins, WholeBinsAtATimeFindTheSame) {
  if (!can_look_into_whole_bins()) GTEST_SKIP() << "this processor has no AVX2";
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> step(-Bin::steps, 2 * Bin::steps), some(0, Bin::room);
  LargeList<Bin> bins(60);
  std::vector<BinVisit> visits;
  for (std::uint32_t b = 0; b < bins.size(); ++b) {
    bins[b].count = static_cast<std::uint32_t>(some(random)) & 7u;
    for (std::size_t k = 0; k < Bin::room; ++k) {
      bins[b].x[k] = static_cast<std::int16_t>(step(random)), bins[b].y[k] = static_cast<std::int16_t>(step(random));
      bins[b].z[k] = static_cast<std::int16_t>(step(random));
      bins[b].sphere[k] = 10 * b + static_cast<std::uint32_t>(k);
    }
    if (b % 3 == 1) bins[b - 1].more = b & Bin::none;
    if (b % 3 != 1)
      visits.push_back({b, b, static_cast<float>(step(random)), static_cast<float>(step(random)), static_cast<float>(step(random))});
  }
  const BinSearch search{.step_x = 1e-3f, .step_y = 1.1e-3f, .step_z = 0.9e-3f, .strain = 0.2f, .square = 300};
  std::vector<Neighbour> one_by_one, whole;
  look_into_bins(bins, visits, search, one_by_one);
  look_into_whole_bins(bins, visits, search, whole);
  EXPECT_GT(one_by_one.size(), 20u);
  EXPECT_EQ(one_by_one, whole);
}

TEST(EventListDifference, ByEightsIsTheSame) {
  if (!can_find_by_eights()) GTEST_SKIP() << "this processor has no AVX2";
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::uint32_t> image(0, 5);
  std::bernoulli_distribution in_list(0.6);
  std::size_t lost = 0, gained = 0;
  for (std::uint32_t most = 0; most < 60; ++most) {
    std::vector<Neighbour> before, after;
    for (std::uint32_t k = 0; k < most; ++k) {
      const Neighbour neighbour(k, image(random));
      if (in_list(random)) before.push_back(neighbour);
      if (in_list(random)) after.push_back(neighbour);
    }
    std::shuffle(before.begin(), before.end(), random);
    ListDifference one_by_one, by_eights;
    find_difference(before, after, one_by_one);
    find_difference_by_eights(before, after, by_eights);
    EXPECT_EQ(one_by_one.lost, by_eights.lost);
    EXPECT_EQ(one_by_one.gained, by_eights.gained);
    EXPECT_EQ(before.size() - by_eights.lost.size(), after.size() - by_eights.gained.size());
    lost += by_eights.lost.size(), gained += by_eights.gained.size();
  }
  EXPECT_GT(lost, 100u);
  EXPECT_GT(gained, 100u);
}

}  // namespace
}  // namespace scalebreak

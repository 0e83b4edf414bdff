#include <scalebreak/start/check_overlap.hpp>

#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

/// Two spheres of 1 mm and 2 mm across a periodic face, so far apart; walls across y.
System two(double distance) {
  System system;
  system.cell = {.size = {0.02, 0.02, 0.02}, .boundary = {Boundary::periodic, Boundary::wall, Boundary::periodic}};
  system.radius = {1e-3, 2e-3};
  system.position = {{0.5e-3, 0.01, 0.01}, {0.02 + 0.5e-3 - distance, 0.01, 0.01}};
  return system;
}

std::string sentence(const System& system, const std::string& where = "") {
  try {
    check_no_overlap(system, where);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(CheckOverlap, NamesTheTwoSpheres) {
  EXPECT_EQ(sentence(two(2.9e-3), "start.csv: "),
            "start.csv: spheres 1 and 2 overlap by 0.0001 m at the start (distance 0.0029 m, radii 0.001 m and 0.002 m); allowed: at most "
            "1e-09 of the radius");
}

TEST(CheckOverlap, TakesAnOverlapUpToABillionthOfTheSmallerRadius) {
  EXPECT_EQ(sentence(two(3e-3 * 1.001)), "(accepted)");
  EXPECT_EQ(sentence(two(3e-3 - 0.9e-12)), "(accepted)");
  EXPECT_NE(sentence(two(3e-3 - 1.1e-12)), "(accepted)");
}

TEST(CheckOverlap, NamesTheWorstPair) {
  System system = two(2.9e-3);
  system.radius.push_back(1e-3);
  system.position.push_back(system.position[0] + Eigen::Vector3d(0, 0, 1e-3));
  EXPECT_NE(sentence(system).find("spheres 1 and 3 overlap by 0.001 m"), std::string::npos) << sentence(system);
}

TEST(CheckOverlap, NamesASphereInAWall) {
  System system = two(0.01);
  system.position[1].y() = 0.0185;
  EXPECT_EQ(
      sentence(system, "a: "),
      "a: sphere 2 and a wall across y overlap by 0.0005 m at the start (distance 0.0015 m, radius 0.002 m); allowed: at most 1e-09 of "
      "the radius");
  system.cell.boundary[1] = Boundary::open;
  EXPECT_EQ(sentence(system), "(accepted)");
}

TEST(LeastGap, IsOverTheSumOfRadii) {
  EXPECT_NEAR(least_gap_ratio(two(3.03e-3), 0.1), 0.01, 1e-12);
  EXPECT_NEAR(least_gap_ratio(two(2.97e-3), 0.1), -0.01, 1e-12);
  EXPECT_EQ(least_gap_ratio(two(0.01), 0.1), 0.1);
  System system = two(0.01);
  system.position[0].y() = 1.02e-3;
  EXPECT_NEAR(least_gap_ratio(system, 0.1), 0.02, 1e-12);
}

}  // namespace
}  // namespace scalebreak

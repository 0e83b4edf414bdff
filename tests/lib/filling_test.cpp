#include <scalebreak/start/filling.hpp>

#include <limits>

#include <gmock/gmock.h>

#include <lib/fillings.hpp>
#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

using tests::filling_of;

/// The least gap by trying all pairs and faces, in the units of `Filling::gap`.
double least_gap(const System& system) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < system.count(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const double distance = nearest_image(system.cell, system.position[j] - system.position[i]).norm();
      least = std::min(least, distance / (system.radius[i] + system.radius[j]) - 1);
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(system.position[j][axis], 0);
      EXPECT_LT(system.position[j][axis], system.cell.size[axis]);
      if (system.cell.periodic(axis)) continue;
      least = std::min(least, std::min(system.position[j][axis], system.cell.size[axis] - system.position[j][axis]) / system.radius[j] - 1);
    }
  }
  return least;
}

void expect_filled(const Filling& filling, const std::string& what) {
  const System system = fill(filling);
  EXPECT_EQ(system.radius, filling.radius) << what;
  EXPECT_EQ(system.mass, filling.mass) << what;
  EXPECT_EQ(system.material, filling.material) << what;
  EXPECT_EQ(system.cell, filling.cell) << what;
  ASSERT_EQ(system.spin.size(), system.count()) << what;
  for (const Eigen::Vector3d& spin : system.spin) EXPECT_EQ(spin.norm(), 0) << what;
  EXPECT_GE(least_gap(system), filling.gap) << what;
}

TEST(Filling, LeavesNoOverlapFromThinToDense) {
  for (const double fraction : {0.01, 0.2, 0.4, 0.5, 0.55, 0.6}) expect_filled(filling_of(1500, fraction), std::to_string(fraction));
}

TEST(Filling, FillsCellsWithWallsAndOpenFaces) {
  for (const int kind : {0, 1, 2}) {
    Filling filling = filling_of(1500, 0.5);
    filling.cell.boundary[static_cast<std::size_t>(kind)] = Boundary::wall;
    if (kind == 2) filling.cell.boundary[0] = Boundary::open;
    expect_filled(filling, "walls across axis " + std::to_string(kind));
  }
  Filling box = filling_of(1500, 0.45);
  box.cell.boundary = {Boundary::wall, Boundary::wall, Boundary::wall};
  expect_filled(box, "box");
}

TEST(Filling, FillsShearedCells) {
  Filling filling = filling_of(1500, 0.55);
  filling.cell.shear_rate = 2;
  filling.cell.shear_offset = 0.7 * filling.cell.size.x();
  expect_filled(filling, "sheared");
}

TEST(Filling, FillsWithManySizes) {
  expect_filled(filling_of(1500, 0.55, {0.5, 0.7, 1.1, 1.5}), "four sizes");
  std::vector<double> tenfold(400, 0.5);
  tenfold.push_back(5);
  expect_filled(filling_of(8 * 401, 0.55, tenfold), "size ratio ten");
}

TEST(Filling, FillsCellsOfFewDiameters) {
  expect_filled(filling_of(1, 0.3), "one");
  expect_filled(filling_of(2, 0.3), "two");
  Filling thin = filling_of(200, 0.4);
  thin.cell.size = {thin.cell.volume() / 1.2 / 12, 1.2, 12};
  expect_filled(thin, "a layer, periodic across itself");
}

TEST(Filling, KeepsAWiderGapWhereAsked) {
  Filling filling = filling_of(1000, 0.4);
  filling.gap = 0.05;
  expect_filled(filling, "wide");
}

TEST(Filling, IsTheSameForTheSameSeedAndReplicaAndAnotherForAnother) {
  Filling filling = filling_of(300, 0.5);
  filling.speed = 1;
  const System first = fill(filling), again = fill(filling);
  EXPECT_EQ(first.position, again.position);
  EXPECT_EQ(first.velocity, again.velocity);
  filling.replica = 1;
  const System replica = fill(filling);
  filling.replica = 0;
  filling.seed = 2;
  const System other = fill(filling);
  EXPECT_NE(first.position, replica.position);
  EXPECT_NE(first.position, other.position);
  EXPECT_NE(replica.position, other.position);
}

TEST(Filling, SaysWhereItDoesNotGetThere) {
  try {
    (void)fill(filling_of(200, 0.72));
    ADD_FAILURE() << "filled beyond what is random";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), testing::MatchesRegex("the cell cannot be filled at random to a volume fraction of 0.72: without overlap it "
                                                    "reached 0\\.[56][0-9]*; a larger cell, or fewer or smaller spheres may help"));
  }
}

TEST(Filling, RefusesSpheresThatAloneDoNotFit) {
  Filling filling = filling_of(1, 0.1);
  filling.cell.size.y() = 0.9;
  try {
    (void)fill(filling);
    ADD_FAILURE() << "fitted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "cell.size: found 0.9 m along y; allowed: above 1 m, the largest sphere's diameter with its gap");
  }
}

TEST(Filling, RefusesListsThatDoNotMatch) {
  Filling filling = filling_of(3, 0.1);
  filling.mass.pop_back();
  EXPECT_THROW((void)fill(filling), WorkError);
  EXPECT_THROW((void)fill(Filling{}), WorkError);
}

TEST(FillingVelocities, HaveTheSpeedAndNoMomentum) {
  Filling filling = filling_of(2000, 0.3, {0.5, 1.0});
  filling.speed = 0.37;
  const System system = fill(filling);
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero(), fourths = Eigen::Vector3d::Zero();
  double mass = 0;
  for (std::size_t i = 0; i < system.count(); ++i) {
    const Eigen::Array3d v = system.velocity[i];
    momentum += system.mass[i] * system.velocity[i];
    mass += system.mass[i];
    squares += v.square().matrix() / 2000;
    fourths += v.square().square().matrix() / 2000;
  }
  EXPECT_LT(momentum.norm() / mass, 1e-15);
  EXPECT_NEAR(std::sqrt(squares.sum()), 0.37, 1e-15);
  for (int axis = 0; axis < 3; ++axis) {
    // Of 2000 normal numbers the variance has a relative standard error of 0.03, the kurtosis one of 0.11.
    EXPECT_NEAR(squares[axis], 0.37 * 0.37 / 3, 4 * 0.032 * 0.37 * 0.37 / 3);
    EXPECT_NEAR(fourths[axis] / (squares[axis] * squares[axis]), 3, 4 * 0.11);
  }
}

TEST(FillingVelocities, RideOnTheMeanFlow) {
  Filling filling = filling_of(500, 0.3);
  filling.cell.shear_rate = 5;
  const System still = fill(filling);
  for (std::size_t i = 0; i < still.count(); ++i) EXPECT_EQ(still.velocity[i], mean_flow(still.cell, still.position[i].z()));
  filling.speed = 2;
  const System moving = fill(filling);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0;
  for (std::size_t i = 0; i < moving.count(); ++i) {
    const Eigen::Vector3d own = moving.velocity[i] - mean_flow(moving.cell, moving.position[i].z());
    sum += own;
    squares += own.squaredNorm();
  }
  EXPECT_LT(sum.norm() / 500, 1e-14);
  EXPECT_NEAR(std::sqrt(squares / 500), 2, 1e-13);
}

TEST(FillingVelocities, AreZeroWithoutASpeedAndRefusedForOneSphere) {
  for (const Eigen::Vector3d& velocity : fill(filling_of(50, 0.3)).velocity) EXPECT_EQ(velocity.norm(), 0);
  Filling one = filling_of(1, 0.1);
  one.speed = 3;
  try {
    (void)fill(one);
    ADD_FAILURE() << "one sphere moves";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "particles.speed: found 3 for a single sphere; allowed: 0, as the total momentum is to be zero");
  }
}

}  // namespace
}  // namespace scalebreak

#include <gtest/gtest.h>

#include <scalebreak/base/random_draws.hpp>
#include <scalebreak/ensembles/event/flight/instants.hpp>
#include <scalebreak/ensembles/event/flight/see_neighbours.hpp>

namespace scalebreak {
namespace {

/// Spheres at random about the first one, some of them beyond faces of a sheared cell, each brought up at another time.
Flight surroundings(std::mt19937_64& random, std::uint32_t spheres, bool falls) {
  const auto even = [&] { return 2 * uniform(random) - 1; };
  const auto vector = [&] { return Eigen::Vector3d(even(), even(), even()); };
  Flight flight;
  flight.cell.size = {10, 11, 12};
  flight.cell.shear_rate = 0.3;
  flight.cell.shear_offset = 4;
  flight.images = Images(flight.cell);
  if (falls) flight.gravity = {0.1, 0, -0.4};
  for (std::uint32_t i = 0; i < spheres; ++i) flight.sphere.push_back({3 * vector(), even(), vector(), 0.3 + 0.2 * uniform(random)});
  return flight;
}

TEST(SeeNeighbours, ByFoursIsTheSameBits) {
  if (!can_see_by_fours()) GTEST_SKIP() << "this processor has no AVX2";
  std::mt19937_64 random = random_stream(1, 2, 3);
  int met = 0;
  for (int k = 0; k < 3000; ++k) {
    const bool falls = k % 3 == 0;
    const auto spheres = static_cast<std::uint32_t>(2 + k % 23);
    const Flight flight = surroundings(random, spheres, falls);
    std::vector<Neighbour> list;
    for (std::uint32_t i = 1; i < spheres; ++i)
      list.emplace_back(i, uniform(random) < 0.7 ? Images::home : Images::code(i % 3 == 0 ? 1 : 0, 0, i % 2 == 0 ? -1 : 1));
    if (k % 5 == 0) list.push_back(list.front());  // a tie
    const double now = uniform(random);
    const FlyingSphere here{flight.position(0, now), now, flight.velocity(0, now), flight.sphere[0].radius};
    const double end_of_list = k % 2 == 0 ? never : 0.5 * uniform(random);
    Foreseen one{end_of_list, {no_neighbour::list_ends, 0}}, fours = one;
    see_neighbours(flight, list, here, one);
    see_neighbours_by_fours(flight, list, here, fours);
    ASSERT_EQ(one.wait, fours.wait) << k;
    ASSERT_EQ(one.partner, fours.partner) << k;
    if (one.wait < end_of_list) ++met;
  }
  EXPECT_GT(met, 200);
}

TEST(SeeNeighbours, KnowsImagesAndTheirMotion) {
  Flight flight;
  flight.cell.size = {10, 10, 10};
  flight.cell.shear_rate = 0.5;
  flight.cell.shear_offset = 2;
  flight.images = Images(flight.cell);
  // At rest below; the image of the second across the upper face lies at 2 + 3 along x and 11 along z, and passes at 5.
  const FlyingSphere here{{9, 5, 9.5}, 0, {0, 0, 0}, 1};
  flight.sphere = {here, {{3, 5, 1}, 0, {0, 0, 0}, 1}};
  Foreseen next{never, {no_neighbour::list_ends, 0}};
  see_neighbours(flight, std::vector{Neighbour(1, Images::code(0, 0, 1))}, here, next);
  EXPECT_NEAR(next.wait, (4 - std::sqrt(4 - 1.5 * 1.5)) / 5, 1e-14);
}

}  // namespace
}  // namespace scalebreak

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dem/scenes.hpp"

// Spheres that lie side by side at the start, without overlap and without speed.

namespace scalebreak {
namespace {

Input side_by_side(NormalModel normal, double surface_energy) {
  Input input;
  input.contact = {normal, AdhesionRange::full, DampingOn::contact_radius};
  for (Material* material : {&input.material, &input.second}) material->surface_energy = surface_energy, material->restitution = 0.1;
  input.bodies = {{.position = {0, 0, 0}, .radius = 0.5e-3}, {.position = {0, 0, 1e-3}, .radius = 0.5e-3}};
  return input;
}

TEST(TouchingAtRest, AdhesionPullsThemTogetherToWhereItBearsNoLoad) {
  const Input input = side_by_side(NormalModel::jkr, 0.2);
  Dem dem(bodies_start(input), test::setup_of(input, 0.05));
  dem.advance(20'000);
  const System end = dem.system();
  const double overlap = 1e-3 - (end.position[1] - end.position[0]).norm();
  // JKR without a load: 4 E* a³/(3 R*) = √(8 π w E* a³), and the overlap is a²/(3 R*); w is twice the surface energy.
  const double young = input.material.young / (2 * (1 - std::pow(input.material.poisson, 2))), radius = 0.25e-3, work = 2 * 0.2;
  const double a = std::cbrt(4.5 * std::numbers::pi * work * radius * radius / young);
  EXPECT_NEAR(overlap / (a * a / (3 * radius)), 1, 1e-6);
  EXPECT_EQ(dem.contact_forces().size(), 1u);
}

TEST(TouchingAtRest, WithoutAdhesionNothingHappens) {
  const Input input = side_by_side(NormalModel::hertz, 0);
  const System start = bodies_start(input);
  EXPECT_EQ(start.contacts.size(), 1u);
  Dem dem(start, test::setup_of(input));
  dem.advance(100);
  EXPECT_EQ(dem.system().position, start.position);
  EXPECT_TRUE(dem.contact_forces().empty());
}

}  // namespace
}  // namespace scalebreak

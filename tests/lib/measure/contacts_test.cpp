#include <cmath>

#include <gtest/gtest.h>

#include <lib/measure/states.hpp>
#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

TEST(Contacts, ACubicLatticeHasSixNeighbours) {
  System system;
  system.cell = periodic_cell(0.08, 0.08, 0.08);
  std::vector<ContactForce> contacts;
  const auto at = [](int x, int y, int z) { return 16 * (x % 4) + 4 * (y % 4) + z % 4; };
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) {
        add_sphere(system, 0.02 * Eigen::Vector3d(x, y, z));
        contacts.push_back({.first = at(x, y, z), .second = at(x + 1, y, z), .branch = {0.02, 0, 0}, .force = {-1, 0, 0}});
        contacts.push_back({.first = at(x, y, z), .second = at(x, y + 1, z), .branch = {0, 0.02, 0}, .force = {0, -1, 0}});
        contacts.push_back({.first = at(x, y, z), .second = at(x, y, z + 1), .branch = {0, 0, 0.02}, .force = {0, 0, -1}});
      }
    }
  }
  const FlowResult result = held(system, contacts, 3);
  EXPECT_DOUBLE_EQ(found(result, "coordination").value, 6);
  EXPECT_DOUBLE_EQ(found(result, "multi_contact_fraction").value, 1);
  EXPECT_NEAR((result.stress.value - Eigen::Matrix3d::Identity() / 4e-4).norm(), 0, 1e-9);  // 1 N on each (0.02 m)²
}

TEST(Contacts, TheMultiContactFractionIsOfThoseInContact) {
  System system;
  system.cell = walled_cell(1, 1, 1);
  for (int i = 0; i < 8; ++i) add_sphere(system, {0.1 * i, 0.5, 0.01});
  // A row of three, a pair, one on the wall, two alone.
  const std::vector<ContactForce> contacts = {
      {.first = 0, .second = 1}, {.first = 1, .second = 2}, {.first = 3, .second = 4}, {.first = 5, .second = -5}};
  const FlowResult result = held(system, contacts);
  EXPECT_DOUBLE_EQ(found(result, "multi_contact_fraction").value, 1.0 / 6);
  EXPECT_DOUBLE_EQ(found(result, "coordination").value, 7.0 / 8);
  EXPECT_TRUE(std::isnan(found(held(system), "multi_contact_fraction").value));
}

TEST(Contacts, AContactOfNoSphereIsRefused) {
  System system = ideal_gas(periodic_cell(1, 1, 1), 3, 1, 1);
  FlowMeasurement measurement;
  for (const ContactForce& wrong : {ContactForce{.first = 3, .second = 0}, {.first = 0, .second = 3}, {.first = -1, .second = 0}}) {
    EXPECT_THROW(measurement.add({system, std::span(&wrong, 1)}), WorkError);
  }
}

}  // namespace
}  // namespace scalebreak

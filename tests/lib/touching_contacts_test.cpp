#include <scalebreak/start/touching_contacts.hpp>

#include <gtest/gtest.h>

namespace scalebreak {
namespace {

/// Two spheres of 1 mm across a periodic face, with so much between them; the first on the floor, the second as far above it.
System two(double gap, const Eigen::Vector3d& velocity = {0, 0, 0}) {
  System system;
  system.cell = {.size = {0.02, 0.02, 0.02}, .boundary = {Boundary::periodic, Boundary::periodic, Boundary::wall}};
  system.radius = {1e-3, 1e-3};
  system.position = {{0.5e-3, 0.01, 1e-3 + gap}, {0.02 - 1.5e-3 - gap, 0.01, 1e-3 + gap}};
  system.velocity = {velocity, {0, 0, 0}};
  return system;
}

TEST(TouchingContacts, AreOfSpheresAndWallsAtRest) {
  const auto contacts = touching_contacts(two(0));
  ASSERT_EQ(contacts.size(), 3u);
  EXPECT_EQ(contacts[0].second, wall_number(2, false));
  EXPECT_EQ(contacts[1].first, 0);
  EXPECT_EQ(contacts[1].second, 1);
  EXPECT_EQ(contacts[2].first, 1);
  EXPECT_EQ(contacts[2].second, wall_number(2, false));
  for (const ContactMemory& contact : contacts) EXPECT_TRUE(contact.touching);
}

TEST(TouchingContacts, AreNoneOfWhatIsApartOrMoves) {
  EXPECT_EQ(touching_contacts(two(0.9e-15)).size(), 3u);
  EXPECT_EQ(touching_contacts(two(2e-15)).size(), 0u);
  EXPECT_EQ(touching_contacts(two(-0.9e-12)).size(), 3u);
  EXPECT_EQ(touching_contacts(two(-1.1e-12)).size(), 0u);
  EXPECT_EQ(touching_contacts(two(0, {0.1, 0, 0})).size(), 2u) << "on the floor they are still";
  EXPECT_EQ(touching_contacts(two(0, {0, 0.1, 0})).size(), 3u) << "it slides";
}

}  // namespace
}  // namespace scalebreak

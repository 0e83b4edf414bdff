#include <cmath>

#include <gtest/gtest.h>

#include <collisions/kinds.hpp>
#include <collisions/scenes.hpp>
#include <scalebreak/collisions/bodies/few_bodies.hpp>

// What no law may change, of two bodies on a skew course, under every combination of laws that an input may ask for:
// momentum, the sum of the energies, and angular momentum where the torque arm is the distance to the contact point.

namespace scalebreak {
namespace {

using namespace tests;

struct Group {
  ContactKind kind;
  std::string name, normal, rolling;
};

std::vector<Group> groups() {
  const char* rolling_names[] = {"None", "Cdt", "Epsd", "Epsd2", "Ar"};
  std::vector<Group> all;
  for (std::size_t n = 0; n < all_normals().size(); ++n) {
    for (std::size_t r = 0; r < all_rollings().size(); ++r) {
      all.push_back({all_contact_kinds()[n], fmt::format("{}_Rolling{}", kind_name(all_contact_kinds()[n]), rolling_names[r]),
                     all_normals()[n], all_rollings()[r]});
    }
  }
  return all;
}

/// Glass with a little liquid.
constexpr const char* material = "[material]\nliquid_volume = 1e-14\n";

class Balance : public testing::TestWithParam<Group> {};

TEST_P(Balance, HoldsWithEveryFrictionAttractionAndArm) {
  constexpr double speed = 0.2, slow = 0.005;
  int count = 0;
  for (const std::string& tangential : all_tangentials()) {
    for (const std::string& attraction : all_attractions()) {
      for (const std::string& arm : all_arms()) {
        const Words words{GetParam().normal, tangential, GetParam().rolling, attraction, arm};
        SCOPED_TRACE(words.name());
        const auto input = allowed(words.toml() + material + skew_pair(count % 4 == 3 ? slow : speed));
        if (!input) continue;
        ++count;
        const MovingScene scene = moving_scene(*input);
        const MotionOutcome end = scene.move({.tolerance = 1e-10});
        EXPECT_EQ(end.before.total(), kinetic_energy(scene.bodies));
        EXPECT_NEAR(end.after.kinetic / kinetic_energy(end.bodies), 1, 1e-15);
        EXPECT_NEAR(end.after.total() / end.before.total(), 1, 1e-9);
        EXPECT_LT((momentum(end.bodies) - momentum(scene.bodies)).norm(), 1e-12 * momentum_size(scene.bodies));
        if (input->surface.torque_arm == TorqueArm::contact) {
          EXPECT_LT((angular_momentum(end.bodies) - angular_momentum(scene.bodies)).norm(), 1e-12 * angular_momentum_size(scene.bodies));
        }
        EXPECT_GE(end.after.damping, 0);
        EXPECT_GE(end.after.friction, -1e-9 * end.before.total());
        EXPECT_GE(end.after.adhesion, 0);
      }
    }
  }
  // 4 tangential laws, 7 of the liquid, 2 arms; without a contact radius there is none for mindlin, and none for ar.
  const bool no_radius = GetParam().kind.traits().coordinate == Coordinate::overlap;
  const bool refused = no_radius && GetParam().rolling.find("ar") != std::string::npos;
  EXPECT_EQ(count, refused ? 0 : (no_radius ? 3 : 4) * 7 * 2);
}

INSTANTIATE_TEST_SUITE_P(Laws, Balance, testing::ValuesIn(groups()), [](const auto& test) { return test.param.name; });

/// The papers' arm, the radius, is longer than what the bodies turn about by half the overlap: of the spin that friction gives,
/// a share of about overlap over distance comes from nowhere.
TEST(TorqueArm, OfTheRadiusMakesAngularMomentumOfAboutTheOverlapOverTheDistance) {
  for (const double young : {1e7, 1e9}) {
    const auto input =
        resolved(fmt::format("[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\n[material]\nyoung = {}\n"
                             "[pair]\nradius = [1e-3, 1e-3]\n[impact]\nnormal_speed = 0.3\ntangential_speed = 0.4\n",
                             young));
    ASSERT_EQ(input.surface.torque_arm, TorqueArm::radius);
    const MovingScene scene = moving_scene(input);
    const MotionOutcome end = scene.move({.tolerance = 1e-10});
    double gained = 0;
    for (const MovingBody& body : end.bodies) gained += body.inertia * body.spin[1];
    const double made = (angular_momentum(end.bodies) - angular_momentum(scene.bodies))[1];
    const double share = made / gained * (2e-3 / end.max_overlap);
    EXPECT_GT(share, 0.5);
    EXPECT_LT(share, 1.0);
  }
}

}  // namespace
}  // namespace scalebreak

#include <gtest/gtest.h>

#include "dem/scenes.hpp"

// What the engine tells of contacts whose springs it keeps half a step ahead, and goes on from.

namespace scalebreak {
namespace {

/// Glass spheres that hold each other, roll at their limit and slide again.
Input rubbing(Integrator integrator) {
  Input input;
  input.surface = {.tangential = TangentialModel::mindlin, .rolling = RollingModel::ar};
  input.tangential_speed = 0.03;
  input.spin1 = {3, 20, 1};
  input.run.integrator = integrator;
  return input;
}

Dem dem_of(const Input& input) {
  DemSetup setup = test::setup_of(input);
  setup.integrator = input.run.integrator;
  return {bodies_start(input), setup};
}

class HistoriesWith : public testing::TestWithParam<Integrator> {};

TEST_P(HistoriesWith, ForcesToldOfAreThoseThatMoveTheSpheres) {
  const Input input = rubbing(GetParam());
  Dem dem = dem_of(input);
  const double step = test::setup_of(input).step;
  dem.advance(3);
  int touching = 0;
  for (int k = 0; k < 60; ++k) {
    const System before = dem.system();
    dem.advance(1);
    const auto forces = dem.contact_forces();
    const System now = dem.system();
    dem.advance(1);
    const Eigen::Vector3d bend = dem.system().position[0] - 2 * now.position[0] + before.position[0];
    if (forces.empty()) continue;
    ++touching;
    const Eigen::Vector3d pushed = now.mass[0] * bend / (step * step), told = forces[0].first == 0 ? -forces[0].force : forces[0].force;
    EXPECT_LT(std::min((pushed - told).norm(), (pushed + told).norm()), 1e-4 * told.norm()) << k;
  }
  EXPECT_GT(touching, 15);
}

/// A state that is handed over holds springs of its instant, whatever the engine keeps.
TEST_P(HistoriesWith, AStateHandedOverGoesOnAsIfNothingHadHappened) {
  const Input input = rubbing(GetParam());
  Dem whole = dem_of(input);
  whole.advance(20);
  const System state = whole.system();
  ASSERT_EQ(state.contacts.size(), 1u);
  DemSetup setup = test::setup_of(input);
  setup.integrator = input.run.integrator;
  Dem second(state, setup);
  whole.advance(100), second.advance(100);
  const System one = whole.system(), other = second.system();
  for (const std::size_t b : {0, 1}) {
    // The first forces see the velocity of the instant: not the lagged one, nor an estimate of it with the acceleration of the step before.
    const double near = GetParam() == Integrator::verlet ? 2e-3 : 2e-5;
    EXPECT_LT((one.velocity[b] - other.velocity[b]).norm(), near * input.normal_speed);
    EXPECT_LT(one.radius[b] * (one.spin[b] - other.spin[b]).norm(), near * input.normal_speed);
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, HistoriesWith, testing::Values(Integrator::verlet, Integrator::synchronized),
                         [](const auto& test) { return std::string(integrator_words[static_cast<std::size_t>(test.param)]); });

}  // namespace
}  // namespace scalebreak

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include <gtest/gtest.h>

#include <collisions/scenes.hpp>
#include <dem/scenes.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>

// The law of coated.hpp in closed form. With z = ⅔ δ^{3/2} the motion m* δ″ + η√δ δ′ + kδ² = 0 is that of an oscillator in z:
//
//     m* v dv/dz = −(3/2 k z + η v),  so that  e = exp(−πβ/√(1−β²)),
//
// and without a dashpot δ_max = (3m*v²/(2k))^{1/3} and t_c = 2√π Γ(4/3)/Γ(5/6) δ_max/v.

namespace scalebreak {
namespace {

using namespace tests;

Input coated(double restitution, double speed) {
  return resolved(
      fmt::format("[contact]\nnormal = \"coated\"\n[pair]\nradius = [0.5e-3, 0.8e-3]\n[impact]\nnormal_speed = {:.17g}\n"
                  "[material]\nrestitution = {:.17g}\n",
                  speed, restitution));
}

/// k [N/m²].
double stiffness(const NormalPair& pair) { return 10 * std::numbers::pi * pair.young; }
double max_overlap(const NormalPair& pair, double speed) { return std::cbrt(3 * pair.mass * speed * speed / (2 * stiffness(pair))); }
double contact_time(const NormalPair& pair, double speed) {
  return 2 * std::sqrt(std::numbers::pi) * std::tgamma(4.0 / 3) / std::tgamma(5.0 / 6) * max_overlap(pair, speed) / speed;
}

TEST(Coated, IsAWordOfTheInput) {
  const ContactKind kind = coated(0.7, 0.1).contact;
  EXPECT_EQ(to_string(kind), "coated, touch, overlap");
  EXPECT_EQ(all_contact_kinds().back(), kind);
  EXPECT_FALSE(allowed("[contact]\nnormal = \"coated\"\nadhesion_range = \"full\"\n"));
}

TEST(Coated, StandsInTheRegistryAsContributingShows) {
  std::ifstream file(SCALEBREAK_CONTRIBUTING);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_NE(text.find("\n" SCALEBREAK_REGISTRY_LINE ";\n"), std::string::npos) << SCALEBREAK_REGISTRY_LINE;
}

TEST(Coated, LawIsThatOfTheComment) {
  const NormalPair pair = coated(0.7, 0.1).colliding().pair();
  const auto law = Coated<double>::make(pair, AdhesionRange::touch);
  const double overlap = 2.3e-7, x = law.coordinate(overlap), k = stiffness(pair);
  EXPECT_NEAR(law.overlap(x) / overlap, 1, 1e-14);
  EXPECT_NEAR(law.force(x) / (k * overlap * overlap), 1, 1e-13);
  EXPECT_NEAR(law.damping(x) / (2 * pair.damping_ratio * std::sqrt(1.5 * pair.mass * k * overlap)), 1, 1e-13);
  EXPECT_NEAR(law.energy(x) / (k / 3 * std::pow(overlap, 3)), 1, 1e-13);
  EXPECT_NEAR(std::pow(law.root_radius(x), 2) / std::sqrt(2 * pair.radius * overlap), 1, 1e-13);
}

TEST(Coated, ExactCollisionHasTheClosedForm) {
  for (const double speed : {1e-3, 0.1, 3.0}) {
    for (const double e : {0.1, 0.5, 0.9, 1.0}) {
      const PairCollision c = contact_of(coated(e, speed)).collide(speed, 1e-10);
      EXPECT_NEAR(c.restitution, e, 1e-9);
    }
    const Input elastic = coated(1, speed);
    const NormalPair pair = elastic.colliding().pair();
    const PairCollision c = contact_of(elastic).collide(speed, 1e-10);
    EXPECT_NEAR(c.max_overlap / max_overlap(pair, speed), 1, 1e-9);
    EXPECT_NEAR(*c.contact_time / contact_time(pair, speed), 1, 1e-9);
  }
}

/// With friction: the engine with spins, along the normal.
TEST(Coated, ObliqueCollisionKeepsTheNormalRestitution) {
  Input input = coated(0.6, 0.1);
  input.surface.tangential = TangentialModel::mindlin;
  input.tangential_speed = 0.02;
  const MotionOutcome end = moving_scene(input).move({.tolerance = 1e-10});
  const Eigen::Vector3d apart = end.bodies[0].position - end.bodies[1].position, velocity = end.bodies[0].velocity - end.bodies[1].velocity;
  EXPECT_NEAR(velocity.dot(apart.normalized()) / 0.1, 0.6, 1e-3);  // the pair turns a little
  EXPECT_GT(end.bodies[0].spin.norm(), 1.0);
}

/// The largest error of the restitution in three runs, in which first touch falls on different parts of a step.
double soft_sphere_error(double restitution, double step_fraction, const char* kernel) {
  const Input input = coated(restitution, 0.1);
  DemSetup setup = test::setup_of(input);
  setup.step = step_fraction * contact_time(input.colliding().pair(), input.normal_speed);
  setup.kernel = kernel;
  double worst = 0;
  for (const double shift : {0.0, 0.31, 0.67}) {
    System start = bodies_start(input);
    start.position[0] -= shift * setup.step * start.velocity[0];
    Dem dem(start, setup);
    const System end = test::after_contact(dem, 1'000'000);
    worst = std::max(worst, std::abs((end.velocity[0] - end.velocity[1]).norm() / input.normal_speed - restitution));
  }
  return worst;
}

TEST(Coated, SoftSpheresComeToTheClosedFormOnEveryInstructionSet) {
  for (const char* name : {"baseline", "avx2", "avx512"}) {
    for (const double e : {0.5, 0.9}) {
      SCOPED_TRACE(fmt::format("{}, {}", name, e));
      try {
        (void)dem::kernel(name);
      } catch (const InputError&) {  // this processor does not run it
        continue;
      }
      const double coarse = soft_sphere_error(e, 1.0 / 50, name), fine = soft_sphere_error(e, 1.0 / 800, name);
      EXPECT_LT(coarse, 0.01);
      EXPECT_LT(fine, 2e-4);
      EXPECT_LT(fine, coarse / 8) << coarse;
    }
  }
}

}  // namespace
}  // namespace scalebreak

#include <collisions/naive_stepper.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <collisions/scenes.hpp>
#include <scalebreak/collisions/bodies/few_bodies.hpp>

// A second method: the plain stepper of springs that are set back to their limits comes to the exact engine's answer as its
// step shrinks.

namespace scalebreak {
namespace {

using namespace tests;

struct Case {
  const char* name;
  const char* text;
};

class NaiveStepper : public testing::TestWithParam<Case> {};

/// Largest difference of a velocity, or of a spin times the radius, over the impact speed.
double difference(const std::vector<MovingBody>& a, const std::vector<MovingBody>& b, double speed) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max({largest, (a[k].velocity - b[k].velocity).norm() / speed, (a[k].spin - b[k].spin).norm() * a[k].radius / speed});
  }
  return largest;
}

TEST_P(NaiveStepper, ComesToTheExactEngineAsItsStepShrinks) {
  const Input input = resolved(GetParam().text);
  const MovingScene scene = moving_scene(input);
  const MotionOutcome exact = scene.move({.tolerance = 1e-11});
  ASSERT_GT(exact.last_separation, 0);
  const double contact_time = exact.last_separation - exact.first_touch, speed = std::hypot(input.normal_speed, input.tangential_speed);
  std::vector<double> errors;
  for (const double steps : {2e3, 8e3, 32e3}) {
    const double step = contact_time / steps;
    const auto found = NaivePair(scene.bodies, scene.laws[0]).collide(step, 40 * static_cast<long>(steps));
    errors.push_back(difference(found, exact.bodies, speed));
  }
  RecordProperty("errors", fmt::format("{:.1e} {:.1e} {:.1e}", errors[0], errors[1], errors[2]));
  EXPECT_LT(errors[2], 1e-4);
  EXPECT_LT(errors[2], 0.25 * errors[0]) << fmt::format("{:.1e} {:.1e} {:.1e}", errors[0], errors[1], errors[2]);
}

#define SPHERES "[pair]\nradius = [0.5e-3, 0.4e-3]\n[impact]\nnormal_speed = 0.2\n"
#define SPINS "spin1 = [30, -120, 80]\nspin2 = [-90, 60, 40]\n"

INSTANTIATE_TEST_SUITE_P(
    Oblique, NaiveStepper,
    testing::Values(
        Case{"HertzGrazing", "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\n" SPHERES "tangential_speed = 0.4\n"},
        Case{"HertzSteepSpinning", "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\n" SPHERES SPINS "tangential_speed = 0.05\n"},
        Case{"LinearContactArm", "[contact]\nnormal = \"linear\"\ntangential = \"linear\"\ntorque_arm = \"contact\"\n" SPHERES SPINS
                                 "tangential_speed = 0.1\n"},
        Case{"JkrFull", "[contact]\nnormal = \"jkr\"\ntangential = \"mindlin\"\n" SPHERES SPINS "tangential_speed = 0.1\n"},
        Case{"JkrTouchOnOverlap",
             "[contact]\nnormal = \"jkr\"\nadhesion_range = \"touch\"\ndamping_on = \"overlap\"\ntangential = "
             "\"mindlin\"\ntangential_radius = \"overlap\"\n" SPHERES SPINS "tangential_speed = 0.1\n"},
        // Its spring begins without stiffness under a load: it skids from almost its first instant on.
        Case{"JkrFullOnOverlap", "[contact]\nnormal = \"jkr\"\ntangential = \"mindlin\"\ntangential_radius = \"overlap\"\n" SPHERES SPINS
                                 "tangential_speed = 0.1\n"},
        Case{"Wall",
             "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\n[pair]\nradius = [0.5e-3]\npartner = "
             "\"wall\"\n[impact]\nnormal_speed = 0.2\nspin1 = [10, 200, 30]\ntangential_speed = 0.1\n"},
        Case{"CdtThatRollsOn", "[contact]\nnormal = \"hertz\"\nrolling = \"cdt\"\n[material]\nrolling_friction = 0.02\n" SPHERES SPINS},
        Case{"Epsd",
             "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"epsd\"\n" SPHERES SPINS "tangential_speed = 0.1\n"},
        Case{"Epsd2",
             "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"epsd2\"\n" SPHERES SPINS "tangential_speed = 0.1\n"},
        Case{"AdhesiveRolling",
             "[contact]\nnormal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"ar\"\n[material]\nrolling_angle_max "
             "= 1e-4\n" SPHERES SPINS "tangential_speed = 0.1\n"},
        Case{"WetInContact",
             "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nattraction = "
             "\"capillary+viscous\"\nattraction_range = \"contact\"\n" SPHERES SPINS "tangential_speed = 0.1\n"},
        Case{"WetBridge",
             "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nattraction = \"capillary+viscous\"\n[material]\n"
             "liquid_volume = 1e-15\n" SPHERES SPINS "tangential_speed = 0.1\n"},
        Case{"ScaledByForce",
             "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"epsd2\"\ntorque_arm = "
             "\"contact\"\n[scaling]\nlaw = \"sup\"\nfactor = 3\n" SPHERES SPINS "tangential_speed = 0.1\n"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace scalebreak

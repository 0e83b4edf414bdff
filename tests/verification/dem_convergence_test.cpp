#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>
#include <scalebreak/ensembles/tradeoff/convergence.hpp>
#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/toml_reader.hpp>

// With what power of the step the soft-sphere engine comes to the exact engine's outcome: docs/default_step.md says why. A force that
// begins as t^α somewhere inside a step is off its integral by step^{α + 1}, in a sense that is another in each collision.

namespace scalebreak {
namespace {

void dry(Input& input, NormalModel normal) {
  input.contact = {normal, AdhesionRange::touch, DampingOn::overlap};
  for (Material* material : {&input.material, &input.second}) material->surface_energy = 0;
}
void elastic(Input& input) { input.material.restitution = input.second.restitution = 1; }
void rub(Input& input, double tangential_speed) {
  input.surface.tangential = TangentialModel::mindlin;
  input.surface.tangential_radius = input.contact.damping_on;
  input.tangential_speed = tangential_speed;
}
void slide(Input& input) {
  rub(input, 0.05);
  input.spin1 = {3, 20, 1};
}
void wet(Input& input, AttractionRange range) {
  dry(input, NormalModel::hertz), slide(input);
  input.normal_speed = 0.5;
  input.surface.attraction = Attraction::capillary_viscous;
  input.surface.attraction_range = range;
}
void row(Input& input, const std::string& name) {
  input = resolve_input(read_toml_file(SCALEBREAK_SOURCE "/data/papers/" + name + ".toml"));
}

constexpr Method lagged = Method::verlet, synchronized = Method::synchronized;

struct Case {
  const char* name;
  Method method;
  double order;      ///< of the error of one collision, root mean square over the phases of first touch
  double tolerance;  ///< of the fit over a factor of eight in the step
  void (*change)(Input&);
  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const Case cases[] = {
    // Smooth but for how the force begins: as t, as t^{3/2}.
    {"linear", lagged, 2, 0.2, [](Input& input) { dry(input, NormalModel::linear), elastic(input); }},
    {"hertz", lagged, 2.5, 0.3, [](Input& input) { dry(input, NormalModel::hertz), elastic(input); }},
    // What slides throughout knows nothing of its spring.
    {"hertz_sliding", lagged, 2, 0.1, [](Input& input) { dry(input, NormalModel::hertz), elastic(input), slide(input); }},
    {"hertz_sliding_synchronized", synchronized, 2, 0.1,
     [](Input& input) { dry(input, NormalModel::hertz), elastic(input), slide(input); }},
    // A dashpot on the lagged velocity; on δ^{1/4}; a force that is there at once.
    {"hertz_damped_lagged", lagged, 1, 0.35,
     [](Input& input) { dry(input, NormalModel::hertz), input.material.restitution = 0.2, input.second.restitution = 0.2; }},
    {"hertz_damped_synchronized", synchronized, 1.25, 0.3,
     [](Input& input) { dry(input, NormalModel::hertz), input.material.restitution = 0.2, input.second.restitution = 0.2; }},
    {"linear_damped", synchronized, 1, 0.25, [](Input& input) { dry(input, NormalModel::linear); }},
    {"jkr_elastic", synchronized, 1, 0.3, [](Input& input) { elastic(input); }},
    {"jkr", synchronized, 1, 0.3, [](Input&) {}},
    // A tangential spring that is stretched from some instant inside a step.
    {"hertz_holding", lagged, 1, 0.1, [](Input& input) { dry(input, NormalModel::hertz), elastic(input), rub(input, 0.005); }},
    {"hertz_holding_synchronized", synchronized, 1, 0.15,
     [](Input& input) { dry(input, NormalModel::hertz), elastic(input), rub(input, 0.005); }},
    {"jkr_mindlin_ar", synchronized, 1, 0.3, [](Input& input) { slide(input), input.surface.rolling = RollingModel::ar; }},
    {"wet_bridge", synchronized, 1, 0.3, [](Input& input) { wet(input, AttractionRange::bridge); }},
    {"wet_contact", synchronized, 1.15, 0.3, [](Input& input) { wet(input, AttractionRange::contact); }},
    // Washino et al. 2024, section 4: three spheres.
    {"w_case1", synchronized, 1, 0.3, [](Input& input) { row(input, "w-case1"); }},
    {"w_case2", synchronized, 1, 0.4, [](Input& input) { row(input, "w-case2"); }},
    {"w_case3", synchronized, 1, 0.4, [](Input& input) { row(input, "w-case3"); }},
};

class OrderOf : public testing::TestWithParam<Case> {};

TEST_P(OrderOf, TheDistanceToTheExactOutcomeIsWhatTheLawsAllow) {
  Input input;
  GetParam().change(input);
  const CollisionScene scene = collision_scene(input);
  constexpr int phases = 16;
  std::vector<double> steps, errors;
  for (double fraction = 0.1; fraction > 0.01; fraction /= 2) {
    const CollisionPoint point =
        measure_collision(scene, collision_methods()[static_cast<std::size_t>(GetParam().method)], fraction, phases);
    EXPECT_EQ(point.unparted, 0);
    steps.push_back(fraction), errors.push_back(point.motion_rms);
  }
  EXPECT_NEAR(convergence_order(steps, errors).order, GetParam().order, GetParam().tolerance);
  EXPECT_LT(errors.back(), errors.front() / 3);
}

INSTANTIATE_TEST_SUITE_P(Laws, OrderOf, testing::ValuesIn(cases), [](const auto& test) { return std::string(test.param.name); });

/// Springs that are stretched by the lagged velocity start half a step too long. In the mean over phases only this is left, and nothing of it where
/// half the step goes before the force and half after it.
TEST(MeanOf, AHeldSpringIsRightToSecondOrderWithVelocitiesOfTheForcesInstant) {
  Input input;
  dry(input, NormalModel::hertz), elastic(input), rub(input, 0.005);
  const CollisionScene scene = collision_scene(input);
  const auto mean_error = [&](Integrator integrator) {
    constexpr int phases = 64;
    double sum = 0;
    for (int k = 0; k < phases; ++k)
      sum += step_collision(scene, integrator, step_of(scene, 0.05), (k + 0.5) / phases).bodies[0].velocity.x() / phases;
    return std::abs(sum - scene.reference.bodies[0].velocity.x()) / scene.speed;
  };
  EXPECT_LT(mean_error(Integrator::synchronized), mean_error(Integrator::verlet) / 20);
}

}  // namespace
}  // namespace scalebreak

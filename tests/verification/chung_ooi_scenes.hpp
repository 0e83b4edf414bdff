#pragma once

#include <cmath>
#include <numbers>

#include <scalebreak/scene/input.hpp>

// The impacts of Chung & Ooi, Granular Matter 13 (2011) 643, as inputs.

namespace scalebreak::tests {

[[nodiscard]] inline Material chung_ooi_material(double young, double poisson, double density, double restitution, double friction = 0) {
  return {.young = young,
          .poisson = poisson,
          .density = density,
          .restitution = restitution,
          .sliding_friction = friction,
          .surface_energy = 0};
}

/// A sphere of the first material on a plane of the second, with Hertz's and Mindlin's contact on the overlap.
[[nodiscard]] inline Input chung_ooi_impact(const Material& first, const Material& second, double radius) {
  Input input{.material = first, .second = second, .wall = {second}, .radius = {radius}, .against_wall = true};
  input.contact = canonical({.normal = NormalModel::hertz});
  input.surface = {.tangential = TangentialModel::mindlin, .tangential_radius = DampingOn::overlap};
  return input;
}

/// Test 1: two equal spheres at ± 10 m/s.
[[nodiscard]] inline Input chung_ooi_1() {
  const Material limestone = chung_ooi_material(20e9, 0.25, 2500, 1);
  Input input = chung_ooi_impact(limestone, limestone, 10e-3);
  input.against_wall = false, input.radius = {10e-3, 10e-3}, input.normal_speed = 20;
  return input;
}

/// Test 2: a sphere on a rigid plane.
[[nodiscard]] inline Input chung_ooi_2() {
  const Material alloy = chung_ooi_material(40e9, 0.35, 1800, 1);
  Input input = chung_ooi_impact(alloy, alloy, 0.1);
  input.wall.rigid = true, input.normal_speed = 0.2;
  return input;
}

/// Test 3: restitution; aluminium oxide, or cast iron.
[[nodiscard]] inline Input chung_ooi_3(double restitution, bool iron) {
  const Material m = iron ? chung_ooi_material(100e9, 0.25, 7000, restitution) : chung_ooi_material(380e9, 0.23, 4000, restitution);
  Input input = chung_ooi_impact(m, m, 2.5e-3);
  input.normal_speed = 3.9;
  return input;
}

/// Test 4: an angle from the normal.
[[nodiscard]] inline Input chung_ooi_4(double degrees) {
  const Material oxide = chung_ooi_material(380e9, 0.23, 4000, 0.98, 0.092);
  Input input = chung_ooi_impact(oxide, oxide, 2.5e-3);
  const double angle = degrees * std::numbers::pi / 180;
  input.normal_speed = 3.9 * std::cos(angle), input.tangential_speed = 3.9 * std::sin(angle);
  return input;
}

/// Test 5: ψ is the surface's tangential speed over μ v_n.
[[nodiscard]] inline Input chung_ooi_5(double psi) {
  const Material steel = chung_ooi_material(208e9, 0.30, 7850, 1, 0.3);
  Input input = chung_ooi_impact(steel, steel, 10e-6);
  input.normal_speed = 5, input.tangential_speed = psi * 0.3 * 5;
  return input;
}

/// Tests 6 and 8: a spin alone, `reached` the share of it that friction would take if J were (1 + e) m v_n.
[[nodiscard]] inline Input chung_ooi_6(double reached) {
  const Material alloy = chung_ooi_material(70e9, 0.33, 2700, 0.5, 0.4);
  Input input = chung_ooi_impact(alloy, alloy, 0.1);
  input.normal_speed = 0.2;
  input.spin1 = {0, 3.5 * 0.4 * 1.5 * 0.2 / (reached * 0.1), 0};
  return input;
}
[[nodiscard]] inline Input chung_ooi_8(double reached) {
  Input input = chung_ooi_6(reached);
  input.second = chung_ooi_material(70e12, 0.33, 2.7e6, 0.5, 0.4);
  input.against_wall = false, input.radius = {0.1, 0.5};
  return input;
}

/// Test 7: head-on, with spins such that the surfaces go the same way.
[[nodiscard]] inline Input chung_ooi_7(double spin) {
  Input input = chung_ooi_6(1);
  input.against_wall = false, input.radius = {0.1, 0.1}, input.spin1.setZero();
  input.bodies = {{.position = {0, 0, 0.1}, .velocity = {0, 0, -0.2}, .spin = {0, spin, 0}, .radius = 0.1},
                  {.position = {0, 0, -0.1}, .velocity = {0, 0, 0.2}, .spin = {0, -spin, 0}, .radius = 0.1}};
  return input;
}

}  // namespace scalebreak::tests

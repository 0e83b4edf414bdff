#pragma once

#include <algorithm>
#include <cmath>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/dem/dem.hpp>
#include <scalebreak/scene/input.hpp>

// Scenes of few bodies as the soft-sphere engine runs them, beside the exact engine.

namespace scalebreak::test {

/// The setup of an input's laws.
inline DemSetup setup_of(const Input& input, double step_fraction = 0.15) {
  DemSetup setup{.contact = input.contact,
                 .surface = input.surface,
                 .material = input.material,
                 .second = input.second,
                 .wall = input.wall,
                 .law = *find_scaling_law(input.scaling_law),
                 .factor = input.scaling_factor};
  setup.contact = effective_kind(input.contact, input.material.surface_energy);
  const double smallest = input.bodies.empty() ? *std::min_element(input.radius.begin(), input.radius.end()) : input.bodies[0].radius;
  setup.step = step_fraction * rayleigh_step(setup, smallest * size_factor(setup.law, setup.factor));
  return setup;
}

/// The bodies of an input in a cell with open faces, or above a wall; all of [material] but those of [second].
inline System system_of(const Input& input) {
  const MovingScene scene = moving_scene(input);
  System system;
  double size = 0;
  for (const MovingBody& body : scene.bodies) {
    if (!body.plane) size = std::max(size, 20 * body.radius);
  }
  system.cell.size = Eigen::Vector3d::Constant(size);
  system.cell.boundary = {Boundary::open, Boundary::open, Boundary::open};
  Eigen::Vector3d corner = Eigen::Vector3d::Constant(size / 2);
  if (input.against_wall) system.cell.boundary[2] = Boundary::wall, corner.z() = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const MovingBody& body = scene.bodies[i];
    if (body.plane) continue;
    system.radius.push_back(body.radius);
    system.mass.push_back(body.mass);
    system.material.push_back(input.bodies.empty() ? static_cast<std::uint8_t>(i) : static_cast<std::uint8_t>(input.bodies[i].second));
    system.position.push_back(body.position + corner);
    system.velocity.push_back(body.velocity);
    system.spin.push_back(body.spin);
  }
  return system;
}

/// Runs until nothing touches any more, and something did.
inline System after_contact(Dem& dem, long most_steps = 10'000'000) {
  bool touched = false;
  while (dem.steps() < most_steps) {
    dem.advance(1);
    const bool touches = !dem.contact_forces().empty();
    if (touched && !touches) break;
    touched = touched || touches;
  }
  return dem.system();
}

}  // namespace scalebreak::test

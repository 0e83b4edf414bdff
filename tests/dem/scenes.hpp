#pragma once

#include <algorithm>
#include <cmath>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/dem/dem.hpp>
#include <scalebreak/ensembles/engine/bodies_start.hpp>
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

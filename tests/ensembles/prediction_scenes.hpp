#pragma once

#include <string>

#include <scalebreak/scene/input.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {

inline const std::string undamped = R"(
[material]
restitution = 1
surface_energy = 0
[contact]
normal = "hertz"
tangential = "mindlin"
[particles]
count = 200
radius = 0.5e-3
volume_fraction = 0.3
[cell]
kind = "shear"
shear_rate = 100
)";

inline const std::string cohesive = R"(
[contact]
normal = "jkr"
tangential = "mindlin"
[particles]
count = 200
[cell]
kind = "shear"
shear_rate = 400
)";

inline Input with(const std::string& scene, const std::string& law, double factor) {
  Input input = resolved(scene);
  input.scaling_law = law, input.scaling_factor = factor;
  return input;
}

/// Smooth spheres.
inline const std::string cooling = R"(
[material]
restitution = 0.9
surface_energy = 0
[contact]
normal = "hertz"
[particles]
count = 200
radius = 0.5e-3
volume_fraction = 0.1
speed = 0.1
[cell]
kind = "cooling"
[run]
warmup_duration = 0.03
duration = 0.02
)";

/// The cohesive scene in slow shear under a pressure.
inline Input pressed(const std::string& law, double factor, double surface_energy) {
  Input input = with(cohesive, law, factor);
  input.material.young = 1e8, input.material.surface_energy = surface_energy;
  input.cell.kind = CellKind::confined_shear, input.cell.pressure = 1000, input.cell.shear_rate = 6.32;
  return input;
}

}  // namespace scalebreak::tests

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/material/material.hpp>

namespace scalebreak {

/// Which way a law's factor goes.
enum class FactorOf {
  stiffness,          ///< Ω in (0, 1]
  size,               ///< l ≥ 1
  stiffness_or_size,  ///< below 1 softens, above 1 enlarges
};

/// A scaling law, one row of the table in docs/theory.md: powers of its factor. A parameter law changes the material. A
/// direct-force law maps the scaled pair to its original (overlap_O = overlap_S l^{−overlap}, and time
/// with it; speeds are the same and spins of the original are l times larger), evaluates the original force and torque there
/// and multiplies them (force_S = force_O l^{force}, torque_S = torque_O l^{torque}). Body forces grow with the mass, l³.
/// No force law knows that it is being scaled.
struct ScalingLaw {
  std::string_view name;
  FactorOf factor_of;
  bool direct_force = false;
  // Powers on the material, parameter laws:
  double young = 0, spring_constant = 0, surface_energy = 0, rolling_angle_max = 0;
  double liquid = 0, liquid_linear = 0;  ///< on the liquid's forces, beside a non-linear and beside a linear normal contact
  double adhesive_rolling = 0;           ///< on the torque of adhesive rolling, once the material is scaled
  // Powers of the pair map, direct-force laws:
  double overlap = 0, force = 0, torque = 0;
  std::string_view source;  ///< where it comes from
};

/// All laws, in the order of the documentation.
[[nodiscard]] const std::vector<ScalingLaw>& scaling_laws();

/// The law of a name, or nullptr.
[[nodiscard]] const ScalingLaw* find_scaling_law(std::string_view name);

/// The material of the scaled system beside a normal contact: parameter laws change it, the others leave it alone. The liquid's
/// forces are multiplied by what multiplies its surface tension and viscosity.
[[nodiscard]] Material scaled_material(const ScalingLaw& law, double factor, Material material, NormalModel normal);

/// How much larger the scaled particles are.
[[nodiscard]] double size_factor(const ScalingLaw& law, double factor);

/// Why a law cannot be used with this factor and contact: a sentence that names both, or nothing.
[[nodiscard]] std::optional<std::string> refusal(const ScalingLaw& law, double factor, NormalModel normal);

}  // namespace scalebreak

#include <scalebreak/scaling/scaling_law.hpp>

#include <cmath>

#include <fmt/format.h>

namespace scalebreak {

const std::vector<ScalingLaw>& scaling_laws() {
  using enum FactorOf;
  static const std::vector<ScalingLaw> laws = {
      {.name = "none", .factor_of = stiffness_or_size, .young = 1, .spring_constant = 1, .source = "no correction"},
      {.name = "rps",
       .factor_of = stiffness,
       .young = 1,
       .spring_constant = 1,
       .surface_energy = 2.0 / 5,
       .rolling_angle_max = -2.0 / 5,
       .liquid = 2.0 / 5,
       .liquid_linear = 1.0 / 2,
       .adhesive_rolling = 2.0 / 5,
       .source = "Washino et al. 2024, Tables 1 to 4"},
      {.name = "sup", .factor_of = size, .direct_force = true, .overlap = 1, .force = 2, .torque = 2, .source = "Hu 2024, Method 1"},
      {.name = "overlap_kept",
       .factor_of = size,
       .direct_force = true,
       .overlap = 0,
       .force = 2,
       .torque = 2,
       .source = "Hu 2024, chapter 4, Method 2"},
      {.name = "force_cubed",
       .factor_of = size,
       .direct_force = true,
       .overlap = 1,
       .force = 3,
       .torque = 3,
       .source = "Hu 2024, Method 3"},
      {.name = "torque_cubed",
       .factor_of = size,
       .direct_force = true,
       .overlap = 1,
       .force = 2,
       .torque = 3,
       .source = "Hu 2024, chapter 5, Method 2, after Chu et al. 2016"},
      {.name = "sakai", .factor_of = size, .direct_force = true, .overlap = 0, .force = 3, .torque = 4, .source = "Sakai & Koshizuka 2009"},
      {.name = "chen_elliott", .factor_of = size, .young = 5.0 / 2, .surface_energy = 2, .source = "Chen & Elliott, Table 3"},
      {.name = "bond", .factor_of = size, .surface_energy = 2, .source = "keeps F_po/mg (Chen & Elliott, eq. 26)"},
      {.name = "cohesion", .factor_of = size, .surface_energy = 8.0 / 5, .source = "keeps the Cohesion number (Chen & Elliott, eq. 27)"},
      {.name = "thakur",
       .factor_of = size,
       .spring_constant = 1,
       .surface_energy = 1,
       .source = "Bierwisch et al. 2009, Thakur et al. 2016"},
  };
  return laws;
}

const ScalingLaw* find_scaling_law(std::string_view name) {
  for (const ScalingLaw& law : scaling_laws()) {
    if (law.name == name) return &law;
  }
  return nullptr;
}

double size_factor(const ScalingLaw& law, double factor) {
  return law.factor_of == FactorOf::stiffness ? 1.0 : law.factor_of == FactorOf::size ? factor : std::max(factor, 1.0);
}

Material scaled_material(const ScalingLaw& law, double factor, Material material, NormalModel normal) {
  // Without a law, a factor above 1 enlarges and leaves the material alone.
  if (law.factor_of == FactorOf::stiffness_or_size && factor > 1) return material;
  material.young *= std::pow(factor, law.young);
  material.spring_constant *= std::pow(factor, law.spring_constant);
  material.spring_constant_tangential *= std::pow(factor, law.spring_constant);
  material.surface_energy *= std::pow(factor, law.surface_energy);
  material.rolling_angle_max *= std::pow(factor, law.rolling_angle_max);
  const double liquid = std::pow(factor, traits_of(normal).constant_spring ? law.liquid_linear : law.liquid);
  material.surface_tension *= liquid;
  material.viscosity *= liquid;
  // A law that multiplies every force and every inverse time by one number multiplies force over speed by it and force over length by
  // its square; the others treat the rolling spring as they do the linear ones.
  material.rolling_dashpot *= liquid;
  material.rolling_spring_constant *= liquid != 1 ? liquid * liquid : std::pow(factor, law.spring_constant);
  return material;
}

std::optional<std::string> refusal(const ScalingLaw& law, double factor, NormalModel normal) {
  if (law.factor_of == FactorOf::stiffness && factor > 1) {
    return fmt::format("scaling.law = \"{}\" reduces the stiffness, its scaling.factor lies in (0, 1], found {}", law.name, factor);
  }
  if (law.factor_of == FactorOf::size && factor < 1) {
    return fmt::format("scaling.law = \"{}\" enlarges the particles, its scaling.factor is at least 1, found {}", law.name, factor);
  }
  const bool surface_energy_only = !law.direct_force && law.young == 0 && law.spring_constant == 0;
  if (surface_energy_only && !traits_of(normal).adhesive()) {
    return fmt::format("scaling.law = \"{}\" scales the surface energy alone, which contact.normal = \"{}\" does not use; use {}", law.name,
                       to_string(normal), normal_names_where([](const NormalTraits& other) { return other.adhesive(); }));
  }
  if (law.young != 0 && law.spring_constant == 0 && traits_of(normal).constant_spring) {
    return fmt::format("scaling.law = \"{}\" scales Young's modulus, which contact.normal = \"{}\" does not use; use {}", law.name,
                       to_string(normal), normal_names_where([](const NormalTraits& other) { return !other.constant_spring; }));
  }
  return std::nullopt;
}

}  // namespace scalebreak

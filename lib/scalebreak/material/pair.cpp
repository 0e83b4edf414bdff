#include <scalebreak/material/pair.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scalebreak/contact/damping.hpp>

namespace scalebreak {
namespace {

double compliance(const Material& material) { return (1 - material.poisson * material.poisson) / material.young; }

/// Of the shear modulus: 2(2 − ν)(1 + ν)/E (Washino et al. 2024, eq. 14).
double shear_compliance(const Material& material) { return 2 * (2 - material.poisson) * (1 + material.poisson) / material.young; }

double in_series(double first, double second) { return 2 * first * second / (first + second); }

double geometric_mean(double first, double second) { return std::sqrt(first) * std::sqrt(second); }
double mean(double first, double second) { return (first + second) / 2; }

/// I + m r² of a solid sphere.
double rolling_inertia(const Material& material, double radius) {
  return 7.0 / 5.0 * sphere_mass(radius, material.density) * radius * radius;
}

/// The liquid that one sphere brings to one of its bridges. A sphere's liquid is shared among its twelve neighbours at the
/// densest packing (Hu 2024, eq. 4.2: 8.3 % of it for every pair).
double liquid_share(const Material& material, double radius) { return material.liquid_fraction * sphere_mass(radius, 1.0) / 12; }
double bridge_volume(const Material& first, double share1, const Material& second, double share2) {
  return share1 > 0 || share2 > 0 ? share1 + share2 : mean(first.liquid_volume, second.liquid_volume);
}
double separation_min(const Material& material, double radius) {
  return material.separation_min > 0 ? material.separation_min : material.separation_min_ratio * radius;
}

}  // namespace

double sphere_mass(double radius, double density) { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density; }

NormalPair sphere_pair(const Material& first, double radius1, const Material& second, double radius2) {
  const double mass1 = sphere_mass(radius1, first.density);
  const double mass2 = sphere_mass(radius2, second.density);
  return {.mass = mass1 * mass2 / (mass1 + mass2),
          .radius = radius1 * radius2 / (radius1 + radius2),
          .young = 1 / (compliance(first) + compliance(second)),
          .surface_energy = (first.surface_energy + second.surface_energy) / 2,
          .spring_constant = in_series(first.spring_constant, second.spring_constant),
          .damping_ratio = damping_ratio(std::sqrt(first.restitution) * std::sqrt(second.restitution))};
}

NormalPair wall_pair(const Material& sphere, double radius, const Wall& wall) {
  const double wall_compliance = wall.rigid ? 0.0 : compliance(wall.material);
  const double surface_energy = (sphere.surface_energy + wall.material.surface_energy) / 2;
  return {.mass = sphere_mass(radius, sphere.density),
          .radius = radius,
          .young = 1 / (compliance(sphere) + wall_compliance),
          .surface_energy = wall.attraction ? surface_energy : 0.0,
          .spring_constant = in_series(sphere.spring_constant, wall.material.spring_constant),
          .damping_ratio = damping_ratio(wall.material.restitution)};
}

SurfacePair sphere_surfaces(const Material& first, double radius1, const Material& second, double radius2) {
  const double inertia1 = rolling_inertia(first, radius1), inertia2 = rolling_inertia(second, radius2);
  return {.shear = 1 / (shear_compliance(first) + shear_compliance(second)),
          .spring_constant_tangential = in_series(first.spring_constant_tangential, second.spring_constant_tangential),
          .sliding_friction = geometric_mean(first.sliding_friction, second.sliding_friction),
          .rolling_friction = geometric_mean(first.rolling_friction, second.rolling_friction),
          .rolling_damping = geometric_mean(first.rolling_damping, second.rolling_damping),
          .rolling_angle_max = geometric_mean(first.rolling_angle_max, second.rolling_angle_max),
          .rolling_spring_constant = geometric_mean(first.rolling_spring_constant, second.rolling_spring_constant),
          .rolling_dashpot = geometric_mean(first.rolling_dashpot, second.rolling_dashpot),
          .surface_energy = mean(first.surface_energy, second.surface_energy),
          .rolling_inertia = inertia1 * inertia2 / (inertia1 + inertia2),
          .surface_tension = mean(first.surface_tension, second.surface_tension),
          .contact_angle = mean(first.contact_angle, second.contact_angle),
          .viscosity = mean(first.viscosity, second.viscosity),
          .bridge_volume = bridge_volume(first, liquid_share(first, radius1), second, liquid_share(second, radius2)),
          .separation_min = std::min(separation_min(first, radius1), separation_min(second, radius2))};
}

SurfacePair wall_surfaces(const Material& sphere, double radius, const Wall& wall) {
  const Material& other = wall.material;
  const double wet = wall.attraction ? 1 : 0;
  return {.shear = 1 / (shear_compliance(sphere) + (wall.rigid ? 0.0 : shear_compliance(other))),
          .spring_constant_tangential = in_series(sphere.spring_constant_tangential, other.spring_constant_tangential),
          .sliding_friction = other.sliding_friction,
          .rolling_friction = other.rolling_friction,
          .rolling_damping = other.rolling_damping,
          .rolling_angle_max = other.rolling_angle_max,
          .rolling_spring_constant = other.rolling_spring_constant,
          .rolling_dashpot = other.rolling_dashpot,
          .surface_energy = wet * mean(sphere.surface_energy, other.surface_energy),
          .rolling_inertia = rolling_inertia(sphere, radius),
          .surface_tension = wet * mean(sphere.surface_tension, other.surface_tension),
          .contact_angle = mean(sphere.contact_angle, other.contact_angle),
          .viscosity = wet * mean(sphere.viscosity, other.viscosity),
          .bridge_volume = bridge_volume(sphere, liquid_share(sphere, radius), other, 0.0),
          .separation_min = separation_min(sphere, radius)};
}

}  // namespace scalebreak

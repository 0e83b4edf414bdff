#include <scalebreak/material/pair.hpp>

#include <cmath>
#include <numbers>

#include <scalebreak/contact/damping.hpp>

namespace scalebreak {
namespace {

double compliance(const Material& material) { return (1 - material.poisson * material.poisson) / material.young; }

double in_series(double first, double second) { return 2 * first * second / (first + second); }

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

}  // namespace scalebreak

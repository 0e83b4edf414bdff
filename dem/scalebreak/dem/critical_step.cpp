#include <scalebreak/dem/critical_step.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scalebreak {
namespace {

/// Steps that a contact is to take.
constexpr double steps_per_contact = 30;
/// The safety factor f_l of Washino et al. 2024, eq. 54, by which a step fraction of 1 resolves an oscillation of a linear spring as
/// a step of the Rayleigh time does one of a Hertz contact.
constexpr double linear_safety = 0.1;

/// By what a direct-force law multiplies times (see scaled_pair: the original pair, with an inertia × l^{3−q−p}).
double time_factor(const DemSetup& setup) {
  if (!setup.law.direct_force) return 1;
  const double inertia = 3 - setup.law.overlap - setup.law.force;
  return std::pow(setup.factor, setup.law.overlap + std::min(0.0, inertia) / 2);
}

}  // namespace

double rayleigh_step(const DemSetup& setup, double smallest_radius) {
  const double size = size_factor(setup.law, setup.factor);
  const auto of = [&](const Material& original) {
    const Material material = setup.law.direct_force ? original : scaled_material(setup.law, setup.factor, original, setup.contact.normal);
    const double radius = setup.law.direct_force ? smallest_radius / size : smallest_radius;
    return std::numbers::pi * radius * std::sqrt(2 * material.density * (1 + material.poisson) / material.young) /
           (0.8766 + 0.163 * material.poisson);
  };
  return time_factor(setup) * std::min(of(setup.material), of(setup.second));
}

std::vector<StepBound> critical_steps(const DemSetup& setup, double smallest_radius, double contact_time) {
  std::vector<StepBound> bounds;
  if (setup.contact.traits().constant_spring) {
    const double size = size_factor(setup.law, setup.factor);
    const auto of = [&](const Material& original) {
      const Material material =
          setup.law.direct_force ? original : scaled_material(setup.law, setup.factor, original, setup.contact.normal);
      const double radius = setup.law.direct_force ? smallest_radius / size : smallest_radius;
      return 2 * std::numbers::pi * linear_safety * std::sqrt(sphere_mass(radius, material.density) / material.spring_constant);
    };
    bounds.push_back({"oscillation", time_factor(setup) * std::min(of(setup.material), of(setup.second))});
  } else {
    bounds.push_back({"Rayleigh", rayleigh_step(setup, smallest_radius)});
  }
  if (contact_time > 0) bounds.push_back({"contact time", contact_time / steps_per_contact});
  std::sort(bounds.begin(), bounds.end(), [](const StepBound& a, const StepBound& b) { return a.step < b.step; });
  return bounds;
}

}  // namespace scalebreak

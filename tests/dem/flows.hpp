#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/dem/dem.hpp>
#include <scalebreak/start/filling.hpp>

// Gases and sheared cells for the soft-sphere engine.

namespace scalebreak::test {

/// A cube with so many spheres at a volume fraction, radii as given (repeated), of glass.
inline System filled(std::size_t count, double volume_fraction, const std::vector<double>& radii, double speed, double shear_rate = 0,
                     Boundary along_z = Boundary::periodic) {
  Filling filling;
  double solid = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = radii[i % radii.size()];
    filling.radius.push_back(radius);
    filling.mass.push_back(sphere_mass(radius, 2500));
    filling.material.push_back(0);
    solid += sphere_mass(radius, 1.0);
  }
  filling.cell.size = Eigen::Vector3d::Constant(std::cbrt(solid / volume_fraction));
  filling.cell.boundary[2] = along_z;
  filling.cell.shear_rate = shear_rate;
  filling.speed = speed;
  filling.seed = 7;
  return fill(filling);
}

/// Hertz spheres of this modulus and restitution, without friction.
inline DemSetup smooth(double young, double restitution, double step_fraction, double radius) {
  DemSetup setup{.contact = {NormalModel::hertz, AdhesionRange::touch, DampingOn::overlap}};
  for (Material* material : {&setup.material, &setup.second, &setup.wall.material}) {
    material->young = young;
    material->restitution = restitution;
    material->surface_energy = 0;
  }
  setup.step = step_fraction * rayleigh_step(setup, radius);
  return setup;
}

/// The same with friction and rolling.
inline DemSetup rough(double young, double restitution, double step_fraction, double radius) {
  DemSetup setup = smooth(young, restitution, step_fraction, radius);
  setup.surface = {.tangential = TangentialModel::mindlin, .tangential_radius = DampingOn::overlap, .rolling = RollingModel::epsd2};
  return setup;
}

inline double kinetic_energy_about_flow(const System& system) {
  double energy = 0;
  for (std::size_t i = 0; i < system.count(); ++i) {
    const Eigen::Vector3d v = system.velocity[i] - mean_flow(system.cell, system.position[i].z());
    energy += system.mass[i] / 2 * v.squaredNorm() + system.inertia(i) / 2 * system.spin[i].squaredNorm();
  }
  return energy;
}

inline Eigen::Vector3d momentum_of(const System& system) {
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < system.count(); ++i)
    momentum += system.mass[i] * (system.velocity[i] - mean_flow(system.cell, system.position[i].z()));
  return momentum;
}

}  // namespace scalebreak::test

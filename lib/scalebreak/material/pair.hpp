#pragma once

#include <scalebreak/material/material.hpp>

namespace scalebreak {

/// What the normal contact of two bodies depends on, SI.
struct NormalPair {
  double mass;             ///< m* [kg]
  double radius;           ///< R* [m]
  double young;            ///< E* [Pa]
  double surface_energy;   ///< γ of ONE surface, the mean of the two, so that Γ = 2γ = γ₁ + γ₂ [J/m²]
  double spring_constant;  ///< k of the linear contact [N/m]
  double damping_ratio;    ///< β of the restitution [-]
};

/// Mass of a sphere [kg].
[[nodiscard]] double sphere_mass(double radius, double density);

/// Two spheres (radii in m, positive). Unlike materials meet with the geometric mean of their restitutions
/// (the practice of LAMMPS) and with their linear springs in series.
[[nodiscard]] NormalPair sphere_pair(const Material& first, double radius1, const Material& second, double radius2);

/// A sphere and a flat wall. The wall's restitution is that of the pair.
[[nodiscard]] NormalPair wall_pair(const Material& sphere, double radius, const Wall& wall);

}  // namespace scalebreak

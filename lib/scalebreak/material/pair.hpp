#pragma once

#include <scalebreak/material/material.hpp>

namespace scalebreak {

/// What the normal contact of two bodies depends on, SI.
template <class T>
struct NormalPairOf {
  T mass;             ///< m* [kg]
  T radius;           ///< R* [m]
  T young;            ///< E* [Pa]
  T surface_energy;   ///< γ of ONE surface, the mean of the two, so that Γ = 2γ = γ₁ + γ₂ [J/m²]
  T spring_constant;  ///< k of the linear contact [N/m]
  T damping_ratio;    ///< β of the restitution [-]
};
using NormalPair = NormalPairOf<double>;

/// What else the contact of two bodies depends on, SI. Coefficients of unlike spheres are geometric means, those of `sds` too; linear
/// springs act in series, of the liquid's properties the means are taken; coefficients given for a wall are the pair's.
struct SurfacePair {
  double shear;                       ///< G* [Pa]
  double spring_constant_tangential;  ///< [N/m]
  double sliding_friction;            ///< [-]
  double rolling_friction;            ///< [-]
  double rolling_damping;             ///< [-]
  double rolling_angle_max;           ///< [rad]
  double rolling_spring_constant;     ///< [N/m]
  double rolling_dashpot;             ///< [N s/m]
  double surface_energy;              ///< γ of ONE surface, for adhesive rolling [J/m²]; 0 against a wall without attraction
  double rolling_inertia;             ///< I_r, 1/I_r = Σ 1/(I + m r²) (Washino et al. 2024, eq. 47) [kg m²]
  double surface_tension;             ///< [N/m]; 0 where no bridge forms
  double contact_angle;               ///< [rad]
  double viscosity;                   ///< [Pa s]; 0 where no bridge forms
  double bridge_volume;               ///< [m³]
  double separation_min;              ///< [m]
};

/// Mass of a sphere [kg].
[[nodiscard]] double sphere_mass(double radius, double density);

/// Two spheres (radii in m, positive). Unlike materials meet with the geometric mean of their restitutions
/// (the practice of LAMMPS) and with their linear springs in series.
[[nodiscard]] NormalPair sphere_pair(const Material& first, double radius1, const Material& second, double radius2);

/// A sphere and a flat wall. The wall's restitution is that of the pair.
[[nodiscard]] NormalPair wall_pair(const Material& sphere, double radius, const Wall& wall);

/// The same for the surfaces.
[[nodiscard]] SurfacePair sphere_surfaces(const Material& first, double radius1, const Material& second, double radius2);
[[nodiscard]] SurfacePair wall_surfaces(const Material& sphere, double radius, const Wall& wall);

}  // namespace scalebreak

#pragma once

namespace scalebreak {

/// A material, SI. The defaults are the glass sphere of Washino et al. 2024, Table 9 and section 5.1.
struct Material {
  double young = 10e9;             ///< Young's modulus [Pa]
  double poisson = 0.25;           ///< Poisson's ratio [-]
  double density = 2500.0;         ///< [kg/m³]
  double restitution = 0.81;       ///< of a collision without adhesion [-]
  double sliding_friction = 0.3;   ///< Coulomb's coefficient [-]
  double surface_energy = 0.02;    ///< of ONE surface; the work of adhesion is twice this [J/m²]
  double spring_constant = 8.1e4;  ///< of the linear contact of two such spheres [N/m]

  double spring_constant_tangential = 8.1e4;  ///< of their linear tangential contact [N/m]
  double rolling_friction = 0.1;              ///< μ_r of cdt, epsd, epsd2 and sds [-]
  double rolling_damping = 0.1;               ///< η_r of epsd [-]
  double rolling_angle_max = 0.01;            ///< θ_max of adhesive rolling [rad]
  double rolling_spring_constant = 8.1e4;     ///< k_r of sds, force over displacement [N/m]
  double rolling_dashpot = 0.06;              ///< γ_r of sds, force over speed; a tenth of the critical one of two such spheres [N s/m]

  // The liquid; the defaults are those of Washino et al. 2024, Table 6.
  double surface_tension = 0.07;         ///< [N/m]
  double contact_angle = 0.0;            ///< [rad]
  double viscosity = 0.001;              ///< [Pa s]
  double liquid_volume = 2.18e-12;       ///< of one bridge [m³]; used if there is no share of the solids
  double liquid_fraction = 0.0;          ///< liquid over solid volume [-]; a twelfth of it sits in each bridge
  double separation_min = 0.0;           ///< S_min [m]; used if it is above 0
  double separation_min_ratio = 0.0005;  ///< S_min over the (smaller) radius [-]; used otherwise

  bool operator==(const Material&) const = default;
};

/// A flat wall: infinite mass and radius, and a material of its own.
struct Wall {
  Material material;
  bool rigid = false;      ///< its term drops out of E* and G*
  bool attraction = true;  ///< false: nothing sticks to it, and no bridge forms

  bool operator==(const Wall&) const = default;
};

}  // namespace scalebreak

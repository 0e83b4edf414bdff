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

  bool operator==(const Material&) const = default;
};

/// A flat wall: infinite mass and radius, and a material of its own.
struct Wall {
  Material material;
  bool rigid = false;      ///< its term drops out of E*
  bool attraction = true;  ///< false: nothing sticks to it

  bool operator==(const Wall&) const = default;
};

}  // namespace scalebreak

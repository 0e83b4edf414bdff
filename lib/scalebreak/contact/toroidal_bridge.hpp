#pragma once

namespace scalebreak {

/// The toroidal solution of a liquid bridge between two equal spheres (Fisher; Hu 2024, eqs 2.33–2.41), for comparison with
/// the closed form of Liquid.
struct ToroidalBridge {
  double filling_angle;      ///< half-filling angle ψ [rad]
  double meridional_radius;  ///< r₁ of the arc over the sphere's radius
  double neck_radius;        ///< r₂ of the neck over the sphere's radius
  double force;              ///< attraction, over 2πσ times the sphere's radius
};

/// `volume` of the bridge over that of one sphere, `half_separation` over the radius, contact angle in rad. Throws WorkError
/// if no arc of that volume spans the gap.
[[nodiscard]] ToroidalBridge toroidal_bridge(double volume, double half_separation, double contact_angle);

}  // namespace scalebreak

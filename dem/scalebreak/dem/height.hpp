#pragma once

#include <cmath>

namespace scalebreak::dem {

/// The height H of a periodic cell that follows the normal stress P_zz across it, as if a plate lay on the flow that bears the wanted
/// pressure P and a dashpot:
///
///     Ḧ = (P_zz − P)/μ − (c/τ) Ḣ,   τ = √(μH/P)
///
/// μ is the mass of a layer of spheres over its area, each taking d² of it (Σm/Σd²), and c = 5. So light a plate answers within the time
/// that sound takes through √(H/d) layers: slower than a contact by a factor of about 2√(H/d), and faster than the shear wherever sound is.
/// Against the stiffness of the flow, K = −H dP_zz/dH, its damping is c√(P/K)/2 of the critical one: more than that for the gas and the
/// inertial flow (K of a few P), and for a packing of stiff spheres a fraction, beside what contacts themselves dissipate. In the mean over
/// time Ḧ and Ḣ/√H vanish, so that the mean of P_zz is P whatever μ and c are.
///
/// A plate with a dashpot but no inertia: da Cruz et al., Phys. Rev. E 72, 021309 (2005); periodic cells under a normal stress: Peyneau &
/// Roux, Phys. Rev. E 78, 011307 (2008).
struct Height {
  static constexpr double damping = 5;  ///< c

  double pressure = 0;  ///< P [Pa]; 0: the height is kept
  double inertia = 0;   ///< μ [kg/m²]
  double speed = 0;     ///< Ḣ, half a step behind [m/s]

  [[nodiscard]] bool follows() const { return pressure > 0; }

  /// The speed half a step ahead, of a height [m] under a stress P_zz [Pa]; `step` in s.
  [[nodiscard]] double pushed(double height, double stress, double step) const {
    const double drag = damping / 2 * step / std::sqrt(inertia * height / pressure);
    return ((1 - drag) * speed + step * (stress - pressure) / inertia) / (1 + drag);
  }
};

}  // namespace scalebreak::dem

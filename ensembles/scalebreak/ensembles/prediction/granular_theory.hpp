#pragma once

// What kinetic theory says of sheared spheres: enough to know, before a flow runs, how fast its spheres fluctuate and how often they meet.
// Equal spheres of diameter d [m] and density ρ [kg/m³] that fill a share φ of the cell; granular temperature T is one third of the mean squared
// velocity about the mean flow [m²/s²].

namespace scalebreak {

/// Restitution of frictionless spheres that lose as much as ones with restitution e and friction μ: e − (3/2) μ exp(−3μ), at least 0 (Chialvo &
/// Sundaresan 2013, Phys. Fluids 25, 070603).
[[nodiscard]] double effective_restitution(double restitution, double friction);

/// The volume fraction at which spheres of a friction jam in shear: 0.636, 0.613, 0.596, 0.587 and 0.581 at μ = 0, 0.1, 0.3, 0.5 and 1, linear between, the last
/// beyond: what is quoted of Chialvo, Sun & Sundaresan (Phys. Rev. E 85 (2012) 021305), second hand. Flows of this program under a pressure, at an inertial number of
/// 0.01, come to 0.641, 0.622, 0.600, 0.588 and 0.579 (docs/flows.md).
[[nodiscard]] double jamming_fraction(double friction);

/// How much more often spheres of a dense fluid meet than those of a dilute gas: (1 − φ/2)/(1 − φ)³ (Carnahan & Starling 1969).
[[nodiscard]] double fluid_contact_value(double volume_fraction);

/// The same of a sheared flow, which has beside it 0.58 φ²/(φ_c − φ)^{3/2}, which diverges where they jam (Chialvo & Sundaresan 2013, eq. 31). Needs φ < φ_c.
[[nodiscard]] double contact_value(double volume_fraction, double jamming);

/// The share of the second of its two parts.
[[nodiscard]] double jamming_share(double volume_fraction, double jamming);

/// T/(γ̇d)² of steady homogeneous shear, in which the work of shear is what collisions dissipate:
///
///     T/(γ̇d)² = 2J / (15 (1 − e²)),  J = (1 + e)/2 + π/32 · [5 + 2(1 + e)(3e − 1)G][5 + 4(1 + e)G] / ([24 − 6(1 − e)² − 5(1 − e²)] G²)
///
/// with G = φχ and the effective restitution e (Jenkins & Berzi 2010, Granular Matter 12, 151; Garzó & Dufty's theory). Needs e < 1.
[[nodiscard]] double shear_temperature_number(double volume_fraction, double contact_value, double effective_restitution);

/// Collisions of a sphere, 24 φχ √T / (√π d) (Enskog) [1/s].
[[nodiscard]] double collisions_of_sphere(double volume_fraction, double contact_value, double temperature, double diameter);

/// Pressure of the gas, ρφ(1 + 2(1 + e)φχ) T, e the effective restitution [Pa].
[[nodiscard]] double collisional_pressure(double density, double volume_fraction, double contact_value, double effective_restitution,
                                          double temperature);

/// The mean speed at which spheres of Maxwell's distribution approach along the line of centres when they meet, √(πT) [m/s].
[[nodiscard]] double mean_impact_speed(double temperature);

}  // namespace scalebreak

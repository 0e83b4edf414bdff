#pragma once

// What kinetic theory says of a gas of rough spheres that is left alone: how its translational and rotational energy fall. Collisions are independent, velocities
// and spins are Maxwell's, each with its own temperature (Herbst, Huthmann & Zippelius, Granular Matter 2 (2000) 211); without friction it is Haff's law.

namespace scalebreak {

/// Energy in units of a sphere's mass: T is a third of the mean squared velocity, R a third of inertia × (radius × spin)², both [m²/s²].
struct GasTemperatures {
  double translational = 0, rotational = 0;
};

/// How two such spheres collide. A surface slides at the friction, or is brought to rest where that takes less: what its spring gives back, which depends on the
/// angle, is left out.
struct RoughCollision {
  double restitution = 1;     ///< of impacts without adhesion
  double friction = 0;        ///< 0: smooth
  double inertia = 0.4;       ///< moment over mass × radius², as torques meet it
  double sticking_speed = 0;  ///< [m/s]; of an impact at v there is left e²(v² − v_s²), below v_s nothing
};

/// By how much a collision changes 3T and 3R of its two spheres, on average, half of the pair's change [m²/s²].
[[nodiscard]] GasTemperatures change_by_collision(const RoughCollision& collision, const GasTemperatures& at);

/// The share of collisions below the sticking speed, 1 − exp(−v_s²/4T).
[[nodiscard]] double sticking_share(double sticking_speed, double temperature);

/// A gas at its start, where nothing spins.
struct CoolingGas {
  RoughCollision collision;
  double temperature = 0;         ///< [m²/s²]
  double collision_rate = 0;      ///< of a sphere whose collisions take no time [1/s]
  double busy = 0;                ///< contact time × collision rate
  double contact_time_power = 0;  ///< contact time ∝ speed^−power: 1/5 of Hertz's contact, 0 of a linear spring
  double begin = 0, end = 0;      ///< of the measurement, after the start [s]
};

/// Means over the measurement, and what there is at its end.
struct CooledGas {
  GasTemperatures mean;
  double collision_rate = 0;  ///< [1/s]
  double busy = 0;            ///< contact time × collision rate, at the mean temperature
  double last_temperature = 0;
};
/// `rarer`: contacts that last make collisions (1 + contact time × collision rate)^rarer times as many, which is below 0. By Runge & Kutta's fourth order, in steps
/// of a fifth of a sphere's time between collisions.
[[nodiscard]] CooledGas cool(const CoolingGas& gas, double rarer);

}  // namespace scalebreak

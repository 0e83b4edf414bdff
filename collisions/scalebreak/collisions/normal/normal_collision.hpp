#pragma once

#include <functional>

#include <scalebreak/contact/contact_kind.hpp>

namespace scalebreak {

/// One instant of a contact, in reduced variables. Forces are positive in repulsion.
template <class T>
struct ContactSample {
  T time;
  T coordinate;  ///< √a, or the overlap of a linear contact
  T overlap;
  T speed;  ///< of approach
  T elastic_force;
  T damping_force;
};

/// How a collision is resolved.
template <class T>
struct CollisionOptions {
  T tolerance = T(1e-8);                                       ///< of e² and the relative contact time, 1e-13 to 1e-6
  bool find_max_force = false;                                 ///< costs a search along the path
  T max_step = 0;                                              ///< bound on a step, as a fraction of about one contact; 0: none
  std::function<void(const ContactSample<T>&)> observer = {};  ///< called at first touch, every step and the end
};

/// The outcome of a normal collision, in reduced variables (see contact/reduced.hpp).
template <class T>
struct NormalOutcome {
  bool stuck = false;  ///< the pair turned back before the contact's end, or only creeps apart
  T restitution = 0;   ///< outgoing over incoming speed, 0 if stuck
  T contact_time = 0;  ///< 0 if stuck
  T max_overlap = 0;
  T max_coordinate = 0;  ///< √a at the maximum overlap, or that overlap itself of a linear contact
  T max_force = 0;       ///< of spring and dashpot together; only if asked for
  T energy_residue = 0;  ///< energy left at separation, or missing there (negative), over m*·(speed unit)²; for β < 1
  int steps = 0;
};

/// Resolves the normal collision of one pair that first touches at reduced speed v̂ (1 without adhesion),
/// with damping ratio β ≥ 0, by Fehlberg's 7(8) pair in the regular variables (√a, δ̇, t) and dt = (dδ/dx) ds, in
/// which the turning point and the tear-off fold are ordinary points. Turning points and the end of
/// the contact are found as roots on the step that holds them.
///
/// Throws WorkError when the path stops being finite, stalls, or passes its cap of steps.
/// T: double or long double.
template <class T>
[[nodiscard]] NormalOutcome<T> resolve_normal_collision(const ContactKind& kind, T damping_ratio, T reduced_speed,
                                                        const CollisionOptions<T>& options = {});

/// The reduced speed below which the pair sticks: the root of the energy residue, 0 where nothing can stick (no
/// adhesion, or an undamped contact that ends at touch), infinite where everything does (adhesion and β ≥ 1). To the
/// tolerance, and to 1e-6 for contacts that end at touch with β < 1e-6.
template <class T>
[[nodiscard]] T reduced_sticking_speed(const ContactKind& kind, T damping_ratio, T tolerance = T(1e-12));

}  // namespace scalebreak

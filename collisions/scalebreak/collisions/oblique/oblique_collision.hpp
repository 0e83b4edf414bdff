#pragma once

#include <array>
#include <limits>

#include <scalebreak/contact/contact_laws.hpp>

namespace scalebreak {

/// Two bodies that collide in one plane: friction and rolling, no liquid. SI, or any consistent units.
struct ObliquePair {
  ContactLaws laws;
  double mass = 0;                                            ///< m*
  std::array<double, 2> radius = {0, 0};                      ///< the second 0 for a wall
  std::array<double, 2> inertia = {0, 0};                     ///< about the centres; infinite for a wall
  double distance = std::numeric_limits<double>::infinity();  ///< of the centres at first touch; infinite: the normal never turns
  bool wall = false;
};

/// How they meet at first touch: the first body's velocity relative to the second, towards it and along the contact, and the spins about
/// the binormal, positive where they add to the sliding speed v_t + r₁ω₁ + r₂ω₂.
struct ObliqueImpact {
  double normal_speed = 0;
  double tangential_speed = 0;
  std::array<double, 2> spin = {0, 0};
};

/// What comes of it, in the frame of the line of centres at separation. Zero but for the counts and the overlap where it sticks.
struct ObliqueOutcome {
  bool stuck = false;
  double normal_speed = 0;  ///< of separation
  double tangential_speed = 0;
  std::array<double, 2> spin = {0, 0};
  double contact_time = 0;
  double displacement = 0;  ///< ∫ v_t dt over the contact
  double turned = 0;        ///< angle by which the line of centres turned, ∫ v_t/d dt [rad]
  double max_overlap = 0;
  int slips = 0;  ///< times that it began to slide, the first instant included
  int holds = 0;  ///< times that it stopped sliding
  int rolls = 0;  ///< times that it began to roll at its limit, the first instant included
  bool sliding_at_end = false;
  int steps = 0;
};

/// Resolves an oblique collision, every change of grip located as an event. `tolerance` is that of the outcome's speeds relative to the
/// impact's. The pair sticks if it turns back before the contact's end. Throws WorkError where the path cannot be followed.
[[nodiscard]] ObliqueOutcome resolve_oblique_collision(const ObliquePair& pair, const ObliqueImpact& impact, double tolerance = 1e-8);

}  // namespace scalebreak

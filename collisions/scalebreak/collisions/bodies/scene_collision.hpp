#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scalebreak/collisions/bodies/few_bodies.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// What two bodies did to each other, along the directions at first touch.
struct PairMeasures {
  bool stuck = false;                            ///< they cannot part any more
  double impact_speed = 0;                       ///< of approach at first touch [m/s]
  double tangential_speed = 0;                   ///< of the centres past each other, there [m/s]
  double surface_speed = 0;                      ///< of the surfaces past each other, there [m/s]
  Eigen::Vector3d surface_direction{1, 0, 0};    ///< of that; of the centres' where the surfaces move together
  std::optional<double> restitution_normal;      ///< −after/before; all are 0 if stuck, none where the divisor is zero
  std::optional<double> restitution_tangential;  ///< of the centres, after/before (e_t of Kharaz et al. 2001)
  std::optional<double> restitution_surface;     ///< of the surface points, −after/before (β of Chung & Ooi 2011)
  std::optional<double> contact_time;            ///< from first touch to the last separation [s]; none if still in contact
  std::optional<double> sticking_speed;          ///< of the normal contact [m/s]; none where a liquid acts, see ScaledContact
};

/// What came of an input, of its scaled system.
struct SceneCollision {
  std::string modelled;              ///< the kinds of the contact
  bool head_on = false;              ///< resolved in the normal direction alone
  std::vector<MovingBody> before;    ///< at the start
  std::vector<MovingBody> after;     ///< at the end; of two that stick, in their common motion
  MotionOutcome motion;              ///< of head-on pairs too
  double internal = 0;               ///< kinetic energy at the end of two that stick, within their common motion [J]
  bool deep = false;                 ///< an overlap exceeds deep_overlap · R*
  bool idle_spins = false;           ///< spins are given, and nothing acts on them
  std::optional<PairMeasures> pair;  ///< of two bodies

  [[nodiscard]] double energy_before() const { return kinetic_energy(before); }
  [[nodiscard]] double energy_after() const { return kinetic_energy(after); }
};

/// Is it a pair between which nothing tangential happens?
[[nodiscard]] bool is_head_on(const Input& input);

/// Resolves the collision of an input exactly, the scaling law applied. Throws WorkError.
[[nodiscard]] SceneCollision resolve_collision(const Input& input);

/// The common motion of two bodies that stick: as one rigid body with the momentum and the angular momentum that they have; with a
/// body of infinite mass, at rest relative to it. What nothing tangential acts on keeps its spin (`coupled` false), and slides on.
[[nodiscard]] std::vector<MovingBody> common_motion(std::vector<MovingBody> bodies, bool coupled);

}  // namespace scalebreak

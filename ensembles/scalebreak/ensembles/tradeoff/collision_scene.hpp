#pragma once

#include <optional>
#include <vector>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// A collision of a pair or of a few bodies, and how it ends exactly: what methods are compared with.
struct CollisionScene {
  Input input;
  MovingScene moving;       ///< the scaled system
  MotionOutcome reference;  ///< by the exact engine at `reference_tolerance`
  double duration = 0;      ///< that is followed [s]; 0: until all have parted
  double speed = 0;         ///< largest relative speed of two bodies at the start [m/s]

  /// Is it one of [pair] and [impact], which touches as it begins?
  [[nodiscard]] bool is_pair() const { return input.bodies.empty(); }
  /// Does nothing touch any more where it ends?
  [[nodiscard]] bool has_parted() const { return !reference.resting && reference.open_contacts == 0; }
};
inline constexpr double reference_tolerance = 1e-12;

/// Throws InputError where the bodies do not part and run.duration says no end, and WorkError where the motion cannot be followed.
[[nodiscard]] CollisionScene collision_scene(const Input& input);

/// How a collision ends by some method, and what that took.
struct CollisionOutcome {
  std::vector<MovingBody> bodies;      ///< in the order of the scene; positions are not compared
  std::optional<double> contact_time;  ///< of a pair that has parted and had no bridge [s]
  bool parted = true;                  ///< false: what should have parted still touches
  double force_evaluations = 0;        ///< of contacts; a lookup and a formula count as one
  double seconds = 0;                  ///< of wall time
};

/// The difference of an outcome from the exact one.
struct CollisionError {
  double motion = 0;                   ///< largest of |Δv| and r|Δω| of a body, over the scene's speed
  double energy = 0;                   ///< kinetic energy gained, over that at the start
  std::optional<double> contact_time;  ///< relative
};
[[nodiscard]] CollisionError collision_error(const CollisionScene& scene, const CollisionOutcome& outcome);

}  // namespace scalebreak

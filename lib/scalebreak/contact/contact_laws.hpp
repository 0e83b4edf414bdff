#pragma once

#include <scalebreak/contact/liquid.hpp>
#include <scalebreak/contact/normal_law.hpp>
#include <scalebreak/contact/rolling.hpp>
#include <scalebreak/contact/tangential.hpp>

namespace scalebreak {

/// All the laws between two bodies, SI.
struct ContactLaws {
  NormalLaw normal;
  double radius = 0;  ///< R* [m]
  Tangential tangential;
  Rolling rolling;
  Liquid liquid;
  TorqueArm arm = TorqueArm::radius;

  [[nodiscard]] bool spins() const { return tangential.acts() || rolling.acts() || liquid.viscous; }
  /// Does a law ask for F_N?
  [[nodiscard]] bool uses_load() const { return tangential.acts() || (rolling.acts() && rolling.model != RollingModel::ar); }
  /// Is a law smooth in δ^{1/4} and not in the normal law's own coordinate? A Hertz contact has both in one.
  [[nodiscard]] bool needs_overlap_root() const;
  /// How far apart the surfaces can be and still act on each other: at the end of an adhesive contact, or of a bridge [m].
  [[nodiscard]] double reach() const;
};

/// The kind must suit the pair (see effective_kind). `adhesive_rolling` multiplies the torque of adhesive rolling.
[[nodiscard]] ContactLaws contact_laws(const ContactKind& kind, const SurfaceKind& surface, const NormalPair& pair,
                                       const SurfacePair& surfaces, double adhesive_rolling = 1);

}  // namespace scalebreak

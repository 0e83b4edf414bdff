#pragma once

#include <string>

#include <scalebreak/contact/contact_kind.hpp>

namespace scalebreak {

/// The tangential force law: none, a constant spring, or Mindlin's, which grows with the contact.
enum class TangentialModel { none, linear, mindlin };

/// The rolling resistance: constant directional torque, the two elastic–plastic springs, adhesive rolling, and a spring, dashpot
/// and slider of constant coefficients.
enum class RollingModel { none, cdt, epsd, epsd2, ar, sds };

/// The liquid's forces.
enum class Attraction { none, capillary, viscous, capillary_viscous };

/// Where a liquid acts: while the solids touch, or from first touch until its bridge ruptures.
enum class AttractionRange { contact, bridge };

/// The lever of a surface force about the centre: the radius, or the distance to the contact point.
enum class TorqueArm { radius, contact };

/// Everything beside the normal law that decides the *form* of a contact; the numbers are left to the pair.
struct SurfaceKind {
  TangentialModel tangential = TangentialModel::none;
  DampingOn tangential_radius = DampingOn::contact_radius;  ///< √(R*δ) or the contact radius, of Mindlin's spring
  TorqueArm torque_arm = TorqueArm::radius;
  RollingModel rolling = RollingModel::none;
  Attraction attraction = Attraction::none;
  AttractionRange attraction_range = AttractionRange::bridge;

  bool operator==(const SurfaceKind&) const = default;

  [[nodiscard]] bool capillary() const { return attraction == Attraction::capillary || attraction == Attraction::capillary_viscous; }
  [[nodiscard]] bool viscous() const { return attraction == Attraction::viscous || attraction == Attraction::capillary_viscous; }
  /// Does anything turn the bodies?
  [[nodiscard]] bool spins() const { return tangential != TangentialModel::none || rolling != RollingModel::none || viscous(); }
};

[[nodiscard]] const char* to_string(TangentialModel model);
[[nodiscard]] const char* to_string(RollingModel model);
[[nodiscard]] const char* to_string(Attraction attraction);
[[nodiscard]] const char* to_string(AttractionRange range);
[[nodiscard]] const char* to_string(TorqueArm arm);

/// "mindlin on contact_radius, arm radius, rolling ar": what acts, and nothing of what does not; "nothing tangential".
[[nodiscard]] std::string to_string(const SurfaceKind& kind);

}  // namespace scalebreak

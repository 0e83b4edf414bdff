#pragma once

#include <cstddef>
#include <string>

#include <scalebreak/contact/contact_kind.hpp>

namespace scalebreak {

/// The tangential force law, its words in the order of the enumeration, here and below: none, a constant spring, or Mindlin's, which grows with the contact.
enum class TangentialModel { none, linear, mindlin };
inline constexpr const char* tangential_words[] = {"none", "linear", "mindlin"};

/// The rolling resistance: constant directional torque, the two elastic–plastic springs, adhesive rolling, and a spring, dashpot
/// and slider of constant coefficients.
enum class RollingModel { none, cdt, epsd, epsd2, ar, sds };
inline constexpr const char* rolling_words[] = {"none", "cdt", "epsd", "epsd2", "ar", "sds"};

/// The liquid's forces.
enum class Attraction { none, capillary, viscous, capillary_viscous };
inline constexpr const char* attraction_words[] = {"none", "capillary", "viscous", "capillary+viscous"};

/// Where a liquid acts: while the solids touch, or from first touch until its bridge ruptures.
enum class AttractionRange { contact, bridge };
inline constexpr const char* attraction_range_words[] = {"contact", "bridge"};

/// The lever of a surface force about the centre: the radius, or the distance to the contact point.
enum class TorqueArm { radius, contact };
inline constexpr const char* torque_arm_words[] = {"radius", "contact"};

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

[[nodiscard]] inline const char* to_string(TangentialModel model) { return tangential_words[static_cast<std::size_t>(model)]; }
[[nodiscard]] inline const char* to_string(RollingModel model) { return rolling_words[static_cast<std::size_t>(model)]; }
[[nodiscard]] inline const char* to_string(Attraction attraction) { return attraction_words[static_cast<std::size_t>(attraction)]; }
[[nodiscard]] inline const char* to_string(AttractionRange range) { return attraction_range_words[static_cast<std::size_t>(range)]; }
[[nodiscard]] inline const char* to_string(TorqueArm arm) { return torque_arm_words[static_cast<std::size_t>(arm)]; }

/// "mindlin on contact_radius, arm radius, rolling ar": what acts, and nothing of what does not; "nothing tangential".
[[nodiscard]] std::string to_string(const SurfaceKind& kind);

}  // namespace scalebreak

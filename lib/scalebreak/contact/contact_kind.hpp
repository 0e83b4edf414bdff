#pragma once

#include <string>
#include <vector>

namespace scalebreak {

/// The normal force law of a contact.
enum class NormalModel { linear, hertz, jkr };

/// Where a JKR contact ends: at the tear-off fold, at the force minimum, or at zero overlap.
enum class AdhesionRange { full, pull_off, touch };

/// What the normal dashpot grows with.
enum class DampingOn { overlap, contact_radius };

/// Everything that decides the *form* of a normal collision; the numbers are left to the pair.
/// It is part of every table's key and of every output's header, because it decides what sticks.
struct ContactKind {
  NormalModel normal = NormalModel::jkr;
  AdhesionRange range = AdhesionRange::full;
  DampingOn damping_on = DampingOn::contact_radius;

  bool operator==(const ContactKind&) const = default;

  [[nodiscard]] bool adhesive() const { return normal == NormalModel::jkr; }
};

[[nodiscard]] const char* to_string(NormalModel model);
[[nodiscard]] const char* to_string(AdhesionRange range);
[[nodiscard]] const char* to_string(DampingOn damping_on);

/// "jkr, full, contact_radius": for headers, keys and messages.
[[nodiscard]] std::string to_string(const ContactKind& kind);

/// The same physics under one name: only JKR has a range and a choice of dashpot. Linear and Hertz
/// contacts end at zero overlap, and a Hertz contact has a = √(R* δ), so that both dashpots are one.
[[nodiscard]] ContactKind canonical(ContactKind kind);

/// Every kind, once.
[[nodiscard]] std::vector<ContactKind> all_contact_kinds();

/// The kind that a pair of this surface energy really has: JKR without surface energy is Hertz.
[[nodiscard]] ContactKind effective_kind(const ContactKind& kind, double surface_energy);

}  // namespace scalebreak

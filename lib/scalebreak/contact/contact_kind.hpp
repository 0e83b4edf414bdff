#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <scalebreak/contact/normal_laws.hpp>

namespace scalebreak {

/// The normal force law of a contact: the place of its name among those of the registry, NormalLaws. A law that code calls by name has an
/// enumerator, others need none.
enum class NormalModel : std::uint8_t { linear, hertz, jkr };

/// Everything that decides the *form* of a normal collision; the numbers are left to the pair.
/// It is part of every table's key and of every output's header, because it decides what sticks.
struct ContactKind {
  NormalModel normal = NormalModel::jkr;
  AdhesionRange range = AdhesionRange::full;
  DampingOn damping_on = DampingOn::contact_radius;

  bool operator==(const ContactKind&) const = default;

  [[nodiscard]] const NormalTraits& traits() const;
  [[nodiscard]] bool adhesive() const { return traits().adhesive(); }
};

/// Of every form in the registry its law.
inline constexpr auto normal_models = [] {
  std::array<NormalModel, NormalLaws::count> models{};
  for (std::size_t form = 1; form < models.size(); ++form) {
    const bool same_law = NormalLaws::traits[form].name == NormalLaws::traits[form - 1].name;
    models[form] = static_cast<NormalModel>(static_cast<int>(models[form - 1]) + (same_law ? 0 : 1));
  }
  return models;
}();

/// The law of a name that is in the registry.
[[nodiscard]] constexpr NormalModel normal_model(std::string_view name) {
  std::size_t form = 0;
  while (NormalLaws::traits.at(form).name != name) ++form;
  return normal_models[form];
}
static_assert(normal_model("linear") == NormalModel::linear && normal_model("hertz") == NormalModel::hertz &&
              normal_model("jkr") == NormalModel::jkr);

/// The place in the registry of the form of this kind: of its law, the one with this dashpot, or its only one.
[[nodiscard]] constexpr std::size_t normal_form(const ContactKind& kind) {
  std::size_t first = 0;
  while (normal_models[first] != kind.normal) ++first;
  for (std::size_t form = first; form < NormalLaws::count && normal_models[form] == kind.normal; ++form) {
    if (NormalLaws::traits[form].damping_on == kind.damping_on) return form;
  }
  return first;
}

/// Of a law's first form; all but the dashpot is the same of its others.
[[nodiscard]] constexpr const NormalTraits& traits_of(NormalModel model) {
  std::size_t form = 0;
  while (normal_models[form] != model) ++form;
  return NormalLaws::traits[form];
}
inline const NormalTraits& ContactKind::traits() const { return traits_of(normal); }

/// The names of all laws, in the order of NormalModel.
[[nodiscard]] std::vector<std::string> normal_names();
/// "\"hertz\" or \"jkr\"": those of which something holds, for messages.
[[nodiscard]] std::string normal_names_where(bool (*holds)(const NormalTraits&));

[[nodiscard]] std::string to_string(NormalModel model);
[[nodiscard]] const char* to_string(AdhesionRange range);
[[nodiscard]] const char* to_string(DampingOn damping_on);

/// "jkr, full, contact_radius": for headers, keys and messages.
[[nodiscard]] std::string to_string(const ContactKind& kind);

/// The same physics under one name: only an adhesive law has a range, and only one of several forms a choice of dashpot. Linear and Hertz
/// contacts end at zero overlap, and a Hertz contact has a = √(R* δ), so that both dashpots are one.
[[nodiscard]] ContactKind canonical(ContactKind kind);

/// Every kind, once.
[[nodiscard]] std::vector<ContactKind> all_contact_kinds();

/// The kind that a pair of this surface energy really has: JKR without surface energy is Hertz.
[[nodiscard]] ContactKind effective_kind(const ContactKind& kind, double surface_energy);

}  // namespace scalebreak

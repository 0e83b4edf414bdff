#include <scalebreak/contact/contact_kind.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scalebreak {

std::vector<std::string> normal_names() {
  std::vector<std::string> names;
  for (const NormalTraits& form : NormalLaws::traits) {
    if (names.empty() || names.back() != form.name) names.emplace_back(form.name);
  }
  return names;
}

std::string normal_names_where(bool (*holds)(const NormalTraits&)) {
  std::vector<std::string> names = normal_names();
  std::erase_if(names, [&](const std::string& name) { return !holds(traits_of(normal_model(name))); });
  if (names.size() < 2) return fmt::format("\"{}\"", fmt::join(names, ""));
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("\"{}\" or \"{}\"", fmt::join(names, "\", \""), last);
}

std::string to_string(NormalModel model) { return std::string(traits_of(model).name); }

const char* to_string(AdhesionRange range) {
  switch (range) {
    case AdhesionRange::full: return "full";
    case AdhesionRange::pull_off: return "pull_off";
    case AdhesionRange::touch: return "touch";
  }
  return "?";
}

const char* to_string(DampingOn damping_on) { return damping_on == DampingOn::overlap ? "overlap" : "contact_radius"; }

std::string to_string(const ContactKind& kind) {
  return to_string(kind.normal) + ", " + to_string(kind.range) + ", " + to_string(kind.damping_on);
}

ContactKind canonical(ContactKind kind) {
  const NormalTraits& form = NormalLaws::traits[normal_form(kind)];
  return {kind.normal, std::max(kind.range, form.furthest_end), form.damping_on};
}

std::vector<ContactKind> all_contact_kinds() {
  std::vector<ContactKind> kinds;
  for (const std::string& name : normal_names()) {
    for (const auto range : {AdhesionRange::full, AdhesionRange::pull_off, AdhesionRange::touch}) {
      for (const auto damping : {DampingOn::overlap, DampingOn::contact_radius}) {
        const ContactKind kind{normal_model(name), range, damping};
        if (canonical(kind) == kind) kinds.push_back(kind);
      }
    }
  }
  return kinds;
}

ContactKind effective_kind(const ContactKind& kind, double surface_energy) {
  if (kind.adhesive() && surface_energy == 0) return canonical({.normal = normal_model(kind.traits().without_adhesion)});
  return canonical(kind);
}

}  // namespace scalebreak

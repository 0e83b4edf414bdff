#include <scalebreak/contact/contact_kind.hpp>

namespace scalebreak {

const char* to_string(NormalModel model) {
  switch (model) {
    case NormalModel::linear: return "linear";
    case NormalModel::hertz: return "hertz";
    case NormalModel::jkr: return "jkr";
  }
  return "?";
}

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
  return std::string(to_string(kind.normal)) + ", " + to_string(kind.range) + ", " + to_string(kind.damping_on);
}

ContactKind canonical(ContactKind kind) {
  if (kind.normal == NormalModel::jkr) return kind;
  return {kind.normal, AdhesionRange::touch, DampingOn::overlap};
}

std::vector<ContactKind> all_contact_kinds() {
  std::vector<ContactKind> kinds = {canonical({.normal = NormalModel::linear}), canonical({.normal = NormalModel::hertz})};
  for (const auto range : {AdhesionRange::full, AdhesionRange::pull_off, AdhesionRange::touch}) {
    for (const auto damping : {DampingOn::overlap, DampingOn::contact_radius}) kinds.push_back({NormalModel::jkr, range, damping});
  }
  return kinds;
}

ContactKind effective_kind(const ContactKind& kind, double surface_energy) {
  if (kind.adhesive() && surface_energy == 0) return canonical({.normal = NormalModel::hertz});
  return canonical(kind);
}

}  // namespace scalebreak

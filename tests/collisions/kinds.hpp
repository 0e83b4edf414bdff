#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <scalebreak/contact/contact_kind.hpp>

namespace scalebreak::tests {

/// Every kind of normal contact, once.
inline std::vector<ContactKind> every_kind() {
  std::vector<ContactKind> kinds = {canonical({.normal = NormalModel::linear}), canonical({.normal = NormalModel::hertz})};
  for (const auto range : {AdhesionRange::full, AdhesionRange::pull_off, AdhesionRange::touch}) {
    for (const auto damping : {DampingOn::contact_radius, DampingOn::overlap}) kinds.push_back({NormalModel::jkr, range, damping});
  }
  return kinds;
}

inline std::string kind_name(const ContactKind& kind) {
  std::string name = to_string(kind);
  name.erase(std::remove(name.begin(), name.end(), ','), name.end());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace scalebreak::tests

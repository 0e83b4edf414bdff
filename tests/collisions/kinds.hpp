#pragma once

#include <algorithm>
#include <string>

#include <scalebreak/contact/contact_kind.hpp>

namespace scalebreak::tests {

inline std::string kind_name(const ContactKind& kind) {
  std::string name = to_string(kind);
  name.erase(std::remove(name.begin(), name.end(), ','), name.end());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace scalebreak::tests

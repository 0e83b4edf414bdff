#pragma once

#include <string>
#include <vector>

#include <scalebreak/scene/keys.hpp>

namespace scalebreak {

/// The names of all scaling laws, in their order.
[[nodiscard]] std::vector<std::string> scaling_law_names();

/// The keys of [study].
void add_study(std::vector<Key>& list);

}  // namespace scalebreak

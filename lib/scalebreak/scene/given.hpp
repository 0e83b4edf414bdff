#pragma once

#include <string>
#include <vector>

#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// An input as it was given, each key once.
using Given = std::vector<Assignment>;

/// The assignment of a key, or nullptr.
[[nodiscard]] const Assignment* find_given(const Given& given, const std::string& key);

/// The place to blame, "scene.toml, line 4: ": that of the first of these keys that was given; empty if none was.
[[nodiscard]] std::string place(const Given& given, const std::vector<std::string>& blame);

}  // namespace scalebreak

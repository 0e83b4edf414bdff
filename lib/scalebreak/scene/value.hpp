#pragma once

#include <string>
#include <variant>
#include <vector>

namespace scalebreak {

/// What a key can hold.
using Value = std::variant<bool, double, std::string, std::vector<double>, std::vector<std::string>>;

/// Where an input was found: "scene.toml, line 4" or "--set".
struct Where {
  std::string text;
};

/// A key of the input as it was given.
struct Assignment {
  std::string key;  ///< dotted; "body.1.position" for the first [[body]]
  Value value;
  Where where;
};

/// As TOML would write it: numbers in the fewest digits that read back the same.
[[nodiscard]] std::string to_toml(const Value& value);

}  // namespace scalebreak

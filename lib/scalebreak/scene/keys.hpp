#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/scene/bounds.hpp>
#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// One key of the input: its name, what it means, what it may be, and where it lives in an Input.
struct Key {
  std::string section, name;
  std::string unit;     ///< "-" where there is none
  std::string meaning;  ///< one line
  std::string allowed;  ///< for messages and --print-defaults
  /// Puts a value in; throws std::string with what was found if it is not allowed.
  std::function<void(Input&, const Value&)> set;
  std::function<Value(const Input&)> get;

  [[nodiscard]] std::string dotted() const { return section + "." + name; }
};

/// All keys but those of [[body]], in the order in which an input is written.
[[nodiscard]] const std::vector<Key>& keys();

/// The keys of one [[body]].
[[nodiscard]] std::vector<Key> body_keys(std::size_t index);

/// Those of them that have no default.
inline constexpr std::string_view required_body_keys[] = {"position", "radius"};

}  // namespace scalebreak

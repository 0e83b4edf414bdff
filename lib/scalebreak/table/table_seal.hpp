#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace scalebreak {

/// Puts a checksum into what is said of a table: CRC-32 of its arrays, as they lie in their files, and of everything said.
void seal(nlohmann::json& said, std::vector<std::string_view> arrays);

/// What was said, without its checksum. Throws a std::string, what does not fit (format version, key, checksum), and json exceptions.
[[nodiscard]] nlohmann::json unsealed(const std::string& text, std::vector<std::string_view> arrays, int format_version,
                                      const nlohmann::json& key);

}  // namespace scalebreak

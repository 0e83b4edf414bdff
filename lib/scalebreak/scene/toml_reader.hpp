#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// The keys of a TOML text, flattened, in the order of their lines. `name` stands for the text in messages.
/// Throws InputError with the line for what is not TOML, or holds what no key can (dates, mixed arrays).
[[nodiscard]] std::vector<Assignment> read_toml(std::string_view text, const std::string& name);

/// The same of a file. Throws InputError if it cannot be read.
[[nodiscard]] std::vector<Assignment> read_toml_file(const std::filesystem::path& path);

/// One "dotted.key=value" of the command line; a value that is not TOML is a bare word.
[[nodiscard]] Assignment read_setting(const std::string& text);

}  // namespace scalebreak

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace scalebreak {

/// Writes a whole file or nothing: into a neighbour, then renamed over. Makes missing folders.
/// Throws WorkError that names the file and the system's reason.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Appends a whole text to a file, or leaves the file as it was. Makes the file and missing folders. Throws WorkError as write_file.
void append_file(const std::filesystem::path& path, std::string_view content);

/// A whole file, or nothing where it cannot be opened.
[[nodiscard]] std::optional<std::string> read_file(const std::filesystem::path& path);

}  // namespace scalebreak

#pragma once

#include <filesystem>
#include <string_view>

namespace scalebreak {

/// Writes a whole file or nothing: into a neighbour, then renamed over. Makes missing folders.
/// Throws WorkError that names the file and the system's reason.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace scalebreak

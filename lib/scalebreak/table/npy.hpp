#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scalebreak {

/// The header of NumPy's format 1.0: magic, version, length, and a Python literal of type ("'<f8'", or a list of fields) and shape.
[[nodiscard]] std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape);

/// CRC-32 of some texts, one after the other.
[[nodiscard]] std::uint32_t crc32(const std::vector<std::string_view>& texts);

}  // namespace scalebreak

#pragma once

#include <string_view>

namespace scalebreak {

/// "0.1.0 (commit 0123456789)".
[[nodiscard]] std::string_view version();

}  // namespace scalebreak

#pragma once

#include <string_view>

namespace scalebreak {

/// Does an engine of this name fly from collision to collision, and have no step of its own that samples must lie on?
[[nodiscard]] constexpr bool flies(std::string_view engine) { return engine == "event" || engine == "hybrid"; }
/// Does it step soft spheres?
[[nodiscard]] constexpr bool steps(std::string_view engine) { return engine == "dem" || engine == "hybrid"; }

}  // namespace scalebreak

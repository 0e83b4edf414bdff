#pragma once

namespace scalebreak {

/// What lies at the two faces of the cell along an axis.
enum class Boundary { open, periodic, wall };

}  // namespace scalebreak

#pragma once

#include <cstdint>
#include <vector>

#include <scalebreak/ensembles/event/patches/patch.hpp>

namespace scalebreak {

/// A patch taken apart: which of its spheres go on together, and which alone.
struct LinkedParts {
  std::vector<std::vector<std::uint32_t>> parts;  ///< of spheres that touch each other or a wall, or may within the time looked ahead
  std::vector<std::uint32_t> alone;
};

/// Linked are what something acts between, and what may touch within `horizon` from now [s]: on straight lines, or by as much as those that
/// are pushed may leave theirs. Brings the patch's pushes up to now.
[[nodiscard]] LinkedParts linked_parts(Patch& patch, double horizon);

}  // namespace scalebreak

#pragma once

#include <cstdint>
#include <vector>

#include <scalebreak/dem/group/dem_group.hpp>

namespace scalebreak {

/// A group taken apart: which of its spheres go on together, and which alone.
struct LinkedParts {
  std::vector<std::vector<std::uint32_t>> parts;  ///< of spheres that touch each other or a wall, or may within the time looked ahead
  std::vector<std::uint32_t> alone;
};

/// Linked are what something acts between, and what may touch within `horizon` from now: on straight lines, or by as much as a sphere that
/// touches another may `swerve` from its line [m].
[[nodiscard]] LinkedParts linked_parts(const DemGroup& group, double horizon, double swerve);

}  // namespace scalebreak

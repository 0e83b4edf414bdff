#pragma once

namespace scalebreak {

/// The volume that a sphere has between two planes, at signed heights from its centre, the upper not below the lower [m³].
[[nodiscard]] double sphere_between_planes(double radius, double lower, double upper);

}  // namespace scalebreak

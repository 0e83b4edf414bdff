#include <scalebreak/measure/sums/sphere_slab.hpp>

#include <algorithm>
#include <numbers>

namespace scalebreak {

double sphere_between_planes(double radius, double lower, double upper) {
  // ∫π(r² − z²)dz
  const double from = std::clamp(lower, -radius, radius), to = std::clamp(upper, -radius, radius);
  return std::numbers::pi * (to - from) * (radius * radius - (to * to + to * from + from * from) / 3);
}

}  // namespace scalebreak

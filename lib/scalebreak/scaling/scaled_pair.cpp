#include <scalebreak/scaling/scaled_pair.hpp>

#include <cmath>

namespace scalebreak {

NormalPair Bodies::pair() const {
  return against_wall() ? wall_pair(first, radius[0], wall) : sphere_pair(first, radius[0], second, radius[1]);
}

Bodies scaled_bodies(const ScalingLaw& law, double factor, Bodies bodies) {
  bodies.first = scaled_material(law, factor, bodies.first);
  bodies.second = scaled_material(law, factor, bodies.second);
  bodies.wall.material = scaled_material(law, factor, bodies.wall.material);
  for (double& radius : bodies.radius) radius *= size_factor(law, factor);
  return bodies;
}

ScaledPair scaled_pair(const ScalingLaw& law, double factor, const Bodies& original) {
  if (!law.direct_force) return {.pair = scaled_bodies(law, factor, original).pair()};
  NormalPair pair = original.pair();
  const double inertia = std::pow(factor, 3 - law.overlap - law.force);
  pair.mass *= inertia;
  pair.damping_ratio /= std::sqrt(inertia);  // the dashpot is the original's, the mass is not
  const double length = std::pow(factor, law.overlap);
  return {.pair = pair, .overlap = length, .time = length, .force = std::pow(factor, law.force)};
}

}  // namespace scalebreak

#include <scalebreak/scaling/scaled_pair.hpp>

#include <cmath>

namespace scalebreak {

NormalPair Bodies::pair() const {
  return against_wall() ? wall_pair(first, radius[0], wall) : sphere_pair(first, radius[0], second, radius[1]);
}

SurfacePair Bodies::surfaces() const {
  return against_wall() ? wall_surfaces(first, radius[0], wall) : sphere_surfaces(first, radius[0], second, radius[1]);
}

namespace {

/// Enlarging is geometry: lengths that a material gives in metres grow with the particles, as shares of the radius do by themselves.
Material enlarged(Material material, double size) {
  material.separation_min *= size;
  material.liquid_volume *= size * size * size;
  return material;
}

}  // namespace

Bodies scaled_bodies(const ScalingLaw& law, double factor, Bodies bodies, NormalModel normal) {
  const double size = size_factor(law, factor);
  for (Material* material : {&bodies.first, &bodies.second, &bodies.wall.material})
    *material = enlarged(scaled_material(law, factor, *material, normal), size);
  for (double& radius : bodies.radius) radius *= size;
  return bodies;
}

ScaledPair scaled_pair(const ScalingLaw& law, double factor, const Bodies& original, NormalModel normal) {
  if (!law.direct_force) return {.pair = scaled_bodies(law, factor, original, normal).pair()};
  NormalPair pair = original.pair();
  const double inertia = std::pow(factor, 3 - law.overlap - law.force);
  pair.mass *= inertia;
  pair.damping_ratio /= std::sqrt(inertia);  // the dashpot is the original's, the mass is not
  const double length = std::pow(factor, law.overlap);
  return {.pair = pair, .overlap = length, .time = length, .force = std::pow(factor, law.force)};
}

}  // namespace scalebreak

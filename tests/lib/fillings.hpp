#pragma once

#include <cmath>
#include <numbers>

#include <scalebreak/start/filling.hpp>

namespace scalebreak::tests {

/// A filling of a cube, of spheres with those radii in turn and density 1; material 1 from the second radius on.
inline Filling filling_of(std::size_t count, double fraction, std::vector<double> radii = {0.5}, std::uint64_t seed = 1) {
  Filling filling;
  filling.seed = seed;
  double solid = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = radii[i % radii.size()], volume = 4 * std::numbers::pi / 3 * std::pow(radius, 3);
    filling.radius.push_back(radius);
    filling.material.push_back(i % radii.size() == 0 ? 0 : 1);
    filling.mass.push_back(volume);
    solid += volume;
  }
  filling.cell.size.setConstant(std::cbrt(solid / fraction));
  return filling;
}

}  // namespace scalebreak::tests

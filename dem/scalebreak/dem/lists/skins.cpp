#include <scalebreak/dem/lists/skins.hpp>

#include <algorithm>
#include <cmath>

namespace scalebreak::dem {

Skins best_skins(double diameter, double volume_fraction, double travel) {
  constexpr double test = 8, anew = 2000;
  const double phi = std::clamp(volume_fraction, 0.05, 0.55), free = 1 - phi;
  const double layer = 12 * phi * (1 - phi / 2) / (free * free * free), speed = std::max(travel / diameter, 1e-7);
  // Cost per step: test · layer · near + (test · layer · neighbours) speed/near + anew · speed/neighbours, least for near = √(neighbours
  // speed) and neighbours^{3/2} = anew √speed / (test layer).
  const double neighbours = std::clamp(std::pow(anew * std::sqrt(speed) / (test * layer), 2.0 / 3), 0.02, 0.6);
  const double near = std::clamp(std::sqrt(neighbours * speed), neighbours / 60, neighbours);
  return {neighbours * diameter, near * diameter};
}

}  // namespace scalebreak::dem

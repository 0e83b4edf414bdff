#include <scalebreak/ensembles/prediction/granular_theory.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace scalebreak {

using std::numbers::pi;

double effective_restitution(double restitution, double friction) {
  return std::max(0.0, restitution - 1.5 * friction * std::exp(-3 * friction));
}

double jamming_fraction(double friction) {
  constexpr double at[] = {0, 0.1, 0.3, 0.5, 1}, fraction[] = {0.636, 0.613, 0.596, 0.587, 0.581};
  for (std::size_t i = 1; i < std::size(at); ++i) {
    if (friction < at[i]) return std::lerp(fraction[i - 1], fraction[i], (friction - at[i - 1]) / (at[i] - at[i - 1]));
  }
  return fraction[std::size(at) - 1];
}

namespace {

double near_jamming(double volume_fraction, double jamming) {
  return 0.58 * volume_fraction * volume_fraction / std::pow(jamming - volume_fraction, 1.5);
}

}  // namespace

double fluid_contact_value(double volume_fraction) { return (1 - volume_fraction / 2) / std::pow(1 - volume_fraction, 3); }

double contact_value(double volume_fraction, double jamming) {
  return fluid_contact_value(volume_fraction) + near_jamming(volume_fraction, jamming);
}

double jamming_share(double volume_fraction, double jamming) {
  return near_jamming(volume_fraction, jamming) / contact_value(volume_fraction, jamming);
}

double shear_temperature_number(double volume_fraction, double contact_value, double e) {
  const double g = volume_fraction * contact_value;
  const double streaming = (5 + 2 * (1 + e) * (3 * e - 1) * g) * (5 + 4 * (1 + e) * g);
  const double j = (1 + e) / 2 + pi / 32 * streaming / ((24 - 6 * (1 - e) * (1 - e) - 5 * (1 - e * e)) * g * g);
  return 2 * j / (15 * (1 - e * e));
}

double collisions_of_sphere(double volume_fraction, double contact_value, double temperature, double diameter) {
  return 24 * volume_fraction * contact_value * std::sqrt(temperature / pi) / diameter;
}

double collisional_pressure(double density, double volume_fraction, double contact_value, double effective_restitution,
                            double temperature) {
  return density * volume_fraction * (1 + 2 * (1 + effective_restitution) * volume_fraction * contact_value) * temperature;
}

double mean_impact_speed(double temperature) { return std::sqrt(pi * temperature); }

}  // namespace scalebreak

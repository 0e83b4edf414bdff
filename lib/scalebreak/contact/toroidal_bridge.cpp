#include <scalebreak/contact/toroidal_bridge.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/tools/roots.hpp>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

struct Arc {
  double meridional, neck;
};

/// Hu 2024, eqs 2.39 and 2.40.
Arc arc(double psi, double h, double theta) {
  const double c = std::cos(psi + theta);
  return {(1 + h - std::cos(psi)) / c, ((1 + h) * (std::sin(psi + theta) - 1) + std::cos(psi) - std::sin(theta)) / c};
}

/// Hu 2024, eq. 2.41.
double volume_of(double psi, double h, double theta) {
  const auto [r1, r2] = arc(psi, h, theta);
  const double c = std::cos(psi + theta), s = std::sin(psi + theta), sum = r1 + r2;
  return 1.5 * ((sum * sum + r1 * r1) * r1 * c - sum * r1 * r1 * s * c - r1 * r1 * sum * (std::numbers::pi / 2 - psi - theta) -
                (1 + h) * r1 * r1 * c * c + h * (h + 2) * r1 * c - h * h * (h + 3) / 3);
}

}  // namespace

ToroidalBridge toroidal_bridge(double volume, double half_separation, double contact_angle) {
  const auto missing = [&](double psi) { return volume_of(psi, half_separation, contact_angle) - volume; };
  // The volume grows with ψ; the neck stays open only from some angle on, below which the formula has no bridge.
  const double high = std::numbers::pi / 2 - contact_angle - 1e-9;
  double low = 1e-6;
  while (low < high && !(arc(low, half_separation, contact_angle).neck > 0)) low += 1e-3;
  if (!(low < high) || missing(low) > 0 || missing(high) < 0) {
    throw WorkError(
        fmt::format("no toroidal bridge of {:g} sphere volumes spans a half separation of {:g} radii at a contact angle of {:g}", volume,
                    half_separation, contact_angle));
  }
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(missing, low, high, boost::math::tools::eps_tolerance<double>(50), iterations);
  const double psi = (a + b) / 2;
  const auto [r1, r2] = arc(psi, half_separation, contact_angle);
  return {psi, r1, r2, r2 * (r1 + r2) / (2 * r1)};
}

}  // namespace scalebreak

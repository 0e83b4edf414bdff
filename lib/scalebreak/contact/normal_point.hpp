#pragma once

#include <cmath>

#include <scalebreak/contact/contact_point.hpp>
#include <scalebreak/contact/normal_law.hpp>

namespace scalebreak {

/// A normal contact at one instant: what the laws of the surfaces need of it, and what drives the overlap.
struct NormalPoint {
  double coordinate_slope = 1;  ///< dδ/dx in the law's regular coordinate x
  double slope = 1;             ///< dδ/dz in the carried variable z: δ^{1/4} of a rooted contact, else x
  double elastic = 0, damping = 0;
  double elastic_slope = 0, damping_slope = 0;  ///< in x
  double total = 0;                             ///< spring and dashpot, repulsion positive
  ContactPoint point;                           ///< its load carries the sign of the force for laws whose F_N is a magnitude
};

/// At x, and at `root` = δ^{1/4} if the contact is `rooted` (a law is smooth in that alone). `radius` is R*, `approach` dδ/dt.
template <class Law>
[[nodiscard, gnu::always_inline]] inline NormalPoint normal_point(const Law& law, bool rooted, double x, double root, double approach,
                                                                  double radius) {
  NormalPoint n;
  n.coordinate_slope = law.overlap_slope(x);
  n.slope = rooted ? 4 * root * root * root : n.coordinate_slope;
  n.elastic = law.force(x);
  n.elastic_slope = law.force_slope(x);
  if constexpr (RootDamped<Law>) {
    n.damping = rooted ? law.damping_of_root(root) : 0.0;  // zero for δ ≤ 0; its load does not hold it
  } else {
    n.damping = law.damping(x);
    n.damping_slope = law.damping_slope(x);
  }
  n.total = n.elastic + n.damping * approach;
  n.point.overlap = rooted ? root * root * root * root : law.overlap(x);
  n.point.root = law.root_radius(x);
  n.point.overlap_root = Law::traits.coordinate == Coordinate::overlap_root ? x : rooted ? std::sqrt(std::sqrt(radius)) * root : 0.0;
  n.point.load = law.load(x, n.total);
  return n;
}

/// The point's rates of change, from those of x, of `root` and of the approach.
template <class Law>
[[nodiscard]] ContactPoint point_rate(const Law& law, const NormalPoint& n, bool rooted, double x, double x_rate, double root_rate,
                                      double approach, double approach_rate, double radius) {
  ContactPoint rate;
  rate.overlap = n.coordinate_slope * x_rate;
  rate.root = law.root_radius(x_rate);
  rate.overlap_root = Law::traits.coordinate == Coordinate::overlap_root ? x_rate : rooted ? std::sqrt(std::sqrt(radius)) * root_rate : 0.0;
  const double total_rate = (n.elastic_slope + n.damping_slope * approach) * x_rate + n.damping * approach_rate;
  rate.load = law.load_rate(x, x_rate, total_rate);
  return rate;
}

}  // namespace scalebreak

#include <algorithm>

#include <Eigen/Geometry>

#include <scalebreak/table/pair_lookup.hpp>

namespace scalebreak {

using Eigen::Vector3d;

// With c = r₁/I₁ − r₂/I₂, the friction's impulse J on the first body and the rolling's angular impulse K against ω₁ − ω₂:
//
//     Δv_s = (1/m* + r₁²/I₁ + r₂²/I₂) J − c K × n,     Δ(ω₁ − ω₂) = c n × J − (1/I₁ + 1/I₂) K
//
// (docs/tables.md). Tables give J of a sliding that nothing else changes, and K of a rolling. Each is asked at what it would begin
// with if the other's change came at one instant: a share of it before, the rest after.

namespace {

/// Friction that slides asks for a direction alone, which has all of the change from the first; so is a torque without a spring. A rolling
/// spring feels of a change that comes while it builds up half.
double share_before(RollingModel model) { return model == RollingModel::cdt ? 1.0 : 0.5; }

/// Of the difference that it makes whether all of the other's change comes before or after: what is left out; measured, see docs/tables.md.
constexpr double left_out = 0.4;

}  // namespace

std::optional<PairLookup::Exchange> PairLookup::exchange(const Vector3d& normal, double normal_speed, double reduced_speed,
                                                         const Vector3d& sliding, const Vector3d& rolling) const {
  // Both tables reach as far in speed, and to every ratio.
  if (!oblique_->find(reduced_speed, 0) || !rolling_.find(reduced_speed, 0)) return std::nullopt;
  const double inertia = oblique_->key().inertia, ease = 1 / pair_.inertia[0] + 1 / pair_.inertia[1];
  const auto impulse = [&](const Vector3d& v) -> Vector3d {
    return -mass_ * (1 - oblique_->find(reduced_speed, v.norm() / normal_speed)->surface_restitution) / (1 + inertia) * v;
  };
  const auto angular_impulse = [&](const Vector3d& w) -> Vector3d {
    return (1 - *rolling_.find(reduced_speed, pair_.normal.radius * w.norm() / normal_speed)) / ease * w;
  };
  const auto to_sliding = [&](const Vector3d& k) -> Vector3d { return -coupling_ * k.cross(normal); };
  const auto to_rolling = [&](const Vector3d& j) -> Vector3d { return coupling_ * normal.cross(j); };
  const double before = share_before(pair_.surface.rolling);

  const Vector3d alone = angular_impulse(rolling);
  Vector3d turn = alone;
  Exchange change;
  for (int pass = 0; pass < 2; ++pass) {
    change.sliding = to_sliding(turn);
    change.rolling = before * to_rolling(impulse(sliding + change.sliding));
    turn = angular_impulse(rolling + change.rolling);
  }
  const Vector3d to_slide = to_sliding(turn), to_roll = change.rolling / before;
  const double sliding_error = (impulse(sliding + to_slide) - impulse(sliding)).norm() * (1 + inertia) / mass_;
  const double arm = std::max(pair_.radius[0] / pair_.inertia[0], pair_.radius[1] / pair_.inertia[1]);
  const double rolling_error = (angular_impulse(rolling + to_roll) - alone).norm() * arm;
  change.error = left_out * (sliding_error + rolling_error) / normal_speed;
  return change;
}

}  // namespace scalebreak

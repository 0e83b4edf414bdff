#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <scalebreak/collisions/bodies/few_body_system.hpp>

// Rolling under a law without a spring, which holds bodies rigidly up to its limit.

namespace scalebreak {
namespace {

using Eigen::Vector3d;

/// Of a rolling that begins or ends the direction turns ever faster, to no effect: below this share of the rolling speed of the scene
/// it is let be. What is left across it when the rolling stops is held at once, as the torque would have: its energy is the square
/// of this.
constexpr double rolling_floor = 1e-7;

Vector3d in_plane(const Vector3d& v, const Vector3d& normal) { return v - normal * normal.dot(v); }

}  // namespace

/// Rolling that a rigid law holds: the torques under which every such pair keeps its rolling speed of zero.
void FewBodySystem::hold_rigid_rolling(const State& y) {
  std::vector<std::size_t> held;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Rolling& rolling = laws_[links_[c].pair].laws.rolling;
    if (links_[c].touching && rolling.acts() && rolling.rigid() && links_[c].roll == Grip::holds) held.push_back(c);
  }
  if (held.empty()) return;
  const auto size = static_cast<Eigen::Index>(3 * held.size());
  // Unknown is each torque times what it does to its own pair, so that numbers of one size stand in the matrix.
  Eigen::MatrixXd effect = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd missing(size);
  const auto cross = [](const Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return m;
  };
  /// What a torque of `other` does to the relative spin of `link`.
  const auto share = [&](const Link& link, const Link& other) {
    const auto sign = [&](int body) { return body == other.first ? 1.0 : body == other.second ? -1.0 : 0.0; };
    return laws_[other.pair].torque * (sign(link.first) / bodies_[static_cast<std::size_t>(link.first)].inertia -
                                       sign(link.second) / bodies_[static_cast<std::size_t>(link.second)].inertia);
  };
  for (std::size_t a = 0; a < held.size(); ++a) {
    const Link& link = links_[held[a]];
    const Vector3d& n = evaluated_[held[a]].at.normal;
    const auto i = static_cast<std::size_t>(link.first), j = static_cast<std::size_t>(link.second);
    const Vector3d spin = at(y, body_at(i) + 6) - at(y, body_at(j) + 6);
    const auto row = static_cast<Eigen::Index>(3 * a);
    missing.segment<3>(row) = in_plane((spin_rate_[i] - spin_rate_[j]).cross(n) + spin.cross(evaluated_[held[a]].normal_rate), n);
    effect.block<3, 3>(row, row) += n * n.transpose();
    for (std::size_t b = 0; b < held.size(); ++b) {
      const Link& other = links_[held[b]];
      // A torque T on `other` turns its first body by −n_b × T/I, and so changes u = ω × n by n × (n_b × T)/I.
      const Eigen::Matrix3d turn = cross(n) * cross(evaluated_[held[b]].at.normal);
      effect.block<3, 3>(row, static_cast<Eigen::Index>(3 * b)) -=
          share(link, other) / share(other, other) * (turn - n * (n.transpose() * turn));
    }
  }
  // Around a closed loop of contacts the torques are statically indeterminate: of all that hold it the smallest act.
  constexpr std::size_t smallest_loop = 3;
  const Eigen::VectorXd torque = held.size() < smallest_loop ? Eigen::VectorXd(effect.partialPivLu().solve(missing))
                                                             : Eigen::VectorXd(effect.completeOrthogonalDecomposition().solve(missing));
  for (std::size_t a = 0; a < held.size(); ++a) {
    const Link& link = links_[held[a]];
    Evaluated& e = evaluated_[held[a]];
    e.torque = in_plane(torque.segment<3>(static_cast<Eigen::Index>(3 * a)), e.at.normal) / share(link, link);
    const double map = laws_[link.pair].torque;
    const Vector3d turn = e.at.normal.cross(e.torque);
    const auto i = static_cast<std::size_t>(link.first), j = static_cast<std::size_t>(link.second);
    spin_rate_[i] -= map / bodies_[i].inertia * turn;
    spin_rate_[j] += map / bodies_[j].inertia * turn;
  }
}

/// How the direction of a rolling under a rigid law turns, per unit of the integrator's time. A deviation ε from the rolling's own
/// direction would grow, u ε' = c ε with the torque's deceleration c, as the rolling u stops: it is drawn back twice as fast.
Eigen::Vector3d FewBodySystem::rigid_turning(const Link& link, const Evaluated& e) const {
  const MappedLaws& mapped = laws_[link.pair];
  const Vector3d along = e.roll.direction();
  const double speed = along.dot(e.roll_speed), floor = rolling_floor * scales_[link.pair].roll;
  const double inverse_inertia =
      1 / bodies_[static_cast<std::size_t>(link.first)].inertia + 1 / bodies_[static_cast<std::size_t>(link.second)].inertia;
  const double deceleration = time_rate_ * mapped.spin * mapped.torque * e.roll_law.limit * inverse_inertia;
  const auto across = [&](const Vector3d& v) { return Vector3d(v - along * along.dot(v)); };
  return (across(e.roll_acceleration) * speed + 2 * deceleration * across(e.roll_speed)) / (speed * speed + floor * floor);
}

}  // namespace scalebreak

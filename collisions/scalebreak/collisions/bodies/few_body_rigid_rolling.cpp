#include <algorithm>
#include <cmath>
#include <limits>

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

/// Of all torques that hold (`torque` and what `free` spans on top of it) the ones whose largest share of its limit is least, or the first
/// that are found within all limits: Lawson's weighted least squares. A block of three is one contact's torque over its limit.
Eigen::VectorXd share_out(const Eigen::VectorXd& torque, const Eigen::MatrixXd& free) {
  constexpr int most_rounds = 1000;
  const Eigen::Index contacts = torque.size() / 3;
  Eigen::VectorXd weight = Eigen::VectorXd::Constant(contacts, 1.0 / static_cast<double>(contacts)), best = torque;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    Eigen::MatrixXd weighted = free;
    Eigen::VectorXd right = -torque;
    for (Eigen::Index c = 0; c < contacts; ++c) {
      const double root = std::sqrt(weight[c]);
      weighted.middleRows<3>(3 * c) *= root;
      right.segment<3>(3 * c) *= root;
    }
    const Eigen::VectorXd tried = torque + free * weighted.colPivHouseholderQr().solve(right);
    double largest = 0, bound = 0;
    for (Eigen::Index c = 0; c < contacts; ++c) {
      const double share = tried.segment<3>(3 * c).norm();
      largest = std::max(largest, share);
      bound += weight[c] * share * share;
      weight[c] *= share;
    }
    if (largest < least) least = largest, best = tried;
    // No torques have a smallest largest share below the bound.
    if (largest < 1 || largest * largest <= bound * (1 + 1e-12) || !(weight.sum() > 0)) break;
    weight /= weight.sum();
  }
  return best;
}

}  // namespace

/// Around a closed loop of contacts the torques are statically indeterminate. Which of all that hold it act is the same to the motion; but as
/// long as any of them are within their limits, nothing rolls.
Eigen::VectorXd FewBodySystem::around_loops(const std::vector<std::size_t>& held, const Eigen::MatrixXd& effect,
                                            const Eigen::VectorXd& missing) const {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-10);
  decomposition.compute(effect);
  Eigen::VectorXd torque = decomposition.solve(missing);
  if (decomposition.rank() == effect.cols()) return torque;
  const auto limit = [&](std::size_t a) {
    const Link& link = links_[held[a]];
    const double least = direction_floor * laws_[link.pair].laws.rolling.limit * scales_[link.pair].force;
    return torque_share(link, link) * std::max(evaluated_[held[a]].roll_law.limit, least);
  };
  Eigen::VectorXd limits(static_cast<Eigen::Index>(held.size()));
  bool within = true;
  for (std::size_t a = 0; a < held.size(); ++a) {
    const auto row = static_cast<Eigen::Index>(a);
    limits[row] = limit(a);
    within = within && torque.segment<3>(3 * row).norm() <= limits[row];
  }
  if (within) return torque;
  const Eigen::Index rank = decomposition.rank(), free = effect.cols() - rank;
  Eigen::MatrixXd null = decomposition.colsPermutation() * decomposition.matrixZ().transpose().rightCols(free);
  for (Eigen::Index a = 0; a < limits.size(); ++a) {
    torque.segment<3>(3 * a) /= limits[a];
    null.middleRows<3>(3 * a) /= limits[a];
  }
  torque = share_out(torque, null);
  for (Eigen::Index a = 0; a < limits.size(); ++a) torque.segment<3>(3 * a) *= limits[a];
  return torque;
}

std::vector<std::size_t> FewBodySystem::rigidly_held() const {
  std::vector<std::size_t> held;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Rolling& rolling = laws_[links_[c].pair].laws.rolling;
    if (links_[c].touching && rolling.acts() && rolling.rigid() && links_[c].roll == Grip::holds) held.push_back(c);
  }
  return held;
}

/// What a torque of `other` does to the relative spin of `link`.
double FewBodySystem::torque_share(const Link& link, const Link& other) const {
  const auto sign = [&](int body) { return body == other.first ? 1.0 : body == other.second ? -1.0 : 0.0; };
  return laws_[other.pair].torque * (sign(link.first) / bodies_[static_cast<std::size_t>(link.first)].inertia -
                                     sign(link.second) / bodies_[static_cast<std::size_t>(link.second)].inertia);
}

/// The torques (a block of three each) that take `missing` from the rolling of the contacts `held`.
Eigen::VectorXd FewBodySystem::holding_torques(const std::vector<std::size_t>& held, const Eigen::VectorXd& missing) const {
  const auto size = static_cast<Eigen::Index>(3 * held.size());
  // Unknown is each torque times what it does to its own pair, so that numbers of one size stand in the matrix.
  Eigen::MatrixXd effect = Eigen::MatrixXd::Zero(size, size);
  const auto cross = [](const Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return m;
  };
  for (std::size_t a = 0; a < held.size(); ++a) {
    const Vector3d& n = evaluated_[held[a]].at.normal;
    const auto row = static_cast<Eigen::Index>(3 * a);
    effect.block<3, 3>(row, row) += n * n.transpose();
    for (std::size_t b = 0; b < held.size(); ++b) {
      const Link& other = links_[held[b]];
      // A torque T on `other` turns its first body by −n_b × T/I, and so changes u = ω × n by n × (n_b × T)/I.
      const Eigen::Matrix3d turn = cross(n) * cross(evaluated_[held[b]].at.normal);
      effect.block<3, 3>(row, static_cast<Eigen::Index>(3 * b)) -=
          torque_share(links_[held[a]], other) / torque_share(other, other) * (turn - n * (n.transpose() * turn));
    }
  }
  constexpr std::size_t smallest_loop = 3;
  Eigen::VectorXd torque =
      held.size() < smallest_loop ? Eigen::VectorXd(effect.partialPivLu().solve(missing)) : around_loops(held, effect, missing);
  for (std::size_t a = 0; a < held.size(); ++a) {
    const auto row = static_cast<Eigen::Index>(3 * a);
    torque.segment<3>(row) =
        in_plane(torque.segment<3>(row), evaluated_[held[a]].at.normal) / torque_share(links_[held[a]], links_[held[a]]);
  }
  return torque;
}

/// Rolling that a rigid law holds: the torques under which every such pair keeps its rolling speed of zero.
void FewBodySystem::hold_rigid_rolling(const State& y) {
  const std::vector<std::size_t> held = rigidly_held();
  if (held.empty()) return;
  Eigen::VectorXd missing(static_cast<Eigen::Index>(3 * held.size()));
  for (std::size_t a = 0; a < held.size(); ++a) {
    const Evaluated& e = evaluated_[held[a]];
    const auto i = static_cast<std::size_t>(links_[held[a]].first), j = static_cast<std::size_t>(links_[held[a]].second);
    const Vector3d spin = at(y, body_at(i) + 6) - at(y, body_at(j) + 6);
    missing.segment<3>(static_cast<Eigen::Index>(3 * a)) =
        in_plane((spin_rate_[i] - spin_rate_[j]).cross(e.at.normal) + spin.cross(e.normal_rate), e.at.normal);
  }
  const Eigen::VectorXd torque = holding_torques(held, missing);
  for (std::size_t a = 0; a < held.size(); ++a) {
    const Link& link = links_[held[a]];
    Evaluated& e = evaluated_[held[a]];
    e.torque = torque.segment<3>(static_cast<Eigen::Index>(3 * a));
    const Vector3d turn = laws_[link.pair].torque * e.at.normal.cross(e.torque);
    const auto i = static_cast<std::size_t>(link.first), j = static_cast<std::size_t>(link.second);
    spin_rate_[i] -= turn / bodies_[i].inertia;
    spin_rate_[j] += turn / bodies_[j].inertia;
  }
}

/// What little rolling is left in the contacts that are held is held at once, as the torques would have: without it the angular momentum is
/// the same.
void FewBodySystem::stop_rigid_rolling(State& y) const {
  const std::vector<std::size_t> held = rigidly_held();
  Eigen::VectorXd left(static_cast<Eigen::Index>(3 * held.size()));
  for (std::size_t a = 0; a < held.size(); ++a)
    left.segment<3>(static_cast<Eigen::Index>(3 * a)) = evaluated_[held[a]].roll_speed / laws_[links_[held[a]].pair].spin;
  const Eigen::VectorXd impulse = holding_torques(held, left);
  for (std::size_t a = 0; a < held.size(); ++a) {
    const Link& link = links_[held[a]];
    const Vector3d turn =
        laws_[link.pair].torque * evaluated_[held[a]].at.normal.cross(Vector3d(impulse.segment<3>(static_cast<Eigen::Index>(3 * a))));
    const auto i = static_cast<std::size_t>(link.first), j = static_cast<std::size_t>(link.second);
    put(y, body_at(i) + 6, at(y, body_at(i) + 6) - turn / bodies_[i].inertia);
    put(y, body_at(j) + 6, at(y, body_at(j) + 6) + turn / bodies_[j].inertia);
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

#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/few_body_system.hpp>

// What acts between the bodies at one state.

namespace scalebreak {
namespace {

using Eigen::Vector3d;

Vector3d in_plane(const Vector3d& v, const Vector3d& normal) { return v - normal * normal.dot(v); }

}  // namespace

FewBodySystem::Geometry FewBodySystem::geometry(const State& y, std::size_t i, std::size_t j) const {
  const Vector3d velocity = at(y, body_at(i) + 3) - at(y, body_at(j) + 3);
  const Vector3d between = at(y, body_at(j)) - at(y, body_at(i));
  if (bodies_[j].plane) return {-Vector3d::UnitZ(), velocity, -between[2], -between[2] - bodies_[i].radius};
  const double distance = between.norm();
  return {between / distance, velocity, distance, distance - bodies_[i].radius - bodies_[j].radius};
}

void FewBodySystem::evaluate_geometry(const State& y, const Link& link, std::size_t, Evaluated& e) const {
  const auto i = static_cast<std::size_t>(link.first), j = static_cast<std::size_t>(link.second);
  const MappedLaws& mapped = laws_[link.pair];
  e.at = geometry(y, i, j);
  const Vector3d& n = e.at.normal;
  const bool plane = bodies_[j].plane;
  e.approach = e.at.velocity.dot(n);
  e.centres = in_plane(e.at.velocity, n);
  e.normal_rate = plane ? Vector3d::Zero() : Vector3d(-e.centres / e.at.distance);
  e.turning = {mapped.spin * at(y, body_at(i) + 6).cross(n), mapped.spin * at(y, body_at(j) + 6).cross(n)};
  e.arm = mapped.radius;
  e.arm_rate = 0;
  if (mapped.laws.arm == TorqueArm::contact) {
    const double share = plane ? 1.0 : 0.5, depth = -e.at.gap * mapped.length;
    e.arm = {mapped.radius[0] - share * depth, mapped.radius[1] - share * depth};
    e.arm_rate = -share * e.approach * mapped.length;
  }
  if (plane) e.arm[1] = 0;
}

void FewBodySystem::evaluate_normal(const State& y, const Link& link, std::size_t base, Evaluated& e) const {
  const ContactLaws& laws = laws_[link.pair].laws;
  const PairScales& scales = scales_[link.pair];
  e.coordinate = y[base + coordinate];
  e.root = y[base + root];
  e.normal = std::visit([&](const auto& law) { return normal_point(law, link.rooted, e.coordinate, e.root, e.approach, laws.radius); },
                        laws.normal);
  e.point = e.normal.point;
  e.point.load *= link.load_sign;
  const double reference = link.rooted ? scales.root_slope : scales.slope;
  e.shrink = 1 / std::sqrt(e.normal.slope * e.normal.slope + reference * reference);
}

void FewBodySystem::evaluate_forces(const State& y, const Link& link, std::size_t base, Evaluated& e) const {
  const MappedLaws& mapped = laws_[link.pair];
  const ContactLaws& laws = mapped.laws;
  e.normal_force = 0;
  e.friction = e.torque = e.wet = Vector3d::Zero();
  if (link.touching) {
    e.normal_force = e.normal.total;
    if (laws.tangential.acts()) {
      e.slide = {at(y, base + slide), link.slide};
      e.slide_speed = e.centres + e.arm[0] * e.turning[0] + e.arm[1] * e.turning[1];
      e.slide_law = laws.tangential.at(e.point, {});
      e.friction = e.slide.force(e.slide_law, e.slide_speed);
    }
    if (laws.rolling.acts()) {
      e.roll = {at(y, base + roll), link.roll};
      e.roll_speed = e.turning[0] - e.turning[1];
      e.roll_law = laws.rolling.at(e.point, {});
      // What holds a rigid law at rest is found with all the others.
      if (!laws.rolling.rigid() || link.roll == Grip::slides) e.torque = e.roll.force(e.roll_law, e.roll_speed);
    }
  }
  if (!laws.liquid.acts() || !(link.touching || link.bridged)) return;
  e.separation = link.touching ? -e.point.overlap : e.at.gap * mapped.length;
  const double s = link.near ? laws.liquid.separation_min : e.separation;
  e.capillary = laws.liquid.capillary_force(s);
  e.drag = laws.liquid.normal_drag(s);
  e.normal_force += e.drag * e.approach - e.capillary;
  if (laws.liquid.viscous) {
    e.wet = laws.liquid.tangential_drag(s) * e.centres +
            laws.liquid.rolling_drag(s, link.second_branch) * (mapped.radius[0] * e.turning[0] + mapped.radius[1] * e.turning[1]);
  }
}

void FewBodySystem::add_forces(const Link& link, const Evaluated& e) {
  const MappedLaws& mapped = laws_[link.pair];
  const auto i = static_cast<std::size_t>(link.first), j = static_cast<std::size_t>(link.second);
  const Vector3d along = e.friction + e.wet, force = mapped.force * (e.normal_force * e.at.normal + along);
  acceleration_[i] -= force / bodies_[i].mass;
  acceleration_[j] += force / bodies_[j].mass;
  if (!mapped.laws.spins()) return;
  spin_rate_[i] -= mapped.torque / bodies_[i].inertia * e.at.normal.cross(e.arm[0] * along + e.torque);
  spin_rate_[j] -= mapped.torque / bodies_[j].inertia * e.at.normal.cross(e.arm[1] * along - e.torque);
}

/// The rates of the contact's own variables, once the bodies' accelerations are known.
void FewBodySystem::finish_rates(const State& y, const Link& link, std::size_t, Evaluated& e) const {
  const MappedLaws& mapped = laws_[link.pair];
  const ContactLaws& laws = mapped.laws;
  if (!link.touching || !laws.spins()) return;
  const auto i = static_cast<std::size_t>(link.first), j = static_cast<std::size_t>(link.second);
  const Vector3d& n = e.at.normal;
  const Vector3d relative = acceleration_[i] - acceleration_[j];
  const double carried_rate = time_unit_ * e.others * e.shrink * e.approach * mapped.length;
  const double coordinate_rate = link.rooted ? time_rate_ * e.approach * mapped.length / e.normal.coordinate_slope : carried_rate;
  const double approach_rate = time_rate_ * (relative.dot(n) + e.at.velocity.dot(e.normal_rate));
  e.rate = std::visit(
      [&](const auto& law) {
        return point_rate(law, e.normal, link.rooted, e.coordinate, coordinate_rate, carried_rate, e.approach, approach_rate, laws.radius);
      },
      laws.normal);
  e.rate.load *= link.load_sign;
  std::array<Vector3d, 2> turning_rate;
  const std::array<std::size_t, 2> body = {i, j};
  for (std::size_t k = 0; k < 2; ++k) {
    turning_rate[k] =
        time_rate_ * mapped.spin * in_plane(spin_rate_[body[k]].cross(n) + at(y, body_at(body[k]) + 6).cross(e.normal_rate), n);
  }
  if (laws.tangential.acts()) {
    e.slide_law = laws.tangential.at(e.point, e.rate);
    e.slide_law.limit_floor = direction_floor * laws.tangential.friction * scales_[link.pair].force;
    e.slide_acceleration = time_rate_ * (in_plane(relative, n) - e.approach * e.normal_rate + e.arm_rate * (e.turning[0] + e.turning[1])) +
                           e.arm[0] * turning_rate[0] + e.arm[1] * turning_rate[1];
  }
  if (laws.rolling.acts()) {
    e.roll_law = laws.rolling.at(e.point, e.rate);
    e.roll_law.limit_floor = direction_floor * laws.rolling.limit * scales_[link.pair].force;
    e.roll_acceleration = turning_rate[0] - turning_rate[1];
  }
}

void FewBodySystem::evaluate(const State& y) {
  if (y == evaluated_state_ && links_ == evaluated_links_) return;
  for (std::size_t b = 0; b < bodies_.size(); ++b) acceleration_[b] = spin_rate_[b] = Vector3d::Zero();
  force_evaluations_ += static_cast<long>(links_.size());
  double product = 1;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    Evaluated& e = evaluated_[c];
    evaluate_geometry(y, links_[c], link_at(c), e);
    e.others = product;
    if (!links_[c].touching) continue;
    evaluate_normal(y, links_[c], link_at(c), e);
    product *= e.normal.slope * e.shrink;
  }
  time_rate_ = time_unit_ * product;
  double after = 1;
  for (std::size_t c = links_.size(); c-- > 0;) {
    Evaluated& e = evaluated_[c];
    e.others *= after;
    if (links_[c].touching) after *= e.normal.slope * e.shrink;
    evaluate_forces(y, links_[c], link_at(c), e);
    add_forces(links_[c], e);
  }
  hold_rigid_rolling(y);
  for (std::size_t c = 0; c < links_.size(); ++c) finish_rates(y, links_[c], link_at(c), evaluated_[c]);
  evaluated_state_ = y;
  evaluated_links_ = links_;
}

}  // namespace scalebreak

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <scalebreak/collisions/few_body_system.hpp>

// What acts between the bodies at one state, and the rates that follow from it.

namespace scalebreak {
namespace {

using Eigen::Vector3d;

/// Where the limit of a slider falls to zero its direction turns ever faster, to no effect: below this share of the limit's
/// size in the scene it is let be, which costs an impulse of the square of this.
constexpr double direction_floor = 1e-6;

/// The same of the direction of a rolling that begins or ends, as a share of the rolling speed of the scene.
constexpr double rolling_floor = 1e-9;

Vector3d at(const FewBodySystem::State& y, std::size_t i) { return {y[i], y[i + 1], y[i + 2]}; }

void put(FewBodySystem::State& y, std::size_t i, const Vector3d& v) {
  y[i] = v[0];
  y[i + 1] = v[1];
  y[i + 2] = v[2];
}

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

/// Rolling that a rigid law holds: the torques under which every such pair keeps its rolling speed of zero.
void FewBodySystem::hold_rigid_rolling(const State& y) {
  std::vector<std::size_t> held;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    if (links_[c].touching && laws_[links_[c].pair].laws.rolling.rigid() && links_[c].roll == Grip::holds) held.push_back(c);
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
  for (std::size_t b = 0; b < bodies_.size(); ++b) acceleration_[b] = spin_rate_[b] = Vector3d::Zero();
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

void FewBodySystem::operator()(const State& y, State& rate, double) {
  evaluate(y);
  std::fill(rate.begin(), rate.end(), 0.0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    put(rate, body_at(b), time_rate_ * at(y, body_at(b) + 3));
    put(rate, body_at(b) + 3, time_rate_ * acceleration_[b]);
    put(rate, body_at(b) + 6, time_rate_ * spin_rate_[b]);
  }
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Link& link = links_[c];
    const Evaluated& e = evaluated_[c];
    const MappedLaws& mapped = laws_[link.pair];
    const std::size_t base = link_at(c);
    const double original_time = time_rate_ * mapped.length;
    if (link.touching) {
      const double carried = time_unit_ * e.others * e.shrink * e.approach * mapped.length;
      rate[base + root] = link.rooted ? carried : 0.0;
      rate[base + coordinate] = link.rooted ? original_time * e.approach / e.normal.coordinate_slope : carried;
      rate[base + damping_work] = time_rate_ * mapped.force * e.normal.damping * e.approach * e.approach;
      // A history turns with the contact plane.
      const auto turned = [&](const Vector3d& own, const Vector3d& history) {
        return Vector3d(own - e.at.normal * (time_rate_ * history.dot(e.normal_rate)));
      };
      const auto power = [&](const Vector3d& force) {
        return mapped.force * force.dot(e.centres) +
               mapped.torque / mapped.spin * (e.arm[0] * force.dot(e.turning[0]) + e.arm[1] * force.dot(e.turning[1]));
      };
      if (mapped.laws.tangential.acts()) {
        put(rate, base + slide, turned(e.slide.rate(e.slide_law, e.slide_speed, e.slide_acceleration, original_time), e.slide.history));
        rate[base + tangential_work] = time_rate_ * power(e.friction);
      }
      if (mapped.laws.rolling.acts()) {
        Vector3d own = Vector3d::Zero();
        if (!mapped.laws.rolling.rigid()) {
          own = e.roll.rate(e.roll_law, e.roll_speed, e.roll_acceleration, original_time);
        } else if (link.roll == Grip::slides) {  // its history is the direction of the rolling itself
          own = rigid_turning(link, e);
        }
        put(rate, base + roll, turned(own, e.roll.history));
        rate[base + rolling_work] = time_rate_ * mapped.torque / mapped.spin * e.torque.dot(e.roll_speed);
      }
    }
    if (mapped.laws.liquid.acts() && (link.touching || link.bridged)) {
      const double turning = e.arm[0] * e.wet.dot(e.turning[0]) + e.arm[1] * e.wet.dot(e.turning[1]);
      rate[base + liquid_work] = time_rate_ * (mapped.force * ((e.drag * e.approach - e.capillary) * e.approach + e.wet.dot(e.centres)) +
                                               mapped.torque / mapped.spin * turning);
    }
  }
  rate.back() = time_rate_;
}

double FewBodySystem::roll_event(const Link& link, const Evaluated& e) const {
  const Rolling& rolling = laws_[link.pair].laws.rolling;
  if (!rolling.acts()) return -1;
  if (rolling.rigid()) {
    // A little past zero: what has just been let go starts there.
    return link.roll == Grip::slides ? -1e-13 * scales_[link.pair].roll - e.roll.direction().dot(e.roll_speed)
                                     : e.torque.norm() - e.roll_law.limit * (1 + 1e-11);
  }
  return e.roll.end_of_grip(e.roll_law, e.roll_speed, e.roll_acceleration, time_rate_ * laws_[link.pair].length);
}

void FewBodySystem::event_values(const State& y, Values& values) {
  constexpr auto kinds = static_cast<std::size_t>(LinkEvent::count);
  values.assign(kinds * links_.size() + laws_.size() + 1, -1.0);
  if (!links_.empty()) evaluate(y);
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Link& link = links_[c];
    const Evaluated& e = evaluated_[c];
    const ContactLaws& laws = laws_[link.pair].laws;
    const PairScales& scales = scales_[link.pair];
    const auto set = [&](LinkEvent event, double value) { values[kinds * c + static_cast<std::size_t>(event)] = value; };
    if (link.touching) {
      const double touch = std::visit([](const auto& law) { return law.touch(); }, laws.normal);
      const double end = std::visit([](const auto& law) { return law.separation(); }, laws.normal);
      set(LinkEvent::phase_end,
          link.rooted ? end_share - e.root / scales.root : (end - e.coordinate) / scales.coordinate + (flat_touch(laws) ? end_share : 0.0));
      if (!link.rooted && laws.needs_overlap_root()) set(LinkEvent::phase_begin, (e.coordinate - touch) / scales.coordinate);
      if (laws.tangential.acts()) {
        set(LinkEvent::slide, e.slide.end_of_grip(e.slide_law, e.slide_speed, e.slide_acceleration, time_rate_ * laws_[link.pair].length));
        set(LinkEvent::skid, e.slide.begin_of_skid(e.slide_law, e.slide_speed));
      }
      set(LinkEvent::roll, roll_event(link, e));
      if (laws.uses_load()) set(LinkEvent::load_sign, -e.point.load);
      // What has come to rest turns to and fro by rounding alone.
      set(LinkEvent::turn, (link.outgoing ? e.approach : -e.approach) - 1e-13 * speed_unit_);
    }
    if (laws.liquid.acts() && (link.touching || link.bridged)) {
      const double beyond = e.separation - laws.liquid.separation_min;
      set(LinkEvent::near, link.near ? beyond : -beyond);
      const double branch = e.separation - laws.liquid.rolling_branch();
      if (laws.liquid.viscous && !link.near) set(LinkEvent::branch, link.second_branch ? -branch : branch);
      if (!link.touching) set(LinkEvent::phase_end, e.separation - laws.liquid.rupture);
    }
  }
  for (std::size_t i = 0, pair = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j, ++pair) {
      const int link = link_of_[pair];
      if ((link >= 0 && links_[static_cast<std::size_t>(link)].touching) || bodies_[i].plane) continue;
      if (!std::isfinite(bodies_[i].mass) && !std::isfinite(bodies_[j].mass)) continue;
      const Geometry g = geometry(y, i, j);
      values[kinds * links_.size() + pair] = std::min(-g.gap / length_unit_, g.velocity.dot(g.normal) / speed_unit_);
    }
  }
  if (duration_ > 0) values.back() = (y.back() - duration_) / time_unit_;
}

}  // namespace scalebreak

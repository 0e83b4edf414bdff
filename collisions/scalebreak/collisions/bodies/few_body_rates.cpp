#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/few_body_system.hpp>

// The motion's rates of change.

namespace scalebreak {

using Eigen::Vector3d;

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

}  // namespace scalebreak

#pragma once

#include <cmath>
#include <type_traits>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/few_bodies.hpp>

namespace scalebreak::tests {

/// The slow, plain way to collide one pair: velocity Verlet at a fixed step with the velocities of half a step before, springs
/// that are stretched, tried against their limit and set back to it. It knows the laws' numbers (SliderLaw and the
/// normal force), and nothing of the exact engine's modes and events.
class NaivePair {
 public:
  NaivePair(std::vector<MovingBody> bodies, const MappedLaws& mapped) : bodies_(std::move(bodies)), mapped_(mapped) {}

  /// Steps from touch (which must be now) until solids and bridge have parted, or `steps` are over.
  std::vector<MovingBody> collide(double step, long steps) {
    forces(0);
    for (long k = 0; k < steps && (touching_ || bridged_); ++k) {
      kick(step / 2);
      for (MovingBody& body : bodies_) body.position += step * body.velocity;
      time_ += step;
      forces(step);
      kick(step / 2);
    }
    return bodies_;
  }

  /// The last instant at which friction was at its limit, from touch [s].
  [[nodiscard]] double last_slide() const { return last_slide_; }
  /// When it ended [s].
  [[nodiscard]] double time() const { return time_; }

 private:
  using Vector3d = Eigen::Vector3d;

  void kick(double step) {
    for (std::size_t b = 0; b < 2; ++b) {
      bodies_[b].velocity += step * force_[b] / bodies_[b].mass;
      bodies_[b].spin += step * torque_[b] / bodies_[b].inertia;
    }
  }

  void forces(double step) {
    force_ = torque_ = {Vector3d::Zero(), Vector3d::Zero()};
    const bool plane = bodies_[1].plane;
    const Vector3d between = bodies_[1].position - bodies_[0].position;
    const Vector3d n = plane ? Vector3d(-Vector3d::UnitZ()) : Vector3d(between.normalized());
    const double distance = plane ? -between[2] : between.norm();
    const double overlap = (bodies_[0].radius + bodies_[1].radius - distance) * mapped_.length;
    const Vector3d velocity = bodies_[0].velocity - bodies_[1].velocity;
    const double approach = velocity.dot(n);
    const Vector3d first = mapped_.spin * bodies_[0].spin, second = mapped_.spin * bodies_[1].spin;
    Arms arms{mapped_.radius[0], plane ? 0.0 : mapped_.radius[1]};
    if (mapped_.laws.arm == TorqueArm::contact) {
      arms.first -= plane ? overlap : overlap / 2;
      if (!plane) arms.second -= overlap / 2;
    }
    const Vector3d centres = velocity - approach * n;
    Vector3d along = Vector3d::Zero(), rolling = Vector3d::Zero();
    double normal = 0;
    if (touching_) {
      std::visit([&](const auto& law) { normal = normal_force(law, overlap, approach); }, mapped_.laws.normal);
    }
    if (touching_) {
      const double dt = step * mapped_.length;
      if (mapped_.laws.tangential.acts()) {
        const Vector3d speed = centres + (arms.first * first + arms.second * second).cross(n);
        const SliderLaw law = mapped_.laws.tangential.at(point_, {});
        along = stretched(law, speed, n, dt, sliding_);
        if (along.norm() > (1 - 1e-12) * law.limit) last_slide_ = time_;
      }
      if (mapped_.laws.rolling.acts()) {
        const Vector3d spin = (first - second) - n * n.dot(first - second);
        rolling = mapped_.laws.rolling.rigid() ? Vector3d(mapped_.laws.rolling.at(point_, {}).limit * spin.normalized())
                                               : stretched(mapped_.laws.rolling.at(point_, {}), spin, n, dt, rolled_);
      }
    }
    const Liquid& liquid = mapped_.laws.liquid;
    if (liquid.bridges() && -overlap > liquid.rupture) bridged_ = false;
    if (liquid.acts() && (touching_ || bridged_)) {
      const double s = std::max(-overlap, liquid.separation_min);
      normal += liquid.normal_drag(s) * approach - liquid.capillary_force(s);
      if (liquid.viscous) {
        const Vector3d turning = (mapped_.radius[0] * first + (plane ? 0.0 : mapped_.radius[1]) * second).cross(n);
        along += liquid.tangential_drag(s) * centres + liquid.rolling_drag(s) * turning;
      }
    }
    force_[0] = -mapped_.force * (normal * n + along);
    force_[1] = -force_[0];
    torque_[0] = -mapped_.torque * (arms.first * n.cross(along) + rolling);
    torque_[1] = -mapped_.torque * (arms.second * n.cross(along) - rolling);
  }

  /// Normal force [N] and the point of the contact; ends the contact where its law does.
  template <class Law>
  double normal_force(const Law& law, double overlap, double approach) {
    if (overlap < law.overlap(law.separation()) || (overlap <= 0 && law.separation() == law.touch() && approach < 0)) {
      touching_ = false;
      return 0;
    }
    const double above = std::max(overlap, 0.0), x = law.coordinate(law.touch() > 0 ? overlap : above);
    constexpr bool on_overlap = RootDamped<Law>;
    const double damping = [&] {
      if constexpr (on_overlap) return law.damping_of_root(std::pow(above, 0.25));
      return law.damping(x);
    }();
    point_.overlap = overlap;
    point_.root = law.root_radius(x);
    point_.overlap_root = std::pow(mapped_.laws.radius * above, 0.25);
    const double total = law.force(x) + damping * approach;
    point_.load = std::abs(law.load(x, total));
    return total;
  }

  /// Stretches a spring by `speed` for `dt`, and returns its force with the dashpot's, both within the limit.
  static Vector3d stretched(const SliderLaw& law, const Vector3d& speed, const Vector3d& n, double dt, Vector3d& history) {
    history -= n * n.dot(history);
    const Vector3d old = history;
    history += (law.incremental ? law.stiffness : 1.0) * dt * speed;
    const double stiffness = law.incremental ? 1.0 : law.stiffness;
    const Vector3d spring = stiffness * history;
    const Vector3d limited = law.dashpot_is_limited ? Vector3d(spring + law.damping * speed) : spring;
    if (limited.norm() <= law.limit) return spring + law.damping * speed;
    const Vector3d force = law.limit * limited.normalized();
    Vector3d left = force;
    if (law.dashpot_is_limited) {
      left -= law.damping * speed;
      // It would have to push forward, and further than it did: then it is let be.
      const double before = stiffness * old.dot(force), after = left.dot(force), size = 1e-9 * force.squaredNorm();
      if (after < -size && after < before) left = before > size ? Vector3d(left - force * (after / force.squaredNorm())) : stiffness * old;
    }
    history = stiffness > 0 ? Vector3d(left / stiffness) : Vector3d::Zero();
    return force;
  }

  struct Arms {
    double first, second;
  };

  std::vector<MovingBody> bodies_;
  const MappedLaws& mapped_;
  ContactPoint point_;
  Vector3d sliding_ = Vector3d::Zero(), rolled_ = Vector3d::Zero();
  std::array<Vector3d, 2> force_, torque_;
  double time_ = 0, last_slide_ = 0;
  bool touching_ = true;
  bool bridged_ = mapped_.laws.liquid.bridges();
};

}  // namespace scalebreak::tests

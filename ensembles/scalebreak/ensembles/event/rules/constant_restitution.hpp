#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/ensembles/event/rules/collision_rule.hpp>

namespace scalebreak {

/// Smooth spheres: a constant share of the normal speed comes back; 1 is elastic.
struct SmoothRule {
  static constexpr bool spins = false, displaces = false, lasts = false;
  double restitution = 1;

  [[nodiscard]] Parting collide(const Meeting& meeting) const {
    const double share = meeting.wall ? 1 : meeting.second.mass / (meeting.first.mass + meeting.second.mass);
    const Eigen::Vector3d change = -(1 + restitution) * meeting.velocity().dot(meeting.normal) * meeting.normal;
    return {.velocity = {meeting.first.velocity + share * change, meeting.second.velocity - (1 - share) * change}};
  }
};

/// Rough solid spheres: constant shares of the normal and of the sliding speed of the surfaces come back, the latter between −1 (no
/// friction) and 1 (Huthmann & Zippelius, Phys. Rev. E 56, R6275 (1997)). A contact that does not slide back keeps its twist.
struct RoughRule {
  static constexpr bool spins = true, displaces = false, lasts = false;
  double restitution = 1, surface_restitution = 0;

  [[nodiscard]] Parting collide(const Meeting& meeting) const {
    const auto inverse_mass = [&](const Meeting::Body& body) { return 1 / body.mass; };
    const auto arm_over_inertia = [&](const Meeting::Body& body) { return body.radius > 0 ? 1 / (0.4 * body.mass * body.radius) : 0.0; };
    const Meeting::Body &first = meeting.first, &second = meeting.second;
    const Eigen::Vector3d& n = meeting.normal;
    const Eigen::Vector3d sliding = meeting.velocity() + (first.radius * first.spin + second.radius * second.spin).cross(n);
    const double normal_speed = sliding.dot(n), light = inverse_mass(first) + inverse_mass(second);
    const double ease = light + first.radius * arm_over_inertia(first) + second.radius * arm_over_inertia(second);
    const Eigen::Vector3d across = -(1 + surface_restitution) / ease * (sliding - n * normal_speed);
    const Eigen::Vector3d impulse = across - (1 + restitution) * normal_speed / light * n, turn = n.cross(across);
    return {.velocity = {first.velocity + inverse_mass(first) * impulse, second.velocity - inverse_mass(second) * impulse},
            .spin = {first.spin + arm_over_inertia(first) * turn, second.spin + arm_over_inertia(second) * turn}};
  }
};

static_assert(CollisionRule<SmoothRule> && CollisionRule<RoughRule>);

}  // namespace scalebreak

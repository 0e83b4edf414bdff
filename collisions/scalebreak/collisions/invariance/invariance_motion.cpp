#include <scalebreak/collisions/invariance/invariance_motion.hpp>

#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/moving_scene.hpp>

namespace scalebreak {
namespace {

using Eigen::Vector3d;

/// What is smaller than this beside the scene's own speed is the integration's error, and nothing is divided by it.
constexpr double nothing = 1e-7;

/// The relative motion of the two bodies of a scene (the second may be a wall), n pointing from the first to the second at touch.
struct Relative {
  Vector3d velocity, surface, rolling;
  Vector3d orbital, spin;  ///< angular momenta of the pair [kg m²/s]
};

Relative relative(const std::vector<MovingBody>& bodies, double mass) {
  const MovingBody &a = bodies[0], &b = bodies[1];
  const Vector3d n = -Vector3d::UnitZ();
  const auto in_plane = [&](const Vector3d& v) { return Vector3d(v - n * n.dot(v)); };
  Relative r;
  r.velocity = a.velocity - b.velocity;
  r.surface = in_plane(r.velocity) + (a.radius * a.spin + b.radius * b.spin).cross(n);
  r.rolling = (a.spin - b.spin).cross(n);
  // Against a wall: about the point of it below the centre, as friction and its lever have it.
  const Vector3d lever = b.plane ? Vector3d(Vector3d::UnitZ() * a.position[2]) : Vector3d(a.position - b.position);
  r.orbital = mass * lever.cross(r.velocity);
  r.spin = a.inertia * a.spin + (b.plane ? Vector3d(Vector3d::Zero()) : Vector3d(b.inertia * b.spin));
  return r;
}

/// after / before along before's direction.
std::optional<double> ratio_along(const Vector3d& before, const Vector3d& after, double scale) {
  if (before.norm() <= nothing * scale) return {};
  return after.dot(before) / before.squaredNorm();
}

Input stiffened(Input input, double stiffness) {
  const ScalingLaw& law = *find_scaling_law("rps");
  for (Material* material : {&input.material, &input.second, &input.wall.material})
    *material = scaled_material(law, stiffness, *material, input.contact.normal);
  return input;
}

}  // namespace

bool moves_beyond_normal(const Input& input) {
  return input.tangential_speed != 0 || !input.spin1.isZero(0) || !input.spin2.isZero(0) || input.surface.rolling != RollingModel::none ||
         input.surface.attraction != Attraction::none;
}

bool has_small_overlap_limit(const Input& input) {
  return input.surface.attraction == Attraction::none || input.surface.attraction_range == AttractionRange::contact;
}

Input at_normal_speed(Input input, double speed) {
  const double ratio = speed / input.normal_speed;
  input.normal_speed = speed;
  input.tangential_speed *= ratio;
  input.spin1 *= ratio;
  input.spin2 *= ratio;
  return input;
}

PairMotion resolve_motion(const Input& input, const ScalingLaw& law, double factor, double tolerance, double shrink) {
  // RPS, used the other way, is exact in the limit: lengths go as Ω^{−2/5}, beside a linear contact as Ω^{−1/2}.
  const double stiffness = std::pow(shrink, input.contact.traits().constant_spring ? -2.0 : -5.0 / 2);
  MovingScene scene = moving_scene(stiffened(input, stiffness), law, factor);
  // Adhesive rolling wants one power more than the material gives it (Washino et al. 2024, Table 4).
  Rolling& rolling = scene.laws[0].laws.rolling;
  if (rolling.model == RollingModel::ar) rolling.stiffness *= std::pow(stiffness, find_scaling_law("rps")->adhesive_rolling);

  const MovingBody &first = scene.bodies[0], &second = scene.bodies[1];
  const double mass = 1 / (1 / first.mass + 1 / second.mass), distance = first.radius + second.radius;
  const Relative before = relative(scene.bodies, mass);
  const MotionOutcome outcome = scene.move({.tolerance = tolerance});
  PairMotion motion{.stuck = outcome.resting || outcome.open_contacts > 0,
                    .max_overlap = outcome.max_overlap,
                    .slides = outcome.slides,
                    .turned = outcome.turned};
  if (motion.stuck) return motion;
  const Relative after = relative(outcome.bodies, mass);
  const double speed = std::max(before.velocity.norm(), before.surface.norm());
  const auto tangential = [](Vector3d v) { return Vector3d(v[0], v[1], 0); };
  motion.restitution_normal = -after.velocity[2] / before.velocity[2];
  motion.restitution_tangential = ratio_along(tangential(before.velocity), tangential(after.velocity), speed);
  motion.restitution_surface = ratio_along(before.surface, -after.surface, speed);
  motion.restitution_rolling = ratio_along(before.rolling * distance, after.rolling * distance, speed);
  motion.contact_time = outcome.last_separation - outcome.first_touch;
  const auto unless_nothing = [&](const Vector3d& v, double unit) {
    return v.norm() * unit > nothing * speed ? v : Vector3d(Vector3d::Zero());
  };
  for (const std::size_t i : {0, 1})
    motion.spin_gained[i] = unless_nothing(outcome.bodies[i].spin - scene.bodies[i].spin, scene.bodies[i].radius);
  motion.tangential_gained = unless_nothing(tangential(after.velocity - before.velocity), 1);
  const Vector3d orbit = after.orbital - before.orbital, spins = after.spin - before.spin;
  // Rolling against a wall takes angular momentum from the pair by its nature.
  const bool couples = input.surface.tangential != TangentialModel::none || input.surface.viscous();
  if (couples && !(second.plane && input.surface.rolling != RollingModel::none)) {
    if (orbit.norm() > nothing * mass * distance * speed) motion.angular_momentum_share = -spins.dot(orbit) / orbit.squaredNorm();
    const Vector3d slip = mass * distance * Vector3d::UnitZ().cross(before.surface);
    if (before.surface.norm() > nothing * speed) motion.angular_momentum_change = (orbit + spins).dot(slip) / slip.squaredNorm();
  }
  return motion;
}

}  // namespace scalebreak

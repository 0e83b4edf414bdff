#include <scalebreak/collisions/bodies/scene_collision.hpp>

#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>

namespace scalebreak {
namespace {

using Eigen::Vector3d;

bool moves(const MovingBody& body) { return std::isfinite(body.mass); }
double surface_radius(const MovingBody& body) { return body.plane ? 0.0 : body.radius; }
/// Where a body acts from: of a plane, the foot below the other.
Vector3d from_second_to_first(const std::vector<MovingBody>& bodies) {
  if (bodies[1].plane) return Vector3d::UnitZ();
  return (bodies[0].position - bodies[1].position).normalized();
}

/// The kinds of all contacts that there can be, each once, and what acts beside them.
std::string modelled(const Input& input) {
  std::set<std::string> kinds;
  const auto add = [&](const Bodies& pair) { kinds.insert(to_string(effective_kind(input.contact, pair.pair().surface_energy))); };
  if (input.bodies.empty()) add(input.colliding());
  for (std::size_t j = 0; j < input.bodies.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const Body &a = input.bodies[i], &b = input.bodies[j];
      if (!a.fixed || !b.fixed) add({input.material_of(a), input.material_of(b), input.wall, {a.radius, b.radius}});
    }
  }
  std::string text = fmt::format("{}", fmt::join(kinds, " or "));
  if (input.surface.spins() || input.surface.attraction != Attraction::none) text += "; " + to_string(input.surface);
  return text;
}

bool spin_given(const Input& input) {
  if (input.bodies.empty()) return !input.spin1.isZero(0) || !input.spin2.isZero(0);
  return std::any_of(input.bodies.begin(), input.bodies.end(), [](const Body& body) { return !body.spin.isZero(0); });
}

struct Relative {
  Vector3d normal, centres, surfaces;  ///< from second to first; velocities of the first past the second
};
Relative relative(const std::vector<MovingBody>& bodies, const Vector3d& normal) {
  const Vector3d centres = bodies[0].velocity - bodies[1].velocity;
  const Vector3d turning = (surface_radius(bodies[0]) * bodies[0].spin + surface_radius(bodies[1]) * bodies[1].spin).cross(-normal);
  return {normal, centres, centres - normal * normal.dot(centres) + turning};
}

std::vector<MovingBody> at_first_touch(std::vector<MovingBody> bodies, double time) {
  for (MovingBody& body : bodies) body.position += time * body.velocity;
  return bodies;
}

PairMeasures measures(const Input& input, const SceneCollision& result) {
  PairMeasures m;
  const auto touch = at_first_touch(result.before, std::max(0.0, result.motion.first_touch));
  const Vector3d normal = from_second_to_first(touch);
  const Relative before = relative(touch, normal), after = relative(result.after, normal);
  m.stuck = result.motion.resting;
  m.impact_speed = -before.centres.dot(normal);
  const Vector3d tangential = before.centres - normal * normal.dot(before.centres);
  m.tangential_speed = tangential.norm();
  m.surface_speed = before.surfaces.norm();
  // What is left of a difference of large numbers is no speed.
  const double size =
      before.centres.norm() + surface_radius(touch[0]) * touch[0].spin.norm() + surface_radius(touch[1]) * touch[1].spin.norm();
  if (m.tangential_speed <= 1e-14 * size) m.tangential_speed = 0;
  if (m.surface_speed <= 1e-14 * size) m.surface_speed = 0;
  if (m.tangential_speed > 0) m.surface_direction = tangential / m.tangential_speed;
  if (m.surface_speed > 0) m.surface_direction = before.surfaces / m.surface_speed;
  const bool open = !m.stuck && result.motion.open_contacts > 0;
  const auto ratio = [&](double divisor, double value) {
    return divisor == 0 || open || result.motion.touches == 0 ? std::nullopt : std::optional(m.stuck ? 0.0 : value / divisor);
  };
  m.restitution_normal = ratio(m.impact_speed, after.centres.dot(normal));
  m.restitution_tangential = ratio(m.tangential_speed, after.centres.dot(tangential) / m.tangential_speed);
  m.restitution_surface = ratio(m.surface_speed, -after.surfaces.dot(m.surface_direction));
  if (!m.stuck && !open && result.motion.touches > 0) m.contact_time = result.motion.last_separation - result.motion.first_touch;
  if (input.surface.attraction == Attraction::none) m.sticking_speed = contact_of(input).sticking_speed(input.tolerance);
  return m;
}

/// A pair that keeps to the line of centres: restitution and momentum give what follows.
void resolve_head_on(const Input& input, const MovingScene& scene, SceneCollision& result) {
  const ScaledContact contact = contact_of(input);
  const double speed = input.normal_speed;
  const PairCollision c = contact.collide(speed, input.tolerance, true);
  const auto& before = scene.bodies;
  const bool wall = !moves(before[1]);
  const double share = wall ? 0.0 : before[0].mass / (before[0].mass + before[1].mass);
  const double time = c.contact_time.value_or(0.0), kick = (1 + c.restitution) * speed;
  // A pair that sticks is left at first touch.
  const double apart = before[0].position[2] - before[1].position[2] + (c.stuck ? 0.0 : contact.end_gap(speed));
  const Vector3d up = Vector3d::UnitZ(), drift = share * before[0].velocity + (1 - share) * before[1].velocity;
  const Vector3d centre =
      share * before[0].position + (1 - share) * before[1].position + (wall ? Vector3d::Zero() : Vector3d(time * drift));
  std::vector<MovingBody> after = before;
  after[0].velocity += (1 - share) * kick * up;
  after[1].velocity -= share * kick * up;
  after[0].position = centre + (1 - share) * apart * up;
  after[1].position = centre - share * apart * up;
  result.after = after;
  MotionOutcome& m = result.motion;
  m.bodies = after;
  m.time = time;
  m.first_touch = 0;
  m.last_separation = c.stuck ? -1 : time;
  m.touches = 1;
  m.resting = c.stuck;
  m.open_contacts = c.stuck;
  m.max_overlap = c.max_overlap;
  m.max_depth = c.max_overlap * (1 / before[0].radius + (wall ? 0.0 : 1 / before[1].radius));
  m.max_force = c.max_force;
  m.steps = c.steps;
  m.before.kinetic = kinetic_energy(before);
  m.after.kinetic = kinetic_energy(after);
  // What sticks ends at the bottom of the well once its dashpot has had the rest; without one it swings for ever.
  (c.stuck ? m.after.elastic : m.after.adhesion) = c.stuck ? -contact.well_depth() : contact.tearing_energy();
  const double rest = m.before.kinetic - m.after.total();
  if (contact.scaled().pair.damping_ratio > 0) {
    m.after.damping = rest;
  } else if (c.stuck) {
    result.internal = rest;
    m.after.kinetic += rest;
  }
}

}  // namespace

bool is_head_on(const Input& input) {
  return input.bodies.empty() && input.tangential_speed == 0 && !spin_given(input) && input.surface.attraction == Attraction::none;
}

std::vector<MovingBody> common_motion(std::vector<MovingBody> bodies, bool coupled) {
  MovingBody &a = bodies[0], &b = bodies[1];
  if (!moves(a) || !moves(b)) {
    const Vector3d normal = from_second_to_first(bodies);
    MovingBody& free = moves(a) ? a : b;
    const MovingBody& fixed = moves(a) ? b : a;
    const Vector3d past = free.velocity - fixed.velocity;
    free.velocity = fixed.velocity;
    if (!coupled) free.velocity += past - normal * normal.dot(past);
    // Turning with what it sticks to would need that to turn about the contact: a spinning fixed body slips under it.
    if (coupled) free.spin.setZero();
    return bodies;
  }
  const double mass = a.mass + b.mass;
  const Vector3d centre = (a.mass * a.position + b.mass * b.position) / mass, drift = (a.mass * a.velocity + b.mass * b.velocity) / mass;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Vector3d turning = Vector3d::Zero();
  for (const MovingBody& body : bodies) {
    const Vector3d arm = body.position - centre;
    inertia += body.mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    turning += body.mass * arm.cross(body.velocity - drift);
    if (!coupled) continue;
    inertia += body.inertia * Eigen::Matrix3d::Identity();
    turning += body.inertia * body.spin;
  }
  // Two points do not turn about their own line.
  if (!coupled) inertia += inertia.trace() * from_second_to_first(bodies) * from_second_to_first(bodies).transpose();
  const Vector3d rate = inertia.inverse() * turning;
  for (MovingBody& body : bodies) {
    body.velocity = drift + rate.cross(body.position - centre);
    if (coupled) body.spin = rate;
  }
  return bodies;
}

SceneCollision resolve_collision(const Input& input) {
  const MovingScene scene = moving_scene(input);
  SceneCollision result{.modelled = modelled(input), .head_on = is_head_on(input), .before = scene.bodies};
  result.idle_spins = spin_given(input) && !input.surface.spins();
  if (result.head_on) {
    resolve_head_on(input, scene, result);
  } else {
    result.motion = scene.move({.tolerance = input.tolerance, .duration = input.run.duration, .find_max_force = true});
    result.after = result.motion.bodies;
    if (result.motion.resting && scene.bodies.size() == 2) {
      result.after = common_motion(result.after, input.surface.spins());
      result.internal = kinetic_energy(result.motion.bodies) - kinetic_energy(result.after);
    }
  }
  result.deep = result.motion.max_depth > deep_overlap;
  if (scene.bodies.size() == 2) result.pair = measures(input, result);
  return result;
}

}  // namespace scalebreak

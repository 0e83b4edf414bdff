#include <scalebreak/collisions/pair_collision.hpp>

#include <cmath>

#include <scalebreak/collisions/normal_collision.hpp>

namespace scalebreak {
namespace {

/// Two bodies before the collision: the pair of [pair] and [impact] placed as the axes have it, or the [[body]] tables
/// with the law's size factor applied about their centre of mass.
struct Start {
  Bodies original;
  double speed;
  std::vector<BodyState> bodies;  ///< scaled system
  std::vector<double> mass;       ///< scaled; infinite for a wall
  double flight = 0;              ///< time to first touch [s]
};

Start start_of(const Input& input, const ScalingLaw& law) {
  Start start{input.colliding(), input.normal_speed, {}, {}};
  const double factor = input.scaling_factor, size = size_factor(law, factor);
  const Bodies scaled = scaled_bodies(law, factor, start.original, input.contact.normal);
  start.mass = {sphere_mass(scaled.radius[0], scaled.first.density)};
  start.mass.push_back(scaled.against_wall() ? INFINITY : sphere_mass(scaled.radius[1], scaled.second.density));
  if (input.bodies.empty()) {
    const double distance = scaled.radius[0] + (scaled.against_wall() ? 0.0 : scaled.radius[1]);
    start.bodies = {{{0, 0, distance}, {0, 0, -start.speed}}, {{0, 0, 0}, {0, 0, 0}}};
    return start;
  }
  Eigen::Vector3d centre =
      (start.mass[0] * input.bodies[0].position + start.mass[1] * input.bodies[1].position) / (start.mass[0] + start.mass[1]);
  for (const Body& body : input.bodies) start.bodies.push_back({centre + size * (body.position - centre), body.velocity});
  const Eigen::Vector3d between = start.bodies[1].position - start.bodies[0].position;
  start.speed = (start.bodies[0].velocity - start.bodies[1].velocity).dot(between.normalized());
  start.flight = std::max(0.0, (between.norm() - scaled.radius[0] - scaled.radius[1]) / start.speed);
  return start;
}

double kinetic_energy(const Start& start, const std::vector<BodyState>& bodies) {
  double energy = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (std::isfinite(start.mass[i])) energy += start.mass[i] * bodies[i].velocity.squaredNorm() / 2;
  }
  return energy;
}

/// Momentum and restitution give the velocities; the centre of mass moves on meanwhile, and the bodies part at the distance
/// at which the contact ended; a pair that sticks is left at first touch, in its common motion.
std::vector<BodyState> after(const Start& start, const PairCollision& collision, double distance) {
  std::vector<BodyState> bodies = start.bodies;
  const Eigen::Vector3d normal = (bodies[0].position - bodies[1].position).normalized();
  const bool wall = !std::isfinite(start.mass[1]);
  const double share = wall ? 0.0 : start.mass[0] / (start.mass[0] + start.mass[1]);
  const double kick = (1 + collision.restitution) * start.speed;
  const double time = start.flight + collision.contact_time.value_or(0.0);
  const Eigen::Vector3d centre = share * bodies[0].position + (1 - share) * bodies[1].position;
  const Eigen::Vector3d drift = share * bodies[0].velocity + (1 - share) * bodies[1].velocity;
  bodies[0].velocity += (1 - share) * kick * normal;
  bodies[1].velocity -= share * kick * normal;
  bodies[0].position = centre + time * drift + (1 - share) * distance * normal;
  bodies[1].position = centre + time * drift - share * distance * normal;
  return bodies;
}

double end_overlap(const ContactKind& kind) {
  if (!kind.adhesive()) return 0;
  const auto law = reduced_jkr<double, DampingOn::contact_radius>(0.0, kind.range);
  return law.overlap(law.separation());
}

}  // namespace

ScaledContact::ScaledContact(const ContactKind& kind, const Bodies& original, const ScalingLaw& law, double factor)
    : kind_(kind), scaled_(scaled_pair(law, factor, original, kind.normal)) {
  kind_ = effective_kind(kind, scaled_.pair.surface_energy);
}

std::optional<double> ScaledContact::sticking_speed(double tolerance) const {
  if (!kind_.adhesive()) return std::nullopt;
  const ReducedCollision unit = reduced(1.0);
  const double stick = reduced_sticking_speed(kind_, unit.damping_ratio, std::min(tolerance, 1e-12)) * unit.scales.speed();
  return std::isfinite(stick) ? std::optional(stick) : std::nullopt;
}

PairCollision ScaledContact::collide(double speed, double tolerance, bool find_max_force) const {
  const ReducedCollision problem = reduced(speed);
  const auto outcome = resolve_normal_collision<double>(kind_, problem.damping_ratio, problem.speed,
                                                        {.tolerance = tolerance, .find_max_force = find_max_force});
  PairCollision collision{.kind = kind_, .stuck = outcome.stuck, .restitution = outcome.restitution};
  if (!outcome.stuck) collision.contact_time = outcome.contact_time * problem.scales.time * scaled_.time;
  collision.max_overlap = outcome.max_overlap * problem.scales.overlap * scaled_.overlap;
  collision.max_force = outcome.max_force * problem.scales.force * scaled_.force;
  collision.steps = outcome.steps;
  return collision;
}

std::vector<TrajectoryPoint> ScaledContact::trajectory(double speed, double tolerance, int points) const {
  const ReducedCollision problem = reduced(speed);
  const auto& scales = problem.scales;
  std::vector<TrajectoryPoint> path;
  CollisionOptions<double> options{.tolerance = tolerance, .max_step = 2.5 / points};
  options.observer = [&](const ContactSample<double>& sample) {
    const double root = sample.coordinate * scales.coordinate;
    const double radius = kind_.normal == NormalModel::linear ? 0.0 : root * root;
    path.push_back({sample.time * scales.time * scaled_.time, sample.overlap * scales.overlap * scaled_.overlap, radius,
                    sample.speed * scales.speed(), sample.elastic_force * scales.force * scaled_.force,
                    sample.damping_force * scales.force * scaled_.force});
  };
  (void)resolve_normal_collision<double>(kind_, problem.damping_ratio, problem.speed, options);
  return path;
}

std::pair<ScaledContact, double> contact_of(const Input& input) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  const Start start = start_of(input, law);
  return {ScaledContact(input.contact, start.original, law, input.scaling_factor), start.speed};
}

CollisionResult resolve_collision(const Input& input) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  const Start start = start_of(input, law);
  const ScaledContact contact(input.contact, start.original, law, input.scaling_factor);
  CollisionResult result{.collision = contact.collide(start.speed, input.tolerance, true), .speed = start.speed};
  result.collision.sticking_speed = contact.sticking_speed(input.tolerance);
  const Bodies scaled = scaled_bodies(law, input.scaling_factor, start.original, input.contact.normal);
  result.deep = result.collision.max_overlap > deep_overlap * scaled.pair().radius;
  double distance = scaled.radius[0] + (scaled.against_wall() ? 0.0 : scaled.radius[1]);
  if (!result.collision.stuck)
    distance -= end_overlap(contact.kind()) * contact.reduced(start.speed).scales.overlap * contact.scaled().overlap;
  result.bodies = after(start, result.collision, distance);
  result.energy_before = kinetic_energy(start, start.bodies);
  result.energy_after = kinetic_energy(start, result.bodies);
  return result;
}

}  // namespace scalebreak

#include <scalebreak/collisions/normal/pair_collision.hpp>

#include <cmath>

#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/contact/normal_law.hpp>

namespace scalebreak {
ScaledContact::ScaledContact(const ContactKind& kind, const Bodies& original, const ScalingLaw& law, double factor,
                             std::array<bool, 2> fixed)
    : kind_(kind), scaled_(scaled_pair(law, factor, original, kind.normal)) {
  for (const std::size_t moves : {0, 1}) {
    if (!fixed[1 - moves]) continue;
    const Material& material = moves == 0 ? original.first : original.second;
    scaled_.pair.mass *= sphere_mass(original.radius[moves], material.density) / original.pair().mass;
  }
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

double ScaledContact::end_gap(double speed) const {
  if (!kind_.adhesive()) return 0;
  return reduced_end_gap(kind_) * reduced(speed).scales.overlap * scaled_.overlap;
}

double ScaledContact::tearing_energy() const {
  const double energy = std::visit([](const auto& law) { return law.energy(law.separation()); }, normal_law(kind_, scaled_.pair));
  return energy * scaled_.force * scaled_.overlap;
}

double ScaledContact::well_depth() const {
  if (!kind_.adhesive()) return 0;
  const double energy = std::visit([](const auto& law) { return law.energy(law.bottom()); }, normal_law(kind_, scaled_.pair));
  return -energy * scaled_.force * scaled_.overlap;
}

std::vector<TrajectoryPoint> ScaledContact::trajectory(double speed, double tolerance, int points) const {
  const ReducedCollision problem = reduced(speed);
  const auto& scales = problem.scales;
  const NormalLaw evaluated = normal_law(kind_, scaled_.pair);
  std::vector<TrajectoryPoint> path;
  CollisionOptions<double> options{.tolerance = tolerance, .max_step = 2.5 / points};
  options.observer = [&](const ContactSample<double>& sample) {
    const double root = std::visit([&](const auto& law) { return law.root_radius(sample.coordinate * scales.coordinate); }, evaluated);
    path.push_back({sample.time * scales.time * scaled_.time, sample.overlap * scales.overlap * scaled_.overlap, root * root,
                    sample.speed * scales.speed(), sample.elastic_force * scales.force * scaled_.force,
                    sample.damping_force * scales.force * scaled_.force});
  };
  (void)resolve_normal_collision<double>(kind_, problem.damping_ratio, problem.speed, options);
  return path;
}

ScaledContact contact_of(const Input& input) {
  std::array<bool, 2> fixed = {false, false};
  if (!input.bodies.empty()) fixed = {input.bodies[0].fixed, input.bodies[1].fixed};
  return {input.contact, input.colliding(), *find_scaling_law(input.scaling_law), input.scaling_factor, fixed};
}

}  // namespace scalebreak

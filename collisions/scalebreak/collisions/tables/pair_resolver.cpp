#include <scalebreak/collisions/tables/pair_resolver.hpp>

#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/scene_collision.hpp>
#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>

namespace scalebreak {

using Eigen::Vector3d;

PairResolver::PairResolver(const Input& input, const TableStore& store, const PairTolerance& tolerance)
    : tolerance_(tolerance), scene_(moving_scene(input)) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  const Bodies bodies = scaled_bodies(law, input.scaling_factor, input.colliding(), input.contact.normal);
  const MovingBody &first = scene_.bodies[0], &second = scene_.bodies[1];
  pair_ = {.kind = effective_kind(input.contact, bodies.pair().surface_energy),
           .surface = input.surface,
           .normal = bodies.pair(),
           .mass = {first.mass, second.mass},
           .radius = {first.radius, second.plane ? 0.0 : second.radius},
           .inertia = {first.inertia, second.inertia},
           .wall = second.plane};
  pair_.normal.mass = 1 / (1 / first.mass + 1 / second.mass);
  if (!law.direct_force && input.surface.attraction == Attraction::none) {
    const NormalPair& normal = pair_.normal;
    const SurfacePair surfaces = bodies.surfaces();
    row_ = obtain_table({pair_.kind, tolerance.normal}, store).table.row(normal.damping_ratio);
    const double total = pair_.radius[0] + pair_.radius[1];
    const auto oblique =
        oblique_key(pair_.kind, input.surface, normal, surfaces, solid_sphere_inertia, pair_.radius[0] / total, tolerance.oblique);
    const auto rolling = rolling_key(pair_.kind, input.surface, normal, surfaces, 1 / first.inertia + 1 / second.inertia, tolerance.oblique,
                                     std::pow(input.scaling_factor, law.adhesive_rolling));
    if (rolls_apart(input.surface, pair_.radius, pair_.inertia)) {
      if (oblique.key) oblique_ = obtain_oblique_table(*oblique.key, store).table;
      if (rolling.key) rolling_ = obtain_rolling_table(*rolling.key, store).table;
    }
  }
  lookup_.emplace(pair_, row_ ? &*row_ : nullptr, oblique_ ? &*oblique_ : nullptr, rolling_ ? &*rolling_ : nullptr);
}

PairOutcome PairResolver::collide(const PairImpact& impact) {
  PairOutcome outcome = look_up(impact);
  ++counts_[static_cast<std::size_t>(outcome.refusal)];
  if (outcome.refusal == Refusal::none) return outcome;
  const Refusal reason = outcome.refusal;
  outcome = integrate(impact);
  outcome.refusal = reason;
  return outcome;
}

PairOutcome PairResolver::integrate(const PairImpact& impact) const {
  // The engine's wall lies below its bodies.
  const Eigen::Quaterniond turn =
      pair_.wall ? Eigen::Quaterniond::FromTwoVectors(impact.normal, -Vector3d::UnitZ()) : Eigen::Quaterniond::Identity();
  std::vector<MovingBody> bodies = scene_.bodies;
  for (std::size_t i = 0; i < 2; ++i) {
    bodies[i].velocity = turn * impact.velocity[i];
    bodies[i].spin = turn * impact.spin[i];
  }
  bodies[1].position.setZero();
  bodies[0].position = -(pair_.radius[0] + pair_.radius[1]) * (turn * impact.normal);
  const Vector3d start = bodies[0].position;
  const MotionOutcome motion = move_bodies(bodies, [this](int i, int j) { return scene_.between(i, j); }, {.tolerance = tolerance_.exact});
  PairOutcome outcome{.stuck = motion.resting};
  const auto after = motion.resting ? common_motion(motion.bodies, pair_.surface.spins()) : motion.bodies;
  for (std::size_t i = 0; i < 2; ++i) {
    outcome.velocity[i] = turn.conjugate() * after[i].velocity;
    outcome.spin[i] = turn.conjugate() * after[i].spin;
  }
  if (!outcome.stuck) outcome.contact_time = motion.last_separation - motion.first_touch;
  outcome.displacement = turn.conjugate() * (after[0].position - after[1].position - start);
  return outcome;
}

}  // namespace scalebreak

#include <scalebreak/collisions/tables/pair_resolver.hpp>

#include <cmath>

#include <Eigen/Geometry>

#include <scalebreak/collisions/bodies/scene_collision.hpp>
#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>

namespace scalebreak {

using Eigen::Vector3d;

CollidingPair colliding_pair(const Input& input) {
  const Bodies bodies = scaled_bodies(*find_scaling_law(input.scaling_law), input.scaling_factor, input.colliding(), input.contact.normal);
  const MovingScene scene = moving_scene(input);
  const MovingBody &first = scene.bodies[0], &second = scene.bodies[1];
  CollidingPair pair{.kind = effective_kind(input.contact, bodies.pair().surface_energy),
                     .surface = input.surface,
                     .normal = bodies.pair(),
                     .mass = {first.mass, second.mass},
                     .radius = {first.radius, second.plane ? 0.0 : second.radius},
                     .inertia = {first.inertia, second.inertia},
                     .wall = second.plane};
  pair.normal.mass = 1 / (1 / first.mass + 1 / second.mass);
  return pair;
}

PairOutcome integrate_impact(const MovingScene& scene, const CollidingPair& pair, const PairImpact& impact, double tolerance) {
  // The engine's wall lies below its bodies.
  const Eigen::Quaterniond turn =
      pair.wall ? Eigen::Quaterniond::FromTwoVectors(impact.normal, -Vector3d::UnitZ()) : Eigen::Quaterniond::Identity();
  std::vector<MovingBody> bodies = scene.bodies;
  for (std::size_t i = 0; i < 2; ++i) {
    bodies[i].velocity = turn * impact.velocity[i];
    bodies[i].spin = turn * impact.spin[i];
  }
  bodies[1].position.setZero();
  bodies[0].position = -(pair.radius[0] + pair.radius[1]) * (turn * impact.normal);
  const Vector3d start = bodies[0].position;
  const MotionOutcome motion = move_bodies(bodies, [&scene](int i, int j) { return scene.between(i, j); }, {.tolerance = tolerance});
  PairOutcome outcome{.stuck = motion.resting};
  const auto after = motion.resting ? common_motion(motion.bodies, pair.surface.spins()) : motion.bodies;
  for (std::size_t i = 0; i < 2; ++i) {
    outcome.velocity[i] = turn.conjugate() * after[i].velocity;
    outcome.spin[i] = turn.conjugate() * after[i].spin;
  }
  if (!outcome.stuck) outcome.contact_time = motion.last_separation - motion.first_touch;
  outcome.displacement = turn.conjugate() * (after[0].position - after[1].position - start);
  return outcome;
}

PairResolver::PairResolver(const Input& input, const TableStore& store, const PairTolerance& tolerance)
    : tolerance_(tolerance), scene_(moving_scene(input)), pair_(colliding_pair(input)) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  if (!law.direct_force && input.surface.attraction == Attraction::none) {
    const NormalPair& normal = pair_.normal;
    const SurfacePair surfaces = scaled_bodies(law, input.scaling_factor, input.colliding(), input.contact.normal).surfaces();
    row_ = obtain_table({pair_.kind, tolerance.normal}, store).table.row(normal.damping_ratio);
    const double total = pair_.radius[0] + pair_.radius[1];
    const auto oblique =
        oblique_key(pair_.kind, input.surface, normal, surfaces, solid_sphere_inertia, pair_.radius[0] / total, tolerance.oblique);
    const auto rolling = rolling_key(pair_.kind, input.surface, normal, surfaces, 1 / pair_.inertia[0] + 1 / pair_.inertia[1],
                                     tolerance.oblique, std::pow(input.scaling_factor, law.adhesive_rolling));
    if (oblique.key) oblique_ = obtain_oblique_table(*oblique.key, store).table;
    if (rolling.key) rolling_ = obtain_rolling_table(*rolling.key, store).table;
  }
  lookup_.emplace(pair_, row_ ? &*row_ : nullptr, oblique_ ? &*oblique_ : nullptr, rolling_ ? RollingLookup(*rolling_) : RollingLookup());
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

}  // namespace scalebreak

#include <scalebreak/ensembles/tradeoff/tabulated_collision.hpp>

#include <chrono>
#include <memory>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/tables/pair_resolver.hpp>

namespace scalebreak {
namespace {

/// At least so many, so that the clock does not matter.
constexpr int timed_lookups = 1000;

/// Finer tables take more than half a minute of a core to build. Sliding and rolling give tables an axis more, on which lie the kinks where slip begins and ends.
double finest_tolerance(const Input& input) {
  if (input.surface.tangential == TangentialModel::none && input.surface.rolling == RollingModel::none) return 1e-7;
  return effective_kind(input.contact, input.colliding().pair().surface_energy).adhesive() ? 1e-4 : 1e-5;
}

/// At first touch body 1 is at +z of body 2.
PairImpact impact_of(const MovingScene& scene) {
  PairImpact impact{.normal = -Eigen::Vector3d::UnitZ()};
  for (std::size_t i = 0; i < 2; ++i) impact.velocity[i] = scene.bodies[i].velocity, impact.spin[i] = scene.bodies[i].spin;
  return impact;
}

CollisionOutcome looked_up(const CollisionScene& scene, const PairResolver& pair) {
  const PairImpact impact = impact_of(scene.moving);
  PairOutcome found;
  const auto began = std::chrono::steady_clock::now();
  for (int i = 0; i < timed_lookups; ++i) found = pair.look_up(impact);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() / timed_lookups;
  CollisionOutcome outcome{.bodies = scene.moving.bodies, .contact_time = found.contact_time, .force_evaluations = 1, .seconds = seconds};
  for (std::size_t i = 0; i < 2; ++i) outcome.bodies[i].velocity = found.velocity[i], outcome.bodies[i].spin = found.spin[i];
  return outcome;
}

}  // namespace

PreparedCollision tabulated_collision(const CollisionScene& scene, double tolerance, const TableStore& store) {
  if (!scene.is_pair()) return {.refusal = "tables are of one collision of a pair, given by [pair] and [impact]"};
  if (!scene.has_parted()) return {.refusal = "tables tell how a collision ends, and at run.duration this one has not"};
  const std::string none = "no table answers this collision: ";
  if (scene.input.surface.attraction != Attraction::none) return {.refusal = none + to_string(Refusal::liquid)};
  if (tolerance < finest_tolerance(scene.input) * (1 - 1e-9))
    return {.refusal = fmt::format("tables of such contacts are built down to {:g}; finer ones take long to build",
                                   finest_tolerance(scene.input))};
  try {
    const auto pair = std::make_shared<const PairResolver>(scene.input, store,
                                                           PairTolerance{.normal = tolerance, .oblique = tolerance, .turning = tolerance});
    const Refusal refusal = pair->look_up(impact_of(scene.moving)).refusal;
    if (refusal != Refusal::none) return {.refusal = none + to_string(refusal)};
    return {.resolve = [&scene, pair](double, double) { return looked_up(scene, *pair); }};
  } catch (const WorkError& failed) {
    return {.refusal = failed.what()};
  }
}

}  // namespace scalebreak

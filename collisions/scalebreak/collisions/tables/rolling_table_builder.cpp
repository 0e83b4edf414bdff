#include <scalebreak/collisions/tables/rolling_table_builder.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/tables/patch_builder.hpp>
#include <scalebreak/collisions/tables/reduced_impact.hpp>

namespace scalebreak {
namespace {

/// Beside adhesion the dashpot of `epsd` goes as its spring slips, so that the outcome jumps a little along a line: across it no cell is narrower.
constexpr double narrowest_jump = 1.0 / 1024;

/// The pair of a key in reduced units: two equal bodies between which nothing slides, and whose normal never turns.
ObliquePair reduced_rolling_pair(const RollingKey& key) {
  const NormalPair normal = reduced_pair(key.kind, key.damping_ratio);
  SurfacePair surfaces{};
  surfaces.shear = key.stiffness * normal.young;
  surfaces.spring_constant_tangential = key.stiffness;
  surfaces.rolling_friction = key.limit;
  surfaces.rolling_angle_max = key.limit;
  surfaces.rolling_damping = key.dashpot;
  surfaces.rolling_inertia = 1;
  surfaces.surface_energy = normal.surface_energy;
  const double inertia = 2 / key.inertia;
  return {.laws = contact_laws(key.kind, {.rolling = key.model}, normal, surfaces, key.stiffness),
          .mass = 1,
          .radius = {1, 1},
          .inertia = {inertia, inertia}};
}

double resolved_entry(const RollingKey& key, double speed, double ratio, double tolerance) {
  const double rolling = ratio * speed;
  const ObliqueOutcome outcome = resolve_oblique_collision(reduced_rolling_pair(key), {speed, 0, {rolling / 2, -rolling / 2}}, tolerance);
  if (outcome.stuck) throw WorkError(fmt::format("a collision of a rolling table sticks, at a reduced speed of {:g}", speed));
  return (outcome.spin[0] - outcome.spin[1]) / rolling;
}

}  // namespace

RollingKeyOrReason rolling_key(const ContactKind& kind, const SurfaceKind& surface, const NormalPair& pair, const SurfacePair& surfaces,
                               double inertia, double tolerance, double adhesive_rolling) {
  if (surface.rolling == RollingModel::none) return {{}, "nothing resists rolling"};
  if (surface.attraction != Attraction::none) return {{}, "a liquid acts"};
  const double lever = pair.mass * pair.radius * pair.radius;
  RollingKey key{.kind = kind,
                 .model = surface.rolling,
                 .damping_ratio = pair.damping_ratio,
                 .limit = surfaces.rolling_friction,
                 .inertia = lever * inertia,
                 .tolerance = tolerance};
  switch (surface.rolling) {
    case RollingModel::epsd: key.dashpot = surfaces.rolling_damping * std::sqrt(surfaces.rolling_inertia / lever); break;
    case RollingModel::epsd2:
      key.stiffness =
          kind.traits().constant_spring ? reduced_spring(kind, pair, surfaces.spring_constant_tangential) : surfaces.shear / pair.young;
      break;
    case RollingModel::ar: {
      if (!kind.adhesive()) return {{}, "adhesive rolling beside a contact without adhesion is another one at every speed"};
      const double slope = reduce(kind, pair, 1.0).scales.overlap / pair.radius;
      key.limit = surfaces.rolling_angle_max / slope;
      key.stiffness = adhesive_rolling * slope;
      break;
    }
    case RollingModel::sds: return {{}, "the rolling spring of \"sds\" is another one at every size and speed"};
    default: break;
  }
  return {key, ""};
}

RollingKeyOrReason rolling_key(const Input& input, double tolerance) {
  const Bodies bodies = input.colliding();
  const NormalPair pair = bodies.pair();
  const auto inertia = [&](const Material& material, double radius) {
    return 0.4 * sphere_mass(radius, material.density) * radius * radius;
  };
  const std::array<double, 2> radius = {bodies.radius[0], bodies.against_wall() ? 0.0 : bodies.radius[1]};
  const std::array<double, 2> inertias = {inertia(bodies.first, radius[0]), bodies.against_wall() ? std::numeric_limits<double>::infinity()
                                                                                                  : inertia(bodies.second, radius[1])};
  return rolling_key(effective_kind(input.contact, pair.surface_energy), input.surface, pair, bodies.surfaces(),
                     1 / inertias[0] + 1 / inertias[1], tolerance);
}

double exact_rolling_entry(const RollingKey& key, double speed, double ratio, double tolerance) {
  if (key.model != RollingModel::cdt) return resolved_entry(key, speed, ratio, tolerance);
  // A torque without a spring takes the same from every rolling until it has stopped it, and then nothing pushes.
  constexpr double fast = 1e3;
  return std::max(0.0, 1 - fast * (1 - resolved_entry(key, speed, fast, tolerance / fast)) / ratio);
}

RollingTable build_rolling_table(const RollingKey& key, int threads, const std::function<void(double)>& progress) {
  const bool adhesive = key.kind.adhesive();
  const ImpactPlane plane{adhesive, reduced_sticking_squared(key.kind, key.damping_ratio)};
  const auto speed_at = [&](double x) { return plane.speed_at(x, TableBounds::excess_min / 2); };
  std::vector<double> half_way(adhesive ? 193 : 6);
  parallel_for(half_way.size(), threads, [&](std::size_t i) {
    const double speed = speed_at(static_cast<double>(i) / static_cast<double>(half_way.size() - 1)), ratio = 1e3;
    half_way[i] = std::max(ratio * (1 - exact_rolling_entry(key, speed, ratio, 1e-12)), 1e-6);
  });
  const double exact = std::min(1e-8, 1e-4 * key.tolerance);
  const auto entry_at = [&](double x, double y) {
    const double ratio = RollingTable::half_way_at(half_way, x) * plane.ratio_at(y, least_ratio, most_ratio);
    return RollingTable::Entries::Value(exact_rolling_entry(key, speed_at(x), ratio, exact));
  };
  auto entries = build_patches<1>(entry_at, {.tolerance = key.tolerance,
                                             .threads = threads,
                                             .most_cells = 150'000,
                                             .one_dimensional = !adhesive,
                                             .narrowest = adhesive && key.model == RollingModel::epsd ? narrowest_jump : 0,
                                             .progress = progress});
  constexpr int samples = 4000;
  std::vector<double> errors(samples);
  parallel_for(samples, threads, [&](int i) {
    const auto [x, y] = sample_point(adhesive, i);
    errors[static_cast<std::size_t>(i)] = std::abs(entries.at(x, y)[0] - entry_at(x, y)[0]);
  });
  RollingQuality quality{.samples = samples};
  for (const double error : errors) {
    quality.error_max = std::max(quality.error_max, error);
    quality.error_rms += error * error / samples;
  }
  quality.error_rms = std::sqrt(quality.error_rms);
  return {key, plane.sticking_squared, std::move(half_way), std::move(entries), quality};
}

}  // namespace scalebreak

#include <scalebreak/collisions/tables/oblique_table_builder.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/tables/patch_builder.hpp>
#include <scalebreak/collisions/tables/reduced_impact.hpp>

namespace scalebreak {
namespace {

/// Beyond so many ψ₀ the turning's share is not tabulated.
constexpr double most_turning_ratio = 300;
/// Errors of the turning are errors of a small correction: of it over a table's tolerance, and the narrowest cell over that.
constexpr double turning_tolerance = 200, narrowest_turning = 1.0 / 128 / 1e-4;

/// Largest overlap of the normal collision at v̂: what the turning is measured by.
double largest_overlap(const ObliqueKey& key, double speed) {
  return resolve_normal_collision<double>(key.kind, key.damping_ratio, speed, {.tolerance = 1e-8}).max_overlap;
}

double sliding_speed(const ObliquePair& pair, const ObliqueOutcome& outcome) {
  return outcome.tangential_speed + pair.radius[0] * outcome.spin[0] + pair.radius[1] * outcome.spin[1];
}

ObliqueOutcome collide(const ObliquePair& pair, double speed, double sliding, double tangential, double tolerance) {
  // The spins make up for what the centres' speed is not; equal surface speeds of both bodies.
  const double rest = sliding - tangential;
  ObliqueImpact impact{speed, tangential, {rest / pair.radius[0], 0}};
  if (!pair.wall) impact.spin = {rest / (2 * pair.radius[0]), rest / (2 * pair.radius[1])};
  const ObliqueOutcome outcome = resolve_oblique_collision(pair, impact, tolerance);
  if (outcome.stuck) throw WorkError(fmt::format("a collision of an oblique table sticks, at a reduced speed of {:g}", speed));
  return outcome;
}

/// How far the sliding speed falls in gross sliding, over v_n: ψ₀.
double half_way(const ObliqueKey& key) {
  const double speed = key.kind.adhesive() ? 10.0 : 1.0, ratio = 1e3;
  const double drop = ratio * (1 - exact_oblique_entry(key, speed, ratio, 1e-9).surface_restitution);
  return drop > 0 ? drop : 1.0;
}

}  // namespace

ObliqueKeyOrReason oblique_key(const ContactKind& kind, const SurfaceKind& surface, const NormalPair& pair, const SurfacePair& surfaces,
                               double inertia, double share, double tolerance) {
  if (surface.tangential == TangentialModel::none) return {{}, "nothing acts tangentially"};
  const bool linear = surface.tangential == TangentialModel::linear;
  // An adhesive contact has units of its own, whatever the speed.
  if (!kind.adhesive() && linear != kind.traits().constant_spring) {
    return {{},
            fmt::format("{} beside contact.normal = \"{}\" is another one at every speed",
                        linear ? "a linear tangential spring" : "Mindlin's spring", to_string(kind.normal))};
  }
  if (surface.attraction != Attraction::none) return {{}, "a liquid acts"};
  ObliqueKey key{
      .kind = kind,
      .surface = {.tangential = surface.tangential, .tangential_radius = surface.tangential_radius, .torque_arm = surface.torque_arm},
      .damping_ratio = pair.damping_ratio,
      .friction = surfaces.sliding_friction,
      .stiffness = surfaces.shear / pair.young,
      .inertia = inertia,
      .share = surface.torque_arm == TorqueArm::contact ? share : 0.5,
      .tolerance = tolerance};
  if (linear) key.stiffness = reduced_spring(kind, pair, surfaces.spring_constant_tangential);
  return {key, ""};
}

ObliqueKeyOrReason oblique_key(const Input& input, double tolerance) {
  const Bodies bodies = input.colliding();
  const NormalPair pair = bodies.pair();
  const double total = bodies.against_wall() ? bodies.radius[0] : bodies.radius[0] + bodies.radius[1];
  return oblique_key(effective_kind(input.contact, pair.surface_energy), input.surface, pair, bodies.surfaces(), solid_sphere_inertia,
                     bodies.radius[0] / total, tolerance);
}

ObliquePair reduced_oblique_pair(const ObliqueKey& key, double depth) {
  const NormalPair normal = reduced_pair(key.kind, key.damping_ratio);
  SurfacePair surfaces{};
  surfaces.shear = key.stiffness * normal.young;
  surfaces.spring_constant_tangential = key.stiffness;
  surfaces.sliding_friction = key.friction;
  ObliquePair pair{.laws = contact_laws(key.kind, key.surface, normal, surfaces), .mass = 1};
  pair.wall = key.share == 1;
  const double distance = depth != 0 ? 1 / depth : 1.0;
  pair.radius = {key.share * distance, (1 - key.share) * distance};
  if (depth == 0) {
    pair.laws.arm = TorqueArm::radius;
  } else if (!pair.wall) {
    pair.distance = distance;
  }
  // The inertia falls to the bodies as to spheres of one density.
  const double cube1 = std::pow(key.share, 3), cube2 = std::pow(1 - key.share, 3);
  const double first = key.inertia * cube2 / (cube1 + cube2), second = key.inertia - first;
  pair.inertia = {pair.radius[0] * pair.radius[0] / (pair.wall ? key.inertia : first),
                  pair.wall ? std::numeric_limits<double>::infinity() : pair.radius[1] * pair.radius[1] / second};
  return pair;
}

ObliqueEntry exact_oblique_entry(const ObliqueKey& key, double speed, double ratio, double tolerance) {
  const ObliquePair pair = reduced_oblique_pair(key, 0);
  const double sliding = ratio * speed;
  const ObliqueOutcome outcome = collide(pair, speed, sliding, sliding, tolerance);
  return {sliding_speed(pair, outcome) / sliding, 1 - outcome.displacement / (sliding * outcome.contact_time)};
}

TurningEntry exact_turning_entry(const ObliqueKey& key, double speed, double ratio) {
  const double one = 1 + ratio, share = 3e-4 / (one * one), depth = share / largest_overlap(key, speed);
  const ObliquePair forward = reduced_oblique_pair(key, depth), backward = reduced_oblique_pair(key, -depth);
  Eigen::Array<double, 3, 3> change;  // of normal, tangential, sliding speed (rows), at τ = −one, 0, one
  for (int k = 0; k < 3; ++k) {
    const double tau = (k - 1) * one;
    const auto with = collide(forward, speed, ratio * speed, tau * speed, 1e-11);
    const auto against = collide(backward, speed, ratio * speed, tau * speed, 1e-11);
    change.col(k) = Eigen::Array3d(with.normal_speed - against.normal_speed, with.tangential_speed - against.tangential_speed,
                                   sliding_speed(forward, with) - sliding_speed(backward, against)) /
                    (2 * share * speed);
  }
  const auto parabola = [&](int row) {
    const double below = change(row, 0), middle = change(row, 1), above = change(row, 2);
    return Eigen::Array3d(middle, (above - below) / (2 * one), (above + below - 2 * middle) / (2 * one * one));
  };
  return {parabola(0), parabola(1), parabola(2)};
}

ObliqueTable build_oblique_table(const ObliqueKey& key, int threads, const std::function<void(double)>& progress) {
  const bool adhesive = key.kind.adhesive();
  const double stick_squared = reduced_sticking_squared(key.kind, key.damping_ratio);
  const ImpactPlane plane{adhesive, stick_squared, half_way(key)};
  const double exact = std::min(1e-8, 1e-4 * key.tolerance);
  const auto entry_at = [&](double x, double y) {
    const ObliqueEntry entry =
        exact_oblique_entry(key, plane.speed_at(x, TableBounds::excess_min / 2), plane.ratio_at(y, least_ratio, most_ratio), exact);
    return Eigen::Array2d(entry.surface_restitution, entry.lag);
  };
  const auto turning_at = [&](double x, double y) {
    const double ratio = plane.ratio_at(y, least_ratio, most_turning_ratio), one = 1 + ratio;
    const TurningEntry entry = exact_turning_entry(key, plane.speed_at(x, ObliqueTable::turning_excess / 2), ratio);
    const Eigen::Array3d size(one * one, one, 1);
    Eigen::Array<double, 10, 1> value;
    value << entry.normal / size, entry.tangential / size, entry.sliding / size, 0.0;
    return value;
  };
  const PatchBuild build{
      .tolerance = key.tolerance, .threads = threads, .most_cells = 150'000, .one_dimensional = !adhesive, .progress = progress};
  auto entries = build_patches<2>(entry_at, build);
  PatchBuild rough = build;
  rough.tolerance = turning_tolerance * key.tolerance;
  rough.narrowest = std::min(1.0 / 16, narrowest_turning * key.tolerance);  // across a kink the correction jumps
  auto turnings = build_patches<10>(turning_at, rough);

  constexpr int samples = 4000, turning_samples = 400;
  std::vector<double> errors(samples), turning_errors(turning_samples);
  parallel_for(samples, threads, [&](int i) {
    const auto [x, y] = sample_point(adhesive, i);
    errors[static_cast<std::size_t>(i)] = (entries.at(x, y) - entry_at(x, y)).abs().maxCoeff();
    if (i < turning_samples) turning_errors[static_cast<std::size_t>(i)] = (turnings.at(x, y) - turning_at(x, y)).abs().maxCoeff();
  });
  ObliqueQuality quality{.samples = samples};
  for (const double error : errors) {
    quality.error_max = std::max(quality.error_max, error);
    quality.error_rms += error * error / samples;
  }
  quality.error_rms = std::sqrt(quality.error_rms);
  std::nth_element(turning_errors.begin(), turning_errors.begin() + turning_samples / 2, turning_errors.end());
  quality.turning_error_median = turning_errors[turning_samples / 2];
  return {key, plane.sticking_squared, plane.half_way, std::move(entries), std::move(turnings), quality};
}

}  // namespace scalebreak

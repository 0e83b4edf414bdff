#include <scalebreak/scene/flow_scene.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/base/random.hpp>
#include <scalebreak/contact/contact_laws.hpp>
#include <scalebreak/scene/sphere_sizes.hpp>

namespace scalebreak {
namespace {

constexpr double default_rows = 200;

const ScalingLaw& law_of(const Input& input) { return *find_scaling_law(input.scaling_law); }
double size_factor(const Input& input) { return size_factor(law_of(input), input.scaling_factor); }
Densities densities(const Input& input) { return {input.material.density, input.second.density}; }

double reach_of(const Input& input, const Material& first, double radius1, const Material& second, double radius2) {
  const NormalPair pair = sphere_pair(first, radius1, second, radius2);
  const ContactKind kind = effective_kind(input.contact, pair.surface_energy);
  return contact_laws(kind, input.surface, pair, sphere_surfaces(first, radius1, second, radius2)).reach();
}

/// The largest reach of the scaled system between its spheres.
double scaled_reach(const Input& input) {
  const ScalingLaw& law = law_of(input);
  const double factor = input.scaling_factor, length = law.direct_force ? std::pow(factor, law.overlap) : 1.0;
  const double enlarged = law.direct_force ? 1.0 : size_factor(input);  // a direct-force law is evaluated at the original
  const auto scaled = [&](const Material& m) { return law.direct_force ? m : scaled_material(law, factor, m, input.contact.normal); };
  const Material first = scaled(input.material), second = scaled(input.second);
  const SizeRange range = size_range(input.particles, densities(input));
  const bool two = input.particles.size == SizeKind::bidisperse;
  const double small = enlarged * (two ? input.particles.radius : range.largest), large = enlarged * range.largest;
  double reach = reach_of(input, first, small, first, small);
  if (two) reach = std::max({reach, reach_of(input, first, small, second, large), reach_of(input, second, large, second, large)});
  return reach * length;
}

Spheres original_spheres(const Input& input, std::mt19937_64& stream) {
  const Particles& particles = input.particles;
  if (particles.count > 0) return draw_spheres(particles, densities(input), particles.count, stream);
  return fill_volume(particles, densities(input), particles.volume_fraction * input.cell.size.prod(), stream);
}

/// Fewer and larger ones in the same cell: as many as fill the same share of it, or their number over factor³.
Spheres spheres_in_kept_cell(const Input& input, const Spheres& original, double factor, std::mt19937_64& stream) {
  const double fewer = 1 / (factor * factor * factor);
  if (input.particles.count > 0) {
    const auto count = static_cast<std::size_t>(std::llround(static_cast<double>(original.radius.size()) * fewer));
    return draw_spheres(input.particles, densities(input), count, stream);
  }
  return fill_volume(input.particles, densities(input), original.solids() * fewer, stream);
}

void check_drawn(const Flow& flow, double reach) {
  if (flow.radius.size() < 2)
    throw InputError(fmt::format("particles.count: the flow comes to {} spheres; allowed: at least 2", flow.radius.size()));
  const double largest = *std::max_element(flow.radius.begin(), flow.radius.end());
  for (int axis = 0; axis < 3; ++axis) {
    const double least = flow.cell.periodic(axis) ? least_periodic_edge(largest, reach) : flow.cell.walled(axis) ? 2 * largest : 0.0;
    if (flow.cell.size[axis] < least) {
      throw InputError(
          fmt::format("cell.size: the largest sphere that was drawn has a radius of {:g} m, for which the cell of {:g} m along {} "
                      "is too small; allowed: at least {:g} m, or a smaller particles.size_spread",
                      largest, flow.cell.size[axis], "xyz"[axis], least));
    }
  }
}

}  // namespace

double least_periodic_edge(double largest_radius, double reach) { return 4 * largest_radius + reach; }

FlowPlan plan_flow(const Input& input) {
  const double factor = size_factor(input);
  const SizeRange range = size_range(input.particles, densities(input));
  const double each = sphere_mass(1.0, 1.0) * range.mean_cube;
  FlowPlan plan{.count = static_cast<double>(input.particles.count),
                .size = input.cell.size,
                .volume_fraction = input.particles.volume_fraction,
                .largest = range.largest * factor,
                .reach = scaled_reach(input)};
  if (plan.count == 0) plan.count = plan.volume_fraction * plan.size.prod() / each;
  if (plan.size.isZero(0)) plan.size.setConstant(std::cbrt(plan.count * each / plan.volume_fraction));
  if (plan.volume_fraction == 0) plan.volume_fraction = plan.count * each / plan.size.prod();
  input.keep == Keep::count ? void(plan.size *= factor) : void(plan.count /= factor * factor * factor);
  return plan;
}

Flow scaled_flow(const Input& input, std::uint64_t replica) {
  const double factor = size_factor(input);
  Flow flow{.kind = input.cell.kind,
            .cell = {.boundary = input.cell.boundary, .shear_rate = input.cell.shear_rate, .wall_speed = input.cell.wall_speed},
            .file = input.particles.file,
            .size_factor = factor,
            .gravity = input.cell.gravity,
            .speed = input.particles.speed,
            .wall_no_slip = input.cell.wall_no_slip};
  if (!flow.file.empty()) return flow;
  std::mt19937_64 stream = random_stream(input.run.seed, sizes_purpose, replica);
  Spheres spheres = original_spheres(input, stream);
  flow.cell.size = input.cell.size;
  if (flow.cell.size.isZero(0)) flow.cell.size.setConstant(std::cbrt(spheres.solids() / input.particles.volume_fraction));
  if (input.keep == Keep::count) {
    flow.cell.size *= factor;
  } else if (factor > 1) {
    stream = random_stream(input.run.seed, sizes_purpose, replica);
    spheres = spheres_in_kept_cell(input, spheres, factor, stream);
  }
  for (double& radius : spheres.radius) radius *= factor;
  flow.volume_fraction = spheres.solids() / flow.cell.volume();
  for (std::size_t i = 0; i < spheres.radius.size(); ++i)
    flow.mass.push_back(sphere_mass(spheres.radius[i], spheres.material[i] == 0 ? input.material.density : input.second.density));
  flow.radius = std::move(spheres.radius);
  flow.material = std::move(spheres.material);
  check_drawn(flow, scaled_reach(input));
  return flow;
}

double mean_shear_rate(const CellInput& input, double height) {
  return input.shear_rate != 0 ? input.shear_rate : input.wall_speed == 0 ? 0 : 2 * input.wall_speed / height;
}

RunTimes run_times(const Input& input, const Cell& cell) {
  const double rate = mean_shear_rate(input.cell, cell.size.z());
  const auto time = [&](double duration, double strain) { return strain > 0 ? strain / rate : duration; };
  const double duration = time(input.run.duration, input.run.strain);
  return {.warmup = time(input.run.warmup_duration, input.run.warmup_strain),
          .duration = duration,
          .interval = input.output.interval > 0 ? input.output.interval : duration / default_rows};
}

}  // namespace scalebreak

#include <scalebreak/ensembles/engine/flow_start.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/particle_files/read_particles.hpp>
#include <scalebreak/scene/flow_scene.hpp>
#include <scalebreak/start/check_overlap.hpp>
#include <scalebreak/start/filling.hpp>
#include <scalebreak/start/touching_contacts.hpp>

namespace scalebreak {
namespace {

constexpr double same_mass = 1e-6;  ///< relative: a file may have fewer digits

/// Homogeneous shear, or the linear profile between moving walls.
Eigen::Vector3d flow_at_start(const Cell& cell, double height) {
  return mean_flow(cell, height) + Eigen::Vector3d(cell.wall_speed * (2 * height / cell.size.z() - 1), 0, 0);
}

double root_mean_square_speed(const System& system) {
  double sum = 0;
  for (std::size_t i = 0; i < system.count(); ++i)
    sum += (system.velocity[i] - flow_at_start(system.cell, system.position[i].z())).squaredNorm();
  return std::sqrt(sum / static_cast<double>(system.count()));
}

/// Masses by the material; how many of a file's differ from them.
std::size_t set_masses(System& system, const Input& input) {
  const std::vector<double> given = std::move(system.mass);
  system.mass.clear();
  std::size_t differ = 0;
  for (std::size_t i = 0; i < system.count(); ++i) {
    system.mass.push_back(sphere_mass(system.radius[i], system.material[i] == 0 ? input.material.density : input.second.density));
    if (!given.empty() && std::abs(given[i] - system.mass[i]) > same_mass * system.mass[i]) ++differ;
  }
  return differ;
}

void put_into_cell(System& system, const Flow& flow) {
  const Cell from_file = system.cell;
  system.cell = flow.cell;
  system.cell.size = from_file.size;
  if (flow.cell.shear_rate != 0) system.cell.shear_offset = from_file.shear_offset;
  for (std::size_t i = 0; i < system.count(); ++i) wrap(system.cell, system.position[i], system.velocity[i]);
}

void enlarge(System& system, double factor) {
  system.cell.size *= factor;
  system.cell.shear_offset *= factor;
  for (std::size_t i = 0; i < system.count(); ++i) {
    system.position[i] *= factor;
    system.radius[i] *= factor;
    system.spin[i] /= factor;
  }
}

FlowStart from_file(const Input& input, const Flow& flow) {
  FlowStart start{.system = read_particles(flow.file), .speed = 0, .warnings = {}};
  System& system = start.system;
  if ((system.cell.size.array() <= 0).any())
    throw InputError(
        fmt::format("particles.file: {} says nothing of the cell; allowed: extended XYZ with a Lattice, or LAMMPS data", flow.file));
  if (system.count() < 2)
    throw InputError(fmt::format("particles.file: {} holds {} sphere; allowed: at least 2", flow.file, system.count()));
  put_into_cell(system, flow);
  check_no_overlap(system, flow.file + ": ");
  system.time = 0;
  if (const std::size_t differ = set_masses(system, input); differ > 0)
    start.warnings.push_back(fmt::format("{} gives {} of {} spheres another mass than their material has: the material's are used",
                                         flow.file, differ, system.count()));
  system.contacts = touching_contacts(system);
  enlarge(system, flow.size_factor);
  (void)set_masses(system, input);
  start.speed = root_mean_square_speed(system);
  return start;
}

}  // namespace

FlowStart flow_start(const Input& input, std::uint64_t replica) {
  Flow flow = scaled_flow(input, replica);
  if (!flow.file.empty()) return from_file(input, flow);
  FlowStart start{.system = fill({.cell = flow.cell,
                                  .radius = std::move(flow.radius),
                                  .material = std::move(flow.material),
                                  .mass = std::move(flow.mass),
                                  .speed = flow.speed,
                                  .seed = input.run.seed,
                                  .replica = replica}),
                  .speed = flow.speed,
                  .warnings = {}};
  System& system = start.system;
  for (std::size_t i = 0; i < system.count(); ++i)  // what `fill` has given already is the homogeneous shear
    system.velocity[i] += flow_at_start(system.cell, system.position[i].z()) - mean_flow(system.cell, system.position[i].z());
  return start;
}

}  // namespace scalebreak

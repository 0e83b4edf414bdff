#include "peer_scene.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/particle_files/read_particles.hpp>

namespace scalebreak::peers {
namespace {

constexpr PeerScene scenes[] = {
    {"S1", 1e8, false, false, 500, 1000, 0.5}, {"S2", 1e8, true, false, 500, 1000, 0.5}, {"S3", 1e8, false, false, 500, 1000, 0.1},
    {"S4", 1e7, false, true, 500, 500, 0.52},  {"S5", 1e7, true, true, 500, 500, 0.52},
};

}  // namespace

const PeerScene& peer_scene(const std::string& name) {
  const auto* found = std::find_if(std::begin(scenes), std::end(scenes), [&](const PeerScene& scene) { return scene.name == name; });
  if (found == std::end(scenes)) throw InputError(fmt::format("scene: found {}; allowed: S1, S2, S3, S4 or S5", name));
  return *found;
}

DemSetup peer_setup(const PeerScene& scene, double restitution, bool full) {
  DemSetup setup;
  setup.contact = {.normal = scene.adhesive ? NormalModel::jkr : NormalModel::hertz,
                   .range = full ? AdhesionRange::full : AdhesionRange::pull_off,
                   .damping_on = DampingOn::contact_radius};
  setup.surface.tangential = TangentialModel::mindlin;
  setup.material = {.young = scene.young,
                    .poisson = 0.25,
                    .density = density,
                    .restitution = restitution,
                    .sliding_friction = 0.3,
                    .surface_energy = scene.adhesive ? 0.02 : 0.0,
                    .rolling_friction = 0.05,
                    .rolling_angle_max = 0.01,
                    .rolling_spring_constant = 100,
                    .rolling_dashpot = 1e-4};
  setup.second = setup.wall.material = setup.material;
  setup.wall.attraction = false;
  setup.wall.material.rolling_friction = setup.wall.material.rolling_angle_max = 0;
  if (scene.adhesive) setup.surface.rolling = full ? RollingModel::ar : RollingModel::sds;
  if (scene.bed) setup.gravity = {0, 0, -9.81};
  setup.step = rayleigh_fraction * rayleigh_step(setup, radius);
  return setup;
}

System peer_state(const std::string& file, bool bed) {
  System state = read_particles(file);
  if (bed) state.cell.boundary[2] = Boundary::wall;
  return state;
}

System tiled(const System& state, const Eigen::Vector3i& copies) {
  System all;
  all.time = state.time;
  all.cell = state.cell;
  all.cell.size = state.cell.size.cwiseProduct(copies.cast<double>());
  for (int x = 0; x < copies.x(); ++x) {
    for (int y = 0; y < copies.y(); ++y) {
      for (int z = 0; z < copies.z(); ++z) {
        const Eigen::Vector3d shift = state.cell.size.cwiseProduct(Eigen::Vector3d(x, y, z));
        all.radius.insert(all.radius.end(), state.radius.begin(), state.radius.end());
        all.mass.insert(all.mass.end(), state.mass.begin(), state.mass.end());
        all.material.insert(all.material.end(), state.material.begin(), state.material.end());
        all.velocity.insert(all.velocity.end(), state.velocity.begin(), state.velocity.end());
        all.spin.insert(all.spin.end(), state.spin.begin(), state.spin.end());
        for (const Eigen::Vector3d& position : state.position) all.position.emplace_back(position + shift);
      }
    }
  }
  return all;
}

}  // namespace scalebreak::peers

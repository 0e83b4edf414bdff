#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <scalebreak/base/error.hpp>
#include <scalebreak/material/pair.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/particle_files/lammps_data.hpp>
#include <scalebreak/start/filling.hpp>

#include "peer_scene.hpp"

// Writes the filling that a scene starts from as a LAMMPS data file: a periodic cube, or a column over a floor that settles to a bed.

int main(int argc, char** argv) {
  using namespace scalebreak;
  CLI::App app("A start state of the comparison with other engines");
  std::string scene_name = "S1", file;
  std::size_t count = 20000;
  double speed = 0.1, volume_fraction = 0;
  std::uint64_t seed = 1;
  app.add_option("scene", scene_name, "S1 to S5")->required();
  app.add_option("file", file, "LAMMPS data file that is written, ending in .data")->required();
  app.add_option("--count", count, "spheres");
  app.add_option("--volume-fraction", volume_fraction, "in place of the scene's");
  app.add_option("--speed", speed, "root mean square at the start; a bed starts at rest [m/s]");
  app.add_option("--seed", seed);
  CLI11_PARSE(app, argc, argv);
  try {
    const peers::PeerScene& scene = peers::peer_scene(scene_name);
    if (volume_fraction == 0) volume_fraction = scene.volume_fraction;
    Filling filling{.radius = std::vector<double>(count, peers::radius),
                    .material = std::vector<std::uint8_t>(count, 0),
                    .mass = std::vector<double>(count, sphere_mass(peers::radius, peers::density)),
                    .speed = scene.bed ? 0 : speed,
                    .seed = seed};
    const double diameter = 2 * peers::radius,
                 volume = static_cast<double>(count) * std::acos(-1) / 6 * std::pow(diameter, 3) / volume_fraction;
    const double cube = std::cbrt(volume);
    if (scene.bed) {  // 25 diameters wide with 20 000 spheres
      const double width = 0.78 * cube;
      filling.cell.size = {width, width, volume / (width * width)};
      filling.cell.boundary[2] = Boundary::wall;
    } else {
      filling.cell.size = {cube, cube, cube};
    }
    System state = fill(filling);
    if (scene.bed) state.cell.size.z() += 2 * diameter;  // LAMMPS loses what leaves its box
    write_file(file, lammps_data(state));
  } catch (const InputError& error) {
    fmt::print(stderr, "scalebreak_peer_state: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "scalebreak_peer_state: {}\n", error.what());
    return 1;
  }
}

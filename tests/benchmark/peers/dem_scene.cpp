#include <chrono>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <scalebreak/base/error.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/particle_files/lammps_data.hpp>

#include "peer_scene.hpp"

// Runs a scene S1 to S5 from a LAMMPS data file with this project's engine, and prints one line of what it took.

namespace {

using namespace scalebreak;

/// Contacts per sphere as LAMMPS counts them: of spheres that overlap, without stretched necks and the floor.
double contacts_per_sphere(const Dem& dem) {
  double ends = 0;
  for (const ContactForce& contact : dem.contact_forces()) {
    if (contact.second >= 0 && contact.branch.norm() < 2 * peers::radius) ends += 2;
  }
  return ends / static_cast<double>(dem.count());
}

struct Options {
  std::string scene, state, kernel, save;
  int threads = 1;
  long warm_up = -1, timed = -1;
  std::vector<int> copies = {1, 1, 1};
  bool full = false;
};

void run(const Options& options) {
  const peers::PeerScene& scene = peers::peer_scene(options.scene);
  DemSetup setup = peers::peer_setup(scene, 0.81, options.full);
  setup.threads = options.threads;
  if (!options.kernel.empty()) setup.kernel = options.kernel.c_str();
  const Eigen::Vector3i copies(options.copies[0], options.copies[1], options.copies[2]);
  Dem dem(peers::tiled(peers::peer_state(options.state, scene.bed), copies), setup);
  dem.keep_sums(false);
  dem.advance(options.warm_up < 0 ? scene.warm_up : options.warm_up);
  if (!options.save.empty()) {
    write_file(options.save, lammps_data(dem.system()));
    return;
  }

  const double contacts_before = contacts_per_sphere(dem);
  const DemTotals before = dem.totals();
  const long steps = options.timed < 0 ? scene.timed : options.timed;
  const auto start = std::chrono::steady_clock::now();
  dem.advance(steps);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  const double count = static_cast<double>(dem.count()), bytes = static_cast<double>(dem.bytes());
  const DemTotals& after = dem.totals();
  const double lists = after.lists_made - before.lists_made, all_lists = after.lists_made;
  fmt::print(
      "scene={}{} threads={} kernel={} spheres={} steps={} seconds={:.4g} particle_steps_per_second={:.5g} contacts_before={:.4f} "
      "contacts_after={:.4f} bytes_per_sphere={:.1f} neighbours_per_sphere={:.2f} bytes_per_neighbour={:.1f} "
      "lists={:.0f} grids={:.0f}\n",
      scene.name, options.full ? "full" : "", options.threads, dem.kernel_name(), dem.count(), steps, seconds,
      count * static_cast<double>(steps) / seconds, contacts_before, contacts_per_sphere(dem), bytes / count,
      after.pairs_tested / all_lists / count, bytes / (after.pairs_tested / all_lists), lists, after.grids_made - before.grids_made);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("A scene of the comparison with other engines, run by this one");
  Options options;
  app.add_option("scene", options.scene, "S1 to S5")->required();
  app.add_option("state", options.state, "LAMMPS data file")->required();
  app.add_option("--threads", options.threads);
  app.add_option("--kernel", options.kernel, "baseline, avx2 or avx512; else the best of this processor");
  app.add_option("--warm-up", options.warm_up, "steps before the timed ones, in place of the scene's");
  app.add_option("--steps", options.timed, "timed steps, in place of the scene's");
  app.add_option("--save", options.save, "LAMMPS data file of the state after the warm-up, where the program then ends");
  app.add_option("--copies", options.copies, "of the state along x, y and z")->expected(3);
  app.add_flag("--full", options.full, "of S2 and S5: JKR to its tear-off fold and adhesive rolling");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const InputError& error) {
    fmt::print(stderr, "scalebreak_peer_scene: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "scalebreak_peer_scene: {}\n", error.what());
    return 1;
  }
}

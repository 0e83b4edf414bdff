#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <scalebreak/base/error.hpp>

#include "flow_comparison.hpp"

// Flows that LAMMPS has run (decks/lammps_flow.in) are run again by this project's engine, from the same states, and compared.

int main(int argc, char** argv) {
  using namespace scalebreak;
  CLI::App app("Comparison of flows with LAMMPS, from its states and series");
  app.require_subcommand(1);
  peers::Runs runs;
  double rate = 40;
  const auto add = [&](const char* name, const char* what) {
    CLI::App* const command = app.add_subcommand(name, what);
    command->add_option("--states", runs.states, "LAMMPS data files")->required();
    command->add_option("--series", runs.series, "what lammps_flow.in wrote, one for each state")->required();
    command->add_option("--restitution", runs.restitution);
    command->add_option("--threads", runs.threads);
    return command;
  };
  CLI::App* const sheared = add("shear", "homogeneous shear: means over the time of the series");
  sheared->add_option("--rate", rate, "shear rate [1/s]");
  add("cooling", "a gas that cools, at the steps of the series");
  CLI11_PARSE(app, argc, argv);
  try {
    fmt::print("{}", sheared->parsed() ? peers::compare_shear(runs, rate) : peers::compare_cooling(runs));
  } catch (const InputError& error) {
    fmt::print(stderr, "scalebreak_peer_flow: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "scalebreak_peer_flow: {}\n", error.what());
    return 1;
  }
}

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <scalebreak/base/error.hpp>

#include "flow_comparison.hpp"

// Flows that LAMMPS has run (decks/lammps_flow.in) are run again by this project's engine, from the same states, and compared.

int main(int argc, char** argv) {
  using namespace scalebreak;
  CLI::App app("Comparison of flows with LAMMPS, from its states and series");
  app.require_subcommand(1);
  peers::ShearRun shear;
  CLI::App* const sheared = app.add_subcommand("shear", "homogeneous shear: steady means with their standard errors");
  sheared->add_option("state", shear.state, "LAMMPS data file")->required();
  sheared->add_option("series", shear.series, "what lammps_flow.in wrote, from the end of the warm-up on")->required();
  sheared->add_option("--rate", shear.rate, "shear rate [1/s]");
  sheared->add_option("--restitution", shear.restitution);
  sheared->add_option("--warm-up", shear.warm_up, "steps before the series");
  sheared->add_option("--steps", shear.steps, "steps of the series");
  sheared->add_option("--every", shear.every, "steps from sample to sample");
  sheared->add_option("--threads", shear.threads);
  peers::CoolingRun cooling;
  CLI::App* const cooled = app.add_subcommand("cooling", "a gas that cools from several states, compared state by state");
  cooled->add_option("--states", cooling.states, "LAMMPS data files")->required();
  cooled->add_option("--series", cooling.series, "what lammps_flow.in wrote, one for each state")->required();
  cooled->add_option("--restitution", cooling.restitution);
  cooled->add_option("--threads", cooling.threads);
  CLI11_PARSE(app, argc, argv);
  try {
    fmt::print("{}", sheared->parsed() ? peers::compare_shear(shear) : peers::compare_cooling(cooling));
  } catch (const InputError& error) {
    fmt::print(stderr, "scalebreak_peer_flow: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "scalebreak_peer_flow: {}\n", error.what());
    return 1;
  }
}

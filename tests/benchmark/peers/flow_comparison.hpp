#pragma once

#include <string>
#include <vector>

namespace scalebreak::peers {

struct ShearRun {
  std::string state, series;  ///< files: of LAMMPS, data and series
  double rate = 40;           ///< [1/s]
  double restitution = 0.81;
  long warm_up = 100000, steps = 300000, every = 100;
  int threads = 1;
};

/// Runs the flow of a state with this engine and sets its means beside those of LAMMPS' series: a Markdown table.
/// Throws InputError where a file cannot be read, or the series is of another length.
[[nodiscard]] std::string compare_shear(const ShearRun& run);

struct CoolingRun {
  std::vector<std::string> states, series;  ///< files, one series for each state
  double restitution = 0.81;
  int threads = 1;
};

/// Runs every state to the steps of its series. Each row compares the means over states; the error is that of the mean difference
/// between the two runs of one state.
[[nodiscard]] std::string compare_cooling(const CoolingRun& run);

}  // namespace scalebreak::peers

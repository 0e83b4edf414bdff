#pragma once

#include <string>
#include <vector>

namespace scalebreak::peers {

/// The same flow from several states, run by LAMMPS and by this engine.
struct Runs {
  std::vector<std::string> states, series;  ///< files of LAMMPS: data, and one series for each state, as long as each other
  double restitution = 0.81;
  int threads = 1;
};

/// Homogeneous shear, means over the time of the series, whose rows are evenly spaced. A Markdown table of the means over states; the
/// error of a difference is that of the mean difference between the two runs of one state. Throws InputError where a file cannot be
/// read, or there are fewer than 3 states.
[[nodiscard]] std::string compare_shear(const Runs& runs, double rate);

/// A gas that cools, at the steps of the series. The same table.
[[nodiscard]] std::string compare_cooling(const Runs& runs);

}  // namespace scalebreak::peers

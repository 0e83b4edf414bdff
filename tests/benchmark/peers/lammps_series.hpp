#pragma once

#include <string>
#include <vector>

namespace scalebreak::peers {

/// A row of the series that decks/lammps_flow.in writes.
struct SeriesRow {
  long step;
  double temperature;        ///< [m²/s²]
  double rotational_energy;  ///< per sphere [J]
  double coordination;
  double contact_pressure;   ///< [Pa]
  double contact_stress_xz;  ///< x of the branch, z of the force [Pa]
};

/// Throws InputError with file and line.
[[nodiscard]] std::vector<SeriesRow> read_series(const std::string& file);

}  // namespace scalebreak::peers

#pragma once

namespace scalebreak {

/// What is asked of advice on scaling laws. A number of 0 is the scene's.
struct AdviseInput {
  double tolerance = 0.05;     ///< relative, on every quantity that a law is judged by
  double speed = 0;            ///< root mean square about the mean flow [m/s]; 0: by kinetic theory in shear, else of the start
  double shear_rate = 0;       ///< [1/s]
  double volume_fraction = 0;  ///< solids over the cell
  double pressure = 0;         ///< that holds the flow together [Pa]
  double size = 0;             ///< radius of the spheres [m]

  bool operator==(const AdviseInput&) const = default;
};

}  // namespace scalebreak

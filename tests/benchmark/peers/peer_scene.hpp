#pragma once

#include <string>

#include <scalebreak/dem/dem.hpp>

namespace scalebreak::peers {

/// A scene of the comparison with other engines: glass spheres of 1 mm as decks/lammps_laws.in has them.
struct PeerScene {
  const char* name;
  double young;                ///< [Pa]
  bool adhesive;               ///< JKR and rolling resistance
  bool bed;                    ///< a floor at z = 0, and gravity
  long warm_up, timed;         ///< steps
  double volume_fraction = 0;  ///< of its filling
};

/// S1 to S5. Throws InputError for another name.
[[nodiscard]] const PeerScene& peer_scene(const std::string& name);

inline constexpr double radius = 0.5e-3;           ///< of every sphere [m]
inline constexpr double density = 2500;            ///< [kg/m³]
inline constexpr double rayleigh_fraction = 0.15;  ///< the step over the Rayleigh step

/// What the LAMMPS decks do, in this engine's words. Adhesion ends at the force minimum with `sds` rolling, as in LAMMPS, or with `full`
/// at the tear-off fold with adhesive rolling. The floor has neither adhesion nor rolling resistance.
[[nodiscard]] DemSetup peer_setup(const PeerScene& scene, double restitution, bool full);

/// A LAMMPS data file as the cell of a scene: periodic, of a bed with a floor and with a lid far above.
[[nodiscard]] System peer_state(const std::string& file, bool bed);

/// Copies of a state beside each other along x, y and z, as LAMMPS' `replicate`.
[[nodiscard]] System tiled(const System& state, const Eigen::Vector3i& copies);

}  // namespace scalebreak::peers

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/boundary.hpp>

namespace scalebreak {

/// What a flow is: homogeneous shear across images, shear between moving walls, a gas that cools, whatever the boundaries say,
/// homogeneous shear at a height that follows a pressure. The words are in the order of the enumeration, here and below.
enum class CellKind { shear, couette, cooling, box, confined_shear };
inline constexpr const char* cell_kind_words[] = {"shear", "couette", "cooling", "box", "confined_shear"};

inline constexpr const char* boundary_words[] = {"open", "periodic", "wall"};

/// How the sizes of the spheres are distributed, by number (see sphere_sizes.hpp).
enum class SizeKind { mono, bidisperse, gaussian, lognormal };
inline constexpr const char* size_kind_words[] = {"mono", "bidisperse", "gaussian", "lognormal"};

/// What a law that enlarges the spheres by l leaves as it was: their number, in a cell larger by l, or the cell, with l³ times fewer.
enum class Keep { count, cell };
inline constexpr const char* keep_words[] = {"count", "cell"};

/// How a soft-sphere step takes velocities: with velocity Verlet's lagged one, or one brought up to the time of the forces.
enum class Integrator { verlet, synchronized };
inline constexpr const char* integrator_words[] = {"verlet", "synchronized"};

/// The formats of particle files: CSV, VTK XML for ParaView, extended XYZ and LAMMPS dump for OVITO.
enum class ParticleFormat { csv, vtp, xyz, dump };
inline constexpr const char* particle_format_words[] = {"csv", "vtp", "xyz", "dump"};

/// What particle files hold beside identity and position.
enum class ParticleField { radius, material, velocity, spin, mass };
inline constexpr const char* particle_field_words[] = {"radius", "material", "velocity", "spin", "mass"};
using ParticleFields = std::vector<ParticleField>;
inline const ParticleFields all_particle_fields = {ParticleField::radius, ParticleField::material, ParticleField::velocity,
                                                   ParticleField::spin, ParticleField::mass};

/// The spheres of a flow, SI. The defaults are glass spheres of Washino et al. 2024, section 5.1, all of the mean size.
struct Particles {
  std::uint64_t count = 2000;    ///< 0: follows from volume_fraction and the cell's size, or from the file
  double radius = 0.5e-3;        ///< the mean one; of the small ones if bidisperse [m]
  double volume_fraction = 0.3;  ///< solids over the cell; 0: follows from count and the cell's size, or from the file
  SizeKind size = SizeKind::mono;
  double size_spread = 0;          ///< standard deviation over mean of the radius, before a Gaussian is cut
  double large_radius = 0;         ///< of a bidisperse scene, of [second] [m]
  double large_mass_fraction = 0;  ///< mass of the large ones over that of all
  double speed = 0.1;              ///< root of the mean squared velocity about the mean flow at the start [m/s]
  std::string file;                ///< a particle file to start from; empty: none

  bool operator==(const Particles&) const = default;
};

/// The place of a flow, SI.
struct CellInput {
  CellKind kind = CellKind::shear;
  Eigen::Vector3d size{0, 0, 0};  ///< [m]; 0: a cube that follows from count and volume_fraction, or the file's
  std::array<Boundary, 3> boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  double shear_rate = 40;     ///< of `shear` and `confined_shear`: Washino et al. 2024, section 5, ± 2 m/s over 0.1 m [1/s]; 0 elsewhere
  double wall_speed = 0;      ///< each z wall moves at ± this along x [m/s]
  bool wall_no_slip = false;  ///< a sphere loses its spin when it touches a wall (Washino et al. 2024, section 5)
  double pressure = 0;        ///< normal stress P_zz of `confined_shear`, unscaled [Pa]; 0 elsewhere
  Eigen::Vector3d gravity{0, 0, 0};  ///< [m/s²]

  bool operator==(const CellInput&) const = default;
};

/// How a run goes. Beside [[body]] only `duration` holds, and 0 means until they have parted for good, or rest in contact.
struct RunInput {
  double duration = 0;         ///< that is measured [s]; 0: strain holds
  double strain = 0;           ///< the same over 1/(shear rate)
  double warmup_duration = 0;  ///< before it [s]; 0: warmup_strain holds
  double warmup_strain = 0;
  std::uint64_t seed = 1;
  double step_fraction = 0.15;  ///< of the Rayleigh time: see docs/default_step.md
  bool step_bounds = true;      ///< is the step kept within the bounds of dem/critical_step.hpp?
  std::uint64_t replicas = 1;   ///< runs that differ by their random numbers alone
  Integrator integrator = Integrator::synchronized;

  bool operator==(const RunInput&) const = default;
};

/// What a flow writes.
struct OutputInput {
  double interval = 0;  ///< between rows of the series and particle files [s]; 0: about 200 over the run
  ParticleFields fields = all_particle_fields;
  std::vector<ParticleFormat> formats;
  double checkpoint_interval = 60;  ///< of wall time [s]; 0: none

  bool operator==(const OutputInput&) const = default;
};

}  // namespace scalebreak

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// What the numbers of a flow come to in the SCALED system, by the mean sizes: nothing is drawn. Not of a flow that starts from a
/// file, which says all this itself.
struct FlowPlan {
  double count = 0;               ///< of spheres
  Eigen::Vector3d size{0, 0, 0};  ///< of the cell [m]
  double volume_fraction = 0;     ///< solids over the cell
  double largest = 0;             ///< radius that is expected, of a log-normal distribution three σ above the mean [m]
  double reach = 0;               ///< how far apart the surfaces of two such spheres can still act on each other [m]
};
[[nodiscard]] FlowPlan plan_flow(const Input& input);

/// The least edge of a cell along a periodic axis, so that a sphere meets each neighbour once: two diameters and the reach [m].
[[nodiscard]] double least_periodic_edge(double largest_radius, double reach);

/// A flow of the SCALED system, resolved, SI. Speeds, the shear rate, the strain and the acceleration of gravity are the original's.
struct Flow {
  CellKind kind = CellKind::shear;
  Cell cell;
  std::vector<double> radius;          ///< in the order of identity [m]
  std::vector<double> mass;            ///< [kg]
  std::vector<std::uint8_t> material;  ///< 0: of [material], 1: of [second]
  /// A particle file to start from, or empty. Then the lists and the cell's size are empty: the file has them, those of the original.
  std::string file;
  double size_factor = 1;            ///< what multiplies the radii, the places and the cell of a file, and divides its spins
  double volume_fraction = 0;        ///< solids over the cell
  Eigen::Vector3d gravity{0, 0, 0};  ///< acceleration: the force on a sphere is its mass times this [m/s²]
  double speed = 0;                  ///< root of the mean squared velocity about the mean flow at the start; spins start at 0 [m/s]
  bool wall_no_slip = false;
};

/// Completes the third of count, volume fraction and cell, draws the sizes and applies the scaling law: `keep = count` keeps their
/// number in a cell `factor` times larger, `keep = cell` the cell with a factor³-th of the number. The sizes are a function of the
/// input, its seed and the replica. Throws InputError where what was drawn does not fit.
[[nodiscard]] Flow scaled_flow(const Input& input, std::uint64_t replica = 0);

/// The rate at which a flow of the input is sheared in a cell: shear_rate, or that between its moving walls [1/s].
[[nodiscard]] double mean_shear_rate(const CellInput& input, double height);

/// The times of a run in a cell of the scaled system [s].
struct RunTimes {
  double warmup, duration, interval;
};
[[nodiscard]] RunTimes run_times(const Input& input, const Cell& cell);

}  // namespace scalebreak

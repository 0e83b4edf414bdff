#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// Spheres on their way to a filling: centres and radii in a cell [m].
struct Packing {
  Cell cell;
  std::vector<Eigen::Vector3d> position;
  std::vector<double> radius;
};

/// The neighbours of every sphere in a packing whose centres stay inside the faces of the cell: who may come nearer than
/// scale × (sum of radii) before one of them has moved by half the skin [m]. Wraps the packing's positions as it is made.
class PackingNeighbours {
 public:
  struct Neighbour {
    std::uint32_t sphere : 26;
    std::uint32_t image : 6;
  };
  static constexpr std::size_t most_spheres = std::size_t{1} << 26;

  PackingNeighbours(Packing& packing, double scale, double skin);

  [[nodiscard]] std::span<const Neighbour> of(std::size_t i) const { return {neighbour_.data() + start_[i], start_[i + 1] - start_[i]}; }
  /// From a neighbour to a centre. In a cell of less than two reaches, where another image may have become the nearer one, it is sought.
  [[nodiscard]] Eigen::Vector3d away(const Packing& packing, const Eigen::Vector3d& centre, const Neighbour& neighbour) const {
    const Eigen::Vector3d difference = centre - packing.position[neighbour.sphere];
    if (narrow_) return nearest_image(packing.cell, difference);
    return difference + shift_[neighbour.image];
  }
  /// Has a sphere gone so far that the list may miss a neighbour?
  [[nodiscard]] bool outrun(const Packing& packing, std::size_t i) const {
    return (packing.position[i] - made_at_[i]).squaredNorm() > farthest_squared_;
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<Neighbour> neighbour_;
  std::vector<Eigen::Vector3d> shift_, made_at_;
  double farthest_squared_;
  bool narrow_ = false;
};

/// How a relaxation ended.
struct Relaxed {
  double scale = 0;  ///< by which all radii could be multiplied without an overlap
  int steps = 0;
};

/// Moves spheres apart that are nearer than `soft` × (sum of radii) to each other, or soft × radius to a face that is not periodic:
/// down the energy of linear springs, by FIRE (Guénolé et al., Comput. Mater. Sci. 175 (2020) 109584), until none is nearer than
/// `wanted` (below `soft`) of that, or the steps are used up.
[[nodiscard]] Relaxed relax(Packing& packing, double soft, double wanted, int most_steps);

/// Metropolis sweeps of hard spheres, one trial move each by up to `step` [m] along each axis, which never bring two spheres nearer
/// than scale × (sum of radii): so the packing forgets how it was made. It must be as far apart when it comes.
void shake(Packing& packing, double scale, double step, int sweeps, std::mt19937_64& random);

/// Evenly from 0 to 1 (not reached), the same on every platform.
[[nodiscard]] inline double even_random(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

}  // namespace scalebreak

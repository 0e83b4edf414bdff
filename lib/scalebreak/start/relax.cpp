#include <scalebreak/start/packing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scalebreak {
namespace {

// FIRE's numbers, as Guénolé et al. give them. Time is in units in which the springs have stiffness 1 and the smallest sphere mass 1.
constexpr double least_mixing = 0.25, less_mixing = 0.99, faster = 1.1, slower = 0.5, first_step = 0.1, longest_step = 0.35;
constexpr int patience = 20;

/// Forces of all springs, and the scale at which the nearest pair (or sphere and face) touches.
class Springs {
 public:
  Springs(Packing& packing, double soft) : packing_(packing), soft_(soft), force_(packing.position.size()) {
    smallest_ = *std::min_element(packing.radius.begin(), packing.radius.end());
    skin_ = 0.6 * smallest_;
    neighbours_.emplace_back(packing, soft, skin_);
  }

  [[nodiscard]] double smallest() const { return smallest_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& force() const { return force_; }

  void follow() {
    for (std::size_t i = 0; i < force_.size(); ++i) {
      if (!neighbours_.front().outrun(packing_, i)) continue;
      neighbours_.front() = PackingNeighbours(packing_, soft_, skin_);
      return;
    }
  }

  double evaluate() {
    double scale = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < force_.size(); ++i) {
      force_[i].setZero();
      scale = std::min({scale, push_from_spheres(i), push_from_faces(i)});
    }
    return scale;
  }

 private:
  double push_from_spheres(std::size_t i) {
    const PackingNeighbours& list = neighbours_.front();
    double scale = std::numeric_limits<double>::infinity();
    for (const auto neighbour : list.of(i)) {
      const std::size_t j = neighbour.sphere;
      const double touch = packing_.radius[i] + packing_.radius[j];
      const Eigen::Vector3d away = list.away(packing_, packing_.position[i], neighbour);
      const double squared = away.squaredNorm();
      if (squared >= soft_ * soft_ * touch * touch) continue;
      const double distance = std::sqrt(squared);
      scale = std::min(scale, distance / touch);
      if (distance > 0)
        force_[i] += (soft_ * touch / distance - 1) * away;
      else
        force_[i].x() += i < j ? soft_ * touch : -soft_ * touch;
    }
    return scale;
  }

  double push_from_faces(std::size_t i) {
    double scale = std::numeric_limits<double>::infinity();
    const double radius = packing_.radius[i];
    for (int axis = 0; axis < 3; ++axis) {
      if (packing_.cell.periodic(axis)) continue;
      const double below = packing_.position[i][axis], above = packing_.cell.size[axis] - below;
      force_[i][axis] += std::max(soft_ * radius - below, 0.0) - std::max(soft_ * radius - above, 0.0);
      scale = std::min({scale, below / radius, above / radius});
    }
    return scale;
  }

  Packing& packing_;
  double soft_, smallest_ = 0, skin_ = 0;
  std::vector<PackingNeighbours> neighbours_;  ///< one list
  std::vector<Eigen::Vector3d> force_;
};

}  // namespace

Relaxed relax(Packing& packing, double soft, double wanted, int most_steps) {
  Springs springs(packing, soft);
  const std::size_t count = packing.position.size();
  std::vector<Eigen::Vector3d> velocity(count, Eigen::Vector3d::Zero());
  std::vector<double> mass(count);  // of the sphere's volume: large spheres have many springs
  for (std::size_t i = 0; i < count; ++i) mass[i] = std::pow(packing.radius[i] / springs.smallest(), 3);
  double step = first_step, mixing = least_mixing, scale = springs.evaluate();
  int downhill = 0, steps = 0;
  for (; scale < wanted && steps < most_steps; ++steps) {
    double power = 0;
    for (std::size_t i = 0; i < count; ++i) power += springs.force()[i].dot(velocity[i]);
    if (power > 0) {
      if (++downhill > patience) {
        step = std::min(step * faster, longest_step);
        mixing *= less_mixing;
      }
    } else {
      for (std::size_t i = 0; i < count; ++i) packing.position[i] -= step / 2 * velocity[i];
      std::fill(velocity.begin(), velocity.end(), Eigen::Vector3d::Zero());
      downhill = 0;
      step = std::max(step * slower, first_step / 10);
      mixing = least_mixing;
    }
    double speed_squared = 0, pull_squared = 0;
    for (std::size_t i = 0; i < count; ++i) {
      velocity[i] += step / mass[i] * springs.force()[i];
      speed_squared += velocity[i].squaredNorm();
      pull_squared += (springs.force()[i] / mass[i]).squaredNorm();
    }
    const double along = pull_squared > 0 ? mixing * std::sqrt(speed_squared / pull_squared) : 0;
    for (std::size_t i = 0; i < count; ++i) {
      velocity[i] = (1 - mixing) * velocity[i] + along / mass[i] * springs.force()[i];
      packing.position[i] += step * velocity[i];
    }
    springs.follow();
    scale = springs.evaluate();
  }
  return {scale, steps};
}

}  // namespace scalebreak

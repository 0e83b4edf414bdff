#include <scalebreak/cell/cell.hpp>

#include <cmath>

namespace scalebreak {
namespace {

double fraction(double x, double length) {
  const double rest = x - length * std::floor(x / length);
  return rest < length ? rest : 0.0;  // a rounding below zero
}

}  // namespace

Eigen::Vector3d nearest_image(const Cell& cell, Eigen::Vector3d difference) {
  if (cell.periodic(2)) {
    const double crossings = std::nearbyint(difference.z() / cell.size.z());
    difference.z() -= crossings * cell.size.z();
    difference.x() -= crossings * cell.shear_offset;
  }
  for (const int axis : {0, 1}) {
    if (cell.periodic(axis)) difference[axis] -= cell.size[axis] * std::nearbyint(difference[axis] / cell.size[axis]);
  }
  return difference;
}

Eigen::Vector3d image_velocity(const Cell& cell, const Eigen::Vector3d& difference) {
  if (!cell.periodic(2) || cell.shear_rate == 0) return Eigen::Vector3d::Zero();
  const double crossings = std::nearbyint(difference.z() / cell.size.z());
  return {-crossings * cell.shear_rate * cell.size.z(), 0, 0};
}

void wrap(const Cell& cell, Eigen::Vector3d& position, Eigen::Vector3d& velocity) {
  if (cell.periodic(2)) {
    const double crossings = std::floor(position.z() / cell.size.z());
    position.z() = fraction(position.z(), cell.size.z());
    position.x() -= crossings * cell.shear_offset;
    velocity.x() -= crossings * cell.shear_rate * cell.size.z();
  }
  for (const int axis : {0, 1}) {
    if (cell.periodic(axis)) position[axis] = fraction(position[axis], cell.size[axis]);
  }
}

Cell advanced(Cell cell, double time) {
  if (cell.shear_rate != 0) cell.shear_offset = fraction(cell.shear_offset + cell.shear_rate * cell.size.z() * time, cell.size.x());
  return cell;
}

Eigen::Vector3d mean_flow(const Cell& cell, double height) { return {cell.shear_rate * (height - cell.size.z() / 2), 0, 0}; }

}  // namespace scalebreak

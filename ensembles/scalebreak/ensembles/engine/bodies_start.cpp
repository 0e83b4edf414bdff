#include <scalebreak/ensembles/engine/bodies_start.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/start/touching_contacts.hpp>

namespace scalebreak {
namespace {

/// Room about the bodies, in radii of the largest.
constexpr double room = 10;

}  // namespace

System bodies_start(const Input& input) {
  const MovingScene scene = moving_scene(input);
  Eigen::AlignedBox<double, 3> box;
  double largest = 0;
  System system;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const MovingBody& body = scene.bodies[i];
    if (body.plane) continue;
    if (!std::isfinite(body.mass))
      throw InputError(fmt::format("body.{} is fixed, and the soft-sphere engine has no fixed spheres; allowed: free bodies", i + 1));
    box.extend(body.position);
    largest = std::max(largest, body.radius);
    system.radius.push_back(body.radius);
    system.mass.push_back(body.mass);
    const bool second = input.bodies.empty() ? i == 1 : input.bodies[i].second;
    system.material.push_back(second ? 1 : 0);
    system.position.push_back(body.position);
    system.velocity.push_back(body.velocity);
    system.spin.push_back(body.spin);
  }
  Eigen::Vector3d corner = box.min() - Eigen::Vector3d::Constant(room * largest);
  system.cell.size = box.sizes() + Eigen::Vector3d::Constant(2 * room * largest);
  system.cell.boundary = {Boundary::open, Boundary::open, Boundary::open};
  if (scene.bodies.back().plane) system.cell.boundary[2] = Boundary::wall, corner.z() = 0;
  for (Eigen::Vector3d& position : system.position) position -= corner;
  system.contacts = touching_contacts(system);
  return system;
}

}  // namespace scalebreak

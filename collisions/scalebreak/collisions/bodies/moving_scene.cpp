#include <scalebreak/collisions/bodies/moving_scene.hpp>

#include <cmath>

namespace scalebreak {
namespace {

MovingBody sphere(const Body& body, const Material& material, double size) {
  MovingBody moving{.position = body.position, .velocity = body.velocity, .spin = body.spin / size, .radius = size * body.radius};
  if (body.fixed) return moving;
  moving.mass = sphere_mass(moving.radius, material.density);
  moving.inertia = 0.4 * moving.mass * moving.radius * moving.radius;
  return moving;
}

/// The two spheres of [pair] and [impact], of the original.
std::vector<Body> bodies_of_pair(const Input& input) {
  const double distance = input.radius[0] + (input.against_wall ? 0.0 : input.radius[1]);
  std::vector<Body> bodies = {{.position = {0, 0, distance},
                               .velocity = {input.tangential_speed, 0, -input.normal_speed},
                               .spin = input.spin1,
                               .radius = input.radius[0]}};
  if (!input.against_wall) bodies.push_back({.spin = input.spin2, .radius = input.radius[1], .second = true});
  return bodies;
}

/// Distances grow about the centre of mass; where something is fixed, about that.
void spread(std::vector<Body>& bodies, const Input& input, double size) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double mass = 0;
  for (const Body& body : bodies) {
    const double own = body.fixed ? 1e300 : sphere_mass(body.radius, input.material_of(body).density);
    mass += own;
    centre += (body.position - centre) * (own / mass);
  }
  for (Body& body : bodies) body.position = centre + size * (body.position - centre);
}

}  // namespace

MovingScene moving_scene(const Input& input, const ScalingLaw& law, double factor) {
  const double size = size_factor(law, factor);
  std::vector<Body> bodies = input.bodies.empty() ? bodies_of_pair(input) : input.bodies;
  const std::vector<Body> original = bodies;
  if (input.bodies.empty()) {
    for (Body& body : bodies) body.position *= size;  // body 2, or the wall, is at the origin
  } else {
    spread(bodies, input, size);
  }
  MovingScene scene;
  for (const Body& body : bodies) scene.bodies.push_back(sphere(body, input.material_of(body), size));
  const bool wall = input.bodies.empty() && input.against_wall;
  if (wall) scene.bodies.push_back({.plane = true});
  for (std::size_t i = 0; i < original.size(); ++i) {
    const Material& first = input.material_of(original[i]);
    if (wall) scene.laws.push_back(mapped_laws(input.contact, input.surface, {first, {}, input.wall, {original[i].radius}}, law, factor));
    for (std::size_t j = i + 1; j < original.size(); ++j) {
      const Bodies pair{first, input.material_of(original[j]), input.wall, {original[i].radius, original[j].radius}};
      scene.laws.push_back(mapped_laws(input.contact, input.surface, pair, law, factor, {original[i].fixed, original[j].fixed}));
    }
  }
  return scene;
}

MovingScene moving_scene(const Input& input) { return moving_scene(input, *find_scaling_law(input.scaling_law), input.scaling_factor); }

}  // namespace scalebreak

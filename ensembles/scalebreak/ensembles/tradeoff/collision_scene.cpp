#include <scalebreak/ensembles/tradeoff/collision_scene.hpp>

#include <algorithm>

#include <scalebreak/base/error.hpp>

namespace scalebreak {

CollisionScene collision_scene(const Input& input) {
  CollisionScene scene{.input = input, .moving = moving_scene(input), .reference = {}, .duration = input.run.duration};
  scene.reference = scene.moving.move({.tolerance = reference_tolerance, .duration = scene.duration});
  if (scene.reference.touches == 0) throw InputError("nothing collides in this scene; allowed: bodies that meet");
  if (scene.duration == 0 && (scene.reference.resting || scene.reference.open_contacts > 0))
    throw InputError("the bodies stick, so that there is no end to compare; allowed: bodies that part, or [[body]] with run.duration");
  const auto& bodies = scene.moving.bodies;
  for (const MovingBody& a : bodies) {
    for (const MovingBody& b : bodies) scene.speed = std::max(scene.speed, (a.velocity - b.velocity).norm());
  }
  return scene;
}

CollisionError collision_error(const CollisionScene& scene, const CollisionOutcome& outcome) {
  CollisionError error;
  for (std::size_t b = 0; b < scene.moving.bodies.size(); ++b) {
    const MovingBody &exact = scene.reference.bodies[b], &found = outcome.bodies[b];
    if (exact.plane) continue;
    error.motion = std::max({error.motion, (found.velocity - exact.velocity).norm(), exact.radius * (found.spin - exact.spin).norm()});
  }
  error.motion /= scene.speed;
  error.energy = (kinetic_energy(outcome.bodies) - kinetic_energy(scene.reference.bodies)) / kinetic_energy(scene.moving.bodies);
  if (outcome.contact_time) {
    const double exact = scene.reference.last_separation - scene.reference.first_touch;
    error.contact_time = *outcome.contact_time / exact - 1;
  }
  return error;
}

}  // namespace scalebreak

#include <algorithm>
#include <cmath>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/papers/middle_sphere.hpp>

namespace scalebreak {
namespace {

constexpr int samples = 4000;  ///< instants per motion

/// What velocity, spin and time are measured by: of the system itself, as it starts.
struct Characteristic {
  double speed, spin, time;
};

/// W eqs 56, 57 and 59 or 83, with radius, mass and stiffness of the middle sphere.
Characteristic characteristic(const Input& input, const MovingScene& scene, const CaseSystem& system) {
  const MovingBody& body = scene.bodies[middle_sphere];
  const Material material =
      scaled_material(*system.law, system.factor, input.material_of(input.bodies[middle_sphere]), input.contact.normal);
  const double speed = body.velocity.norm();
  const double rate = input.contact.traits().constant_spring ? std::sqrt(material.spring_constant / body.mass)
                                                             : std::pow(material.young * std::sqrt(body.radius * speed) / body.mass, 0.4);
  return {speed, body.spin.norm(), 1 / rate};
}

/// Overlap over radius beyond which there are no two spheres any more: the surface of one has passed the centre of the other.
constexpr double no_spheres = 1;

/// Ends a motion that has lost its meaning.
struct Lost {};

}  // namespace

double characteristic_time(const Input& input, const CaseSystem& system) {
  return characteristic(input, moving_scene(input, *system.law, system.factor), system).time;
}

MiddleCurve follow_middle(const Input& input, const CaseSystem& system, double duration) {
  MiddleCurve motion{.system = system, .rolling = input.surface.rolling != RollingModel::none};
  const MovingScene scene = moving_scene(input, *system.law, system.factor);
  const Characteristic unit = characteristic(input, scene, system);
  MotionOptions options{.tolerance = input.tolerance, .duration = duration * unit.time};
  options.sample_interval = options.duration / samples;
  const double radius = scene.bodies[middle_sphere].radius;
  options.observer = [&](const MotionSample& sample) {
    motion.overlap_over_radius = std::max(motion.overlap_over_radius, sample.largest_overlap / radius);
    if (motion.overlap_over_radius > no_spheres) throw Lost{};
    const double t = sample.time / unit.time;
    if (!motion.curve[0].time.empty() && t <= motion.curve[0].time.back()) return;
    const MovingBody& body = sample.bodies[middle_sphere];
    motion.curve[0].add(t, body.velocity.y() / unit.speed);
    motion.curve[1].add(t, body.velocity.x() / unit.speed);
    motion.curve[2].add(t, body.spin.z() / unit.spin);
  };
  try {
    const MotionOutcome outcome = scene.move(options);
    motion.turned = outcome.turned;
    motion.touches = outcome.touches;
  } catch (const Lost&) {
    motion.lost = true;
  }
  return motion;
}

}  // namespace scalebreak

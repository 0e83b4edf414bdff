#include <scalebreak/ensembles/prediction/scale_groups.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/ensembles/engine/flow_start.hpp>
#include <scalebreak/ensembles/prediction/granular_theory.hpp>
#include <scalebreak/scene/flow_scene.hpp>
#include <scalebreak/start/filling.hpp>

namespace scalebreak {
namespace {

using std::numbers::pi;

constexpr double collision_tolerance = 1e-6, above_sticking = 2, sphere_inertia = 0.4;

double size_of(const Input& input) { return size_factor(*find_scaling_law(input.scaling_law), input.scaling_factor); }

/// Diameter, volume fraction and edges of the scaled system.
void measure_spheres(const Input& input, FlowConditions& conditions) {
  double count = 0, volume = 0;
  Eigen::Vector3d size;
  if (input.particles.file.empty()) {
    const FlowPlan plan = plan_flow(input);
    count = plan.count, size = plan.size, volume = size.prod(), conditions.volume_fraction = plan.volume_fraction;
  } else {
    const FlowStart start = flow_start(input);
    count = static_cast<double>(start.system.count()), size = start.system.cell.size, volume = start.system.cell.volume();
    conditions.volume_fraction = volume_fraction(start.system.cell, start.system.radius);
    conditions.speed = start.speed;
  }
  conditions.diameter = std::cbrt(6 * conditions.volume_fraction * volume / (pi * count));
  conditions.length = size.minCoeff();
  conditions.shear_rate = std::abs(mean_shear_rate(input.cell, size.z()));
  conditions.length_along_gravity = size.dot(input.cell.gravity.cwiseAbs()) / std::max(conditions.gravity, 1e-300);
  conditions.speed = std::max({conditions.speed, input.particles.speed, std::sqrt(2 * input.cell.gravity.cwiseAbs().dot(size))});
}

/// Granular temperature and how crowded it is.
struct Gas {
  double temperature, contact_value, jamming_share, restitution, volume_fraction, friction;
  bool jammed;
};

Gas gas_of(const Input& input, const FlowConditions& c, double size) {
  const double friction = input.surface.tangential == TangentialModel::none ? 0 : input.material.sliding_friction;
  const double jamming = jamming_fraction(friction);
  Gas gas{.restitution = effective_restitution(input.material.restitution, friction), .friction = friction};
  gas.jammed = c.volume_fraction > jamming - below_jamming;
  gas.volume_fraction = std::min(c.volume_fraction, jamming - below_jamming);
  // What diverges where spheres jam is of sheared flows.
  gas.contact_value = c.shear_rate > 0 ? contact_value(gas.volume_fraction, jamming) : fluid_contact_value(gas.volume_fraction);
  gas.jamming_share = c.shear_rate > 0 ? jamming_share(gas.volume_fraction, jamming) : 0;
  const bool ask = c.shear_rate > 0 && !c.speed_is_told && gas.restitution < 1;
  const double rate = c.shear_rate * c.diameter;
  // A speed that is told is the original's; in shear it grows with the spheres.
  const double speed = c.shear_rate > 0 ? size * c.speed : c.speed;
  gas.temperature =
      ask ? shear_temperature_number(gas.volume_fraction, gas.contact_value, gas.restitution) * rate * rate : speed * speed / 3;
  return gas;
}

FlowRegime regime_of(const FlowConditions& c, const ScaleGroups& groups) {
  if (groups.sheared) return groups.collisional_share < 0.5 ? FlowRegime::pressed : FlowRegime::collisional;
  return c.gravity > 0 ? FlowRegime::resting : FlowRegime::cooling;
}

/// Overlap over R* of a contact that carries a force, without adhesion: Hertz's, or that of a linear spring.
double overlap_under(const ScaledContact& contact, double force) {
  const NormalPair& pair = contact.scaled().pair;
  const double own = force / contact.scaled().force;  // that of the evaluated pair
  if (contact.kind().normal == NormalModel::linear) return own / pair.spring_constant / pair.radius;
  return std::pow(0.75 * own / (pair.young * pair.radius * pair.radius), 2.0 / 3);
}

/// Of the scaled pair of spheres [N].
double pull_off_force(const ScaledContact& contact) {
  const NormalPair& pair = contact.scaled().pair;
  return contact.kind().adhesive() ? contact.scaled().force * 3 * pi * pair.surface_energy * pair.radius : 0;
}

}  // namespace

FlowConditions flow_conditions(const Input& input) {
  if (!input.flow)
    throw InputError("a pair or bodies are no flow, of which contact time and collision rate could be compared; allowed: a flow");
  FlowConditions conditions{.density = input.material.density, .pressure = input.cell.pressure, .gravity = input.cell.gravity.norm()};
  measure_spheres(input, conditions);
  conditions.begin = input.run.warmup_duration, conditions.end = conditions.begin + input.run.duration;
  if (input.advise.speed > 0) conditions.speed = input.advise.speed, conditions.speed_is_told = true;
  return conditions;
}

ScaleGroups scale_groups(const Input& input) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  const FlowConditions c = flow_conditions(input);
  ScaleGroups groups{.size = size_of(input)};
  if (law.direct_force && groups.size > 1) groups.torque_lack = law.force + 1 - law.torque;
  const Gas gas = gas_of(input, c, groups.size);
  groups.jammed = gas.jammed, groups.temperature = gas.temperature, groups.jamming_share = gas.jamming_share;
  groups.impact_speed = mean_impact_speed(gas.temperature);
  groups.collision_rate = collisions_of_sphere(gas.volume_fraction, gas.contact_value, gas.temperature, c.diameter);
  const double radius = c.diameter / groups.size / 2;
  const ScaledContact contact(input.contact, {input.material, input.material, input.wall, {radius, radius}}, law, input.scaling_factor);
  const double sticking = contact.sticking_speed(collision_tolerance).value_or(0);
  const double speed = std::max(groups.impact_speed, above_sticking * sticking * (groups.impact_speed <= sticking ? 1.0 : 0.0));
  double left = 0;  // of the energy of such an impact
  if (speed > 0) {
    const PairCollision collision = contact.collide(speed, collision_tolerance);
    groups.contact_time = collision.contact_time.value_or(0), groups.overlap = 2 * collision.max_overlap / (c.diameter / 2);
    left = collision.restitution * collision.restitution;
  }
  groups.sheared = c.shear_rate > 0;
  groups.busy = groups.contact_time * groups.collision_rate;
  const double gas_pressure = collisional_pressure(c.density, gas.volume_fraction, gas.contact_value, gas.restitution, gas.temperature);
  const double pressure = c.pressure > 0 ? c.pressure : groups.sheared ? gas_pressure : 0;
  const double weight = sphere_mass(c.diameter / 2, c.density) * c.gravity, pull = pull_off_force(contact);
  groups.bond = pressure > 0 ? pull / (pressure * c.diameter * c.diameter) : weight > 0 ? pull / weight : 0;
  if (pressure > 0) groups.inertial_number = c.shear_rate * c.diameter * std::sqrt(c.density / pressure);
  groups.length_ratio = c.diameter / c.length;
  groups.collisional_share = !groups.sheared ? 0 : c.pressure > 0 ? std::min(1.0, gas_pressure / c.pressure) : 1;
  groups.regime = regime_of(c, groups);
  if (groups.regime == FlowRegime::cooling) {
    groups.gas = {.collision = {.friction = gas.friction,
                                .inertia = sphere_inertia * std::pow(groups.size, groups.torque_lack),
                                .sticking_speed = sticking},
                  .temperature = groups.temperature,
                  .collision_rate = groups.collision_rate,
                  .busy = groups.busy,
                  .contact_time_power = input.contact.normal == NormalModel::linear ? 0 : 0.2,
                  .begin = c.begin,
                  .end = c.end};
    groups.gas.collision.restitution = std::sqrt(std::min(1.0, left / (1 - std::pow(sticking / speed, 2))));
    groups.cooled = std::sqrt(groups.temperature / cool(groups.gas, 0).last_temperature) - 1;
  }
  groups.impact_over_sticking =
      sticking > 0 ? groups.impact_speed / (1 + groups.cooled) / sticking : std::numeric_limits<double>::infinity();
  const double above = c.density * c.volume_fraction * c.gravity * c.length_along_gravity;
  const double pressing = groups.regime == FlowRegime::resting ? above : c.pressure;
  if (pressing > 0) groups.pressed_overlap = overlap_under(contact, pressing * c.diameter * c.diameter);
  return groups;
}

Input original_of(Input input) {
  input.scaling_law = "none", input.scaling_factor = 1, input.keep = Keep::count;
  return input;
}

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <fmt/format.h>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>

#include <lib/resolving.hpp>

// Few spheres in a cell of their own, by the hybrid, by the event-driven engine and by the exact one of few bodies.

namespace scalebreak::tests {

using Spheres = EventSpheres<CalendarQueue, TableRule>;
constexpr double radius = 0.5e-3, edge = 0.04;

inline Input flow_of(const std::string& contact, double young = 1e9) {
  return resolved(
      fmt::format("[material]\nyoung = {:g}\n[contact]\n{}\n[particles]\ncount = 3\n[cell]\nkind = \"cooling\"\n"
                  "size = [{}, {}, {}]\n",
                  young, contact, edge, edge, edge));
}

inline System spheres_at(const std::vector<Eigen::Vector3d>& positions, const std::vector<Eigen::Vector3d>& velocities) {
  System system;
  system.cell.size = Eigen::Vector3d::Constant(edge);
  system.position = positions, system.velocity = velocities;
  system.radius.assign(positions.size(), radius);
  system.mass.assign(positions.size(), sphere_mass(radius, 2500));
  system.material.assign(positions.size(), 0);
  system.spin.assign(positions.size(), Eigen::Vector3d::Zero());
  return system;
}

inline DemSetup groups_setup(const Input& input, double fraction = 0.15) {
  DemSetup setup = dem_setup(input, 1, 1);
  setup.step = fraction * rayleigh_step(setup, radius);
  return setup;
}

/// The hybrid as a run has it, with patches at a fraction of Rayleigh's step.
struct Hybrid {
  GroupLaws laws;
  Spheres flow;
  Hybrid(const System& start, const Input& input, const TableStore& store, double fraction = 0.15)
      : laws(groups_setup(input, fraction), start.cell, {{radius, 0}}),
        flow(start, {.gravity = input.cell.gravity, .groups = &laws},
             TableRule(input, kinds_of(start), store, {.turning = 1e-3}, Unanswered::leave)) {}
};

inline std::vector<MovingBody> exactly(const System& start, const Input& input, double time) {
  Input scene = input;
  scene.flow = false;
  for (std::size_t i = 0; i < start.count(); ++i)
    scene.bodies.push_back({.position = start.position[i], .velocity = start.velocity[i], .spin = start.spin[i], .radius = radius});
  return moving_scene(scene).move({.tolerance = 1e-9, .duration = time}).bodies;
}

/// Largest difference of velocities, over `speed`.
inline double deviation(const System& end, const std::vector<MovingBody>& bodies, double speed) {
  double most = 0;
  for (std::size_t i = 0; i < end.count(); ++i) most = std::max(most, (end.velocity[i] - bodies[i].velocity).norm() / speed);
  return most;
}

/// Some spheres, and how long they are followed.
struct FewSpheres {
  System start;
  double speed, time;
};

/// Spheres about the middle that fall together at random.
inline FewSpheres cluster(unsigned seed, int count) {
  constexpr double speed = 0.3;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> even(-1, 1);
  const auto vector = [&] { return Eigen::Vector3d(even(random), even(random), even(random)); };
  std::vector<Eigen::Vector3d> positions, velocities;
  const Eigen::Vector3d middle = Eigen::Vector3d::Constant(edge / 2);
  const double room = 1.35 * radius * std::cbrt(count);
  while (static_cast<int>(positions.size()) < count) {
    const Eigen::Vector3d place = middle + room * vector();
    bool free = true;
    for (const Eigen::Vector3d& other : positions) free = free && (place - other).norm() > 2.0001 * radius;
    if (!free) continue;
    positions.push_back(place);
    velocities.push_back(speed * (vector() - (place - middle) / room));
  }
  return {spheres_at(positions, velocities), speed, 0.6 * radius / speed};
}

/// A row a little out of line, its gaps between 1e-6 and 1e-2 of the radius, that the first hits; until the last has gone on.
inline FewSpheres random_row(unsigned seed, int count) {
  constexpr double speed = 0.3;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> even(-1, 1), decades(-6, -2);
  std::vector<Eigen::Vector3d> positions = {Eigen::Vector3d(0.005, edge / 2, edge / 2)}, velocities = {speed * Eigen::Vector3d::UnitX()};
  double gaps = 0;
  while (static_cast<int>(positions.size()) < count) {
    const double gap = radius * std::pow(10.0, decades(random));
    gaps += gap;
    positions.push_back(positions.back() + (2 * radius + gap) * Eigen::Vector3d(1, 0.05 * even(random), 0.05 * even(random)).normalized());
    velocities.push_back(Eigen::Vector3d::Zero());
  }
  return {spheres_at(positions, velocities), speed, 2 * gaps / speed + 0.2 * radius * count / speed};
}

/// A number of spheres from 3 to 20 for each seed.
inline int spheres_of(unsigned seed) { return 3 + static_cast<int>(seed % 18); }

/// Deviations of velocities from the exact engine, over the speed.
struct EngineErrors {
  double hybrid = 0, hybrid_fine = 0, event = 0;  ///< steps of 0.15 and of 0.02 of Rayleigh's; two at a time, never a patch
  double momentum = 0;                            ///< the most that the hybrid gained, over speed and number
};

inline EngineErrors errors_of(const FewSpheres& spheres, const Input& input, const TableStore& store) {
  const auto& [start, speed, time] = spheres;
  const auto bodies = exactly(start, input, time);
  EngineErrors errors;
  for (const double fraction : {0.15, 0.02}) {
    Hybrid hybrid(start, input, store, fraction);
    hybrid.flow.advance_to(time);
    hybrid.flow.open_contacts();
    const System end = hybrid.flow.system();
    (fraction > 0.1 ? errors.hybrid : errors.hybrid_fine) = deviation(end, bodies, speed);
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < start.count(); ++i) momentum += end.velocity[i] - start.velocity[i];
    errors.momentum = std::max(errors.momentum, momentum.norm() / (speed * static_cast<double>(start.count())));
  }
  Spheres binary(start, {}, TableRule(input, kinds_of(start), store, {.turning = 1e-2}));
  binary.advance_to(time);
  errors.event = deviation(binary.system(), bodies, speed);
  return errors;
}

}  // namespace scalebreak::tests

#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <scalebreak/measure/flow_json.hpp>
#include <scalebreak/measure/flow_measurement.hpp>

namespace scalebreak {

inline void add_sphere(System& system, const Eigen::Vector3d& position, double radius = 0.01, double mass = 2,
                       const Eigen::Vector3d& velocity = {0, 0, 0}) {
  system.position.push_back(position);
  system.velocity.push_back(velocity);
  system.spin.emplace_back(0, 0, 0);
  system.radius.push_back(radius);
  system.mass.push_back(mass);
  system.material.push_back(0);
}

/// Spheres anywhere in a cell with normal velocities of a temperature [m²/s²].
inline System ideal_gas(const Cell& cell, int count, double temperature, std::uint64_t seed, double mass = 2) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place;
  std::normal_distribution<double> speed(0, std::sqrt(temperature));
  const auto vector = [&](auto& distribution) {
    const double x = distribution(random), y = distribution(random), z = distribution(random);
    return Eigen::Vector3d(x, y, z);
  };
  System system;
  system.cell = cell;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d position = vector(place).cwiseProduct(cell.size);
    add_sphere(system, position, 0.01, mass, vector(speed));
  }
  return system;
}

inline Cell periodic_cell(double x, double y, double z) { return {.size = {x, y, z}}; }

inline Cell walled_cell(double x, double y, double z) {
  return {.size = {x, y, z}, .boundary = {Boundary::periodic, Boundary::periodic, Boundary::wall}};
}

/// What one state says, held for a second.
inline FlowResult held(System system, const std::vector<ContactForce>& contacts = {}, int slabs = 20) {
  FlowMeasurement measurement(slabs);
  measurement.add({system, contacts});
  system.time += 1;
  measurement.add({system, contacts});
  return measurement.result();
}

inline Measured found(const FlowResult& result, const std::string& name) {
  const auto quantities = all_quantities(result);
  return std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.name == name; })->measured;
}

inline const std::vector<Measured>& profile_of(const FlowResult& result, const std::string& name) {
  const auto& columns = result.profile.columns;
  return std::find_if(columns.begin(), columns.end(), [&](const ProfileColumn& c) { return c.name == name; })->slabs;
}

}  // namespace scalebreak

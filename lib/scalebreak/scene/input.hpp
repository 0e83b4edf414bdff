#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/contact/surface_kind.hpp>
#include <scalebreak/material/material.hpp>
#include <scalebreak/scaling/scaled_pair.hpp>
#include <scalebreak/scene/advise_input.hpp>
#include <scalebreak/scene/flow_input.hpp>
#include <scalebreak/scene/study_input.hpp>
#include <scalebreak/scene/tradeoff_input.hpp>

namespace scalebreak {

/// One sphere of a few-body scene, SI.
struct Body {
  Eigen::Vector3d position{0, 0, 0};
  Eigen::Vector3d velocity{0, 0, 0};
  Eigen::Vector3d spin{0, 0, 0};
  double radius = 0;
  bool fixed = false;   ///< moves on as it started, whatever acts on it
  bool second = false;  ///< of [second] rather than [material]

  bool operator==(const Body&) const = default;
};

/// A resolved input: every key has its value. The ORIGINAL system; the program applies the scaling law.
struct Input {
  Material material;
  Material second;
  Wall wall;
  ContactKind contact;  ///< the normal law
  SurfaceKind surface;  ///< all the other laws
  std::vector<double> radius = {0.5e-3, 0.5e-3};
  bool against_wall = false;
  double normal_speed = 0.1;
  double tangential_speed = 0;
  Eigen::Vector3d spin1{0, 0, 0}, spin2{0, 0, 0};
  std::vector<Body> bodies;  ///< none: then [pair] and [impact] hold, unless this is a flow
  bool flow = false;         ///< [particles] or [cell] are given: they hold, with [output]
  Particles particles;
  CellInput cell;
  RunInput run;
  OutputInput output;
  std::string scaling_law = "none";
  double scaling_factor = 1;
  Keep keep = Keep::count;              ///< of a flow under a law that enlarges
  std::vector<std::string> study_laws;  ///< empty: all that suit the contact
  std::vector<double> study_factors = {0.1, 0.01, 0.0001, 2, 4, 8};
  std::vector<double> study_speeds;  ///< empty: about the sticking speed
  std::vector<Integrator> study_integrators = {Integrator::verlet};
  double study_energy_growth = 1e-3;  ///< that a stable step may show per collision of each sphere, relative
  double study_motion_error = 1e-2;   ///< that a stable step may make in a collision, over its speed
  TradeoffInput tradeoff;             ///< of [study] too
  StudyInput study;                   ///< the same
  AdviseInput advise;
  double tolerance = 1e-8;
  double table_tolerance = 1e-6;

  bool operator==(const Input&) const = default;

  /// The material of a body.
  [[nodiscard]] const Material& material_of(const Body& body) const { return body.second ? second : material; }

  /// What meets: the pair, of [material] and [second], or the first two bodies.
  [[nodiscard]] Bodies colliding() const {
    if (bodies.empty()) return {material, second, wall, radius};
    return {material_of(bodies[0]), material_of(bodies[1]), wall, {bodies[0].radius, bodies[1].radius}};
  }
};

}  // namespace scalebreak

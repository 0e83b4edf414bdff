#pragma once

#include <vector>

#include <scalebreak/material/pair.hpp>
#include <scalebreak/scaling/scaling_law.hpp>

namespace scalebreak {

/// Two bodies that meet: spheres of these radii, or one sphere and a wall. SI, original system.
struct Bodies {
  Material first;
  Material second;  ///< of the second sphere
  Wall wall;
  std::vector<double> radius;  ///< one (against the wall) or two [m]

  [[nodiscard]] bool against_wall() const { return radius.size() == 1; }
  [[nodiscard]] NormalPair pair() const;
  [[nodiscard]] SurfacePair surfaces() const;
};

/// The bodies of the scaled system, beside a normal contact. A size law enlarges all geometry: radii, S_min and the bridges.
[[nodiscard]] Bodies scaled_bodies(const ScalingLaw& law, double factor, Bodies bodies, NormalModel normal);

/// How a scaled pair collides in the normal direction: as `pair`, with what turns that pair's overlaps, times and
/// forces into the scaled system's. Speeds are the same in both.
///
/// A parameter law is that pair itself. For a direct-force law the pair is the original with another inertia: from
/// m_S dv/dt_S = l^p F_O(δ_S/l^q, v), with m_S = l³m_O and t_O = t_S/l^q, follows m_O l^{3−q−p} dv/dt_O = F_O(δ_O, v).
struct ScaledPair {
  NormalPair pair;
  double overlap = 1;
  double time = 1;
  double force = 1;
};

[[nodiscard]] ScaledPair scaled_pair(const ScalingLaw& law, double factor, const Bodies& original, NormalModel normal);

}  // namespace scalebreak

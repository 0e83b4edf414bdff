#pragma once

#include <cstdint>
#include <vector>

#include <scalebreak/base/large_list.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak::dem {

/// The spheres as the engine keeps them: lists sorted in space, four numbers side by side.
struct Spheres {
  LargeList<std::uint32_t> id;               ///< of each, its place in System
  LargeList<Quad> position;                  ///< w: radius [m]
  LargeList<Quad> velocity;                  ///< half a step behind; w: 1/mass
  LargeList<Quad> spin;                      ///< the same; w: 1/inertia; empty where nothing turns
  LargeList<Quad> force, torque;             ///< at the present places; w is 0
  LargeList<Quad> seen_velocity, seen_spin;  ///< what dashpots see, if it is not the velocity itself
  LargeList<std::uint32_t> kind;             ///< of equal radius and material; the material alone where every sphere has a size of its own

  Spheres() = default;
  /// `turns`: keep spins; `estimates`: keep velocities that dashpots see.
  Spheres(const System& system, bool turns, bool estimates);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(position.size()); }
  [[nodiscard]] SpheresView view();
  /// Puts sphere order[k] in place k.
  void sort(const std::vector<std::uint32_t>& order);
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace scalebreak::dem

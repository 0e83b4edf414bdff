#pragma once

#include <array>
#include <string>
#include <vector>

#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// The spheres with which a flow of the SCALED system starts, SI, at time 0.
struct FlowStart {
  System system;
  double speed = 0;                   ///< root of the mean squared velocity about the mean flow [m/s]
  std::vector<std::string> warnings;  ///< sentences
};

/// A random filling, or the spheres of a file under the scaling law: radii, places and cell times its size factor, spins over it.
/// Masses follow from the material. A filling between walls that move starts about the linear profile (Washino et al. 2024, section 5). Throws InputError where a file does not say enough or its spheres overlap, and what `scaled_flow`
/// and `fill` throw.
[[nodiscard]] FlowStart flow_start(const Input& input, std::uint64_t replica = 0);

}  // namespace scalebreak

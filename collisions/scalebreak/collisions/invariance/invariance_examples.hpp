#pragma once

#include <string>
#include <vector>

#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/scaling/scaling_law.hpp>

namespace scalebreak {

/// A law at one of its factors, as plots show it.
struct Example {
  const ScalingLaw* law;
  double factor;
  int style;  ///< the same law looks the same in every plot
};

/// Every law, on either side of 1, at its factor farthest from 1 or nearest to it.
[[nodiscard]] std::vector<Example> examples(const InvarianceStudy& study, bool farthest);

/// A name without its underscores.
[[nodiscard]] std::string readable(std::string name);

}  // namespace scalebreak

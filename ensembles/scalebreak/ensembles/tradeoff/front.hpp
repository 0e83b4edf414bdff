#pragma once

#include <vector>

namespace scalebreak {

/// Which of the points no other beats: none is at most as large in both and smaller in one.
[[nodiscard]] inline std::vector<bool> on_front(const std::vector<double>& costs, const std::vector<double>& errors) {
  std::vector<bool> front(costs.size(), true);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    for (std::size_t j = 0; j < costs.size(); ++j) {
      const bool beaten = costs[j] <= costs[i] && errors[j] <= errors[i] && (costs[j] < costs[i] || errors[j] < errors[i]);
      if (beaten) front[i] = false;
    }
  }
  return front;
}

}  // namespace scalebreak

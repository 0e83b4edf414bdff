#pragma once

#include <scalebreak/ensembles/event/flight/flight.hpp>

namespace scalebreak {

/// What is next for a sphere, as far as its own list tells, and in how long from now.
struct Foreseen {
  double wait;
  Neighbour partner;
};
[[nodiscard]] Foreseen foresee(const Flight& flight, std::uint32_t i, double now);

}  // namespace scalebreak

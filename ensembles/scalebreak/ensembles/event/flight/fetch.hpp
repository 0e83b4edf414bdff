#pragma once

#include <scalebreak/ensembles/event/flight/flight.hpp>

// Fetching ahead of events, in three stages: what one stage reads, the one before has fetched.

namespace scalebreak {

/// A sphere whose event is not far.
inline void fetch(const Flight& flight, std::uint32_t i) {
  __builtin_prefetch(&flight.sphere[i]);
  __builtin_prefetch(&flight.agenda[i]);
}

/// Of one whose event may be the next but one: its list, and whom it meets.
inline void fetch_surroundings(const Flight& flight, std::uint32_t i) {
  constexpr std::size_t entries_a_line = 64 / sizeof(Neighbour);
  const Agenda& own = flight.agenda[i];
  __builtin_prefetch(flight.pool.data() + own.start);
  __builtin_prefetch(flight.pool.data() + own.start + entries_a_line);
  if (own.partner.sphere() < most_flying_spheres) fetch(flight, own.partner.sphere());
}

/// Of one whose event is now: whom it will look at.
inline void fetch_neighbours(const Flight& flight, std::uint32_t i) {
  const Agenda& own = flight.agenda[i];
  for (std::uint32_t k = own.start; k < own.start + own.count; ++k) __builtin_prefetch(&flight.sphere[flight.pool[k].sphere()]);
}

}  // namespace scalebreak

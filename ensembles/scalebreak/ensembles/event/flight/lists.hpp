#pragma once

#include <scalebreak/ensembles/event/flight/flight.hpp>

namespace scalebreak {

/// Makes all lists, of spheres that are inside the cell and brought up to time 0.
void make_lists(Flight& flight);

/// Makes the list of one sphere anew. One that has left the cell across a periodic face is brought back, which is a change of its path.
void renew_list(Flight& flight, std::uint32_t i, double now);

/// How far it has come from its reference, over how far it may.
[[nodiscard]] double share_of_allowance(const Flight& flight, std::uint32_t i, double now);

}  // namespace scalebreak

#pragma once

#include <span>

#include <scalebreak/ensembles/event/flight/flight.hpp>
#include <scalebreak/ensembles/event/flight/foresee.hpp>

namespace scalebreak {

/// Which of its neighbours a sphere, as it is at its own time, meets first, and whether before what is `next` so far.
void see_neighbours(const Flight& flight, std::span<const Neighbour> list, const FlyingSphere& here, Foreseen& next);

/// The same bits, four neighbours at a time: where the processor has AVX2.
void see_neighbours_by_fours(const Flight& flight, std::span<const Neighbour> list, const FlyingSphere& here, Foreseen& next);
[[nodiscard]] inline bool can_see_by_fours() { return __builtin_cpu_supports("avx2"); }

}  // namespace scalebreak

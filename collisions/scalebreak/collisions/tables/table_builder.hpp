#pragma once

#include <functional>

#include <scalebreak/table/collision_table.hpp>

namespace scalebreak {

/// Builds the table of a kind of contact with the exact engine: both axes are halved in turn until the
/// error against fresh exact collisions between the nodes is below the key's tolerance (1e-7 to 1e-2).
/// Uses `threads` cores (0: all); the result has the same bits for any number.
/// `progress(done)` is told the share of the work behind it, as far as one can know, from this thread.
/// Throws WorkError if a collision fails or the tolerance is not reached on the largest grid.
[[nodiscard]] CollisionTable build_collision_table(const TableKey& key, int threads = 0, const std::function<void(double)>& progress = {});

/// The exact answer at any point, in the form of a table's: for what leaves a table, and to check one.
[[nodiscard]] TableOutcome exact_table_outcome(const ContactKind& kind, double damping_ratio, double speed, double tolerance);

}  // namespace scalebreak

#pragma once

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>

namespace scalebreak {

/// A pair's collision by tables of this tolerance, which is allowed to the turning of the normal too. They are obtained here; the outcome's
/// wall time is that of a lookup, its work one. Refuses what tables do not answer: more bodies, liquids, what sticks or turns too far, and
/// tables that cannot be built so well.
[[nodiscard]] PreparedCollision tabulated_collision(const CollisionScene& scene, double tolerance, const TableStore& store);

}  // namespace scalebreak

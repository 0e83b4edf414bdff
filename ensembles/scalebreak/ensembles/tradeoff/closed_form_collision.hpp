#pragma once

#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>

namespace scalebreak {

/// A head-on collision of a pair by a formula, where there is one: the damped linear contact, whose restitution is e = exp(−πβ/√(1−β²))
/// and whose contact lasts π√(m*/k)/√(1−β²), and the elastic Hertz contact, which lasts (4/5)B(2/5, 1/2) δ_max/v (K. L. Johnson, Contact
/// Mechanics, 1985, eq. 11.24). Its work counts one. Refuses all else.
[[nodiscard]] PreparedCollision closed_form_collision(const CollisionScene& scene);

}  // namespace scalebreak

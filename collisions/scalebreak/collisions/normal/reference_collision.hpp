#pragma once

#include <scalebreak/collisions/normal/normal_collision.hpp>

namespace scalebreak {

/// A normal collision by a second, independent method, in reduced variables: where nothing damps, the energy
/// integral, GSL's root for the turning point and GSL's quadrature for the contact time; where a dashpot acts,
/// GSL's Prince–Dormand 8(9) stepper in the same regular variables, with GSL's root finder for the end.
/// It exists to check resolve_normal_collision; it gives no forces. Throws WorkError.
[[nodiscard]] NormalOutcome<double> resolve_by_second_method(const ContactKind& kind, double damping_ratio, double reduced_speed);

}  // namespace scalebreak

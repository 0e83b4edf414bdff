#pragma once

namespace scalebreak {

/// How an exact motion is stepped between events; all of it is Boost.Odeint's. Where an event lies is found by steps from the last one's start, with
/// `dopri5_dense` on its interpolant of fourth order, which takes no evaluations.
enum class Stepper { fehlberg78, cash_karp54, dopri5, dopri5_dense, bulirsch_stoer };

}  // namespace scalebreak

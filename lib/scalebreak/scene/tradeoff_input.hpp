#pragma once

#include <cstdint>
#include <vector>

namespace scalebreak {

/// What follows a collision: the soft-sphere engine by its integrators (see Integrator), which follow flows too; the exact engine, by default and by
/// other steppers; a lookup, a formula.
enum class Method { verlet, synchronized, exact, cash_karp54, dopri5, dopri5_dense, bulirsch_stoer, table, closed_form };
inline constexpr const char* method_words[] = {"verlet",       "synchronized",   "exact", "cash_karp54", "dopri5",
                                               "dopri5_dense", "bulirsch_stoer", "table", "closed_form"};

/// Of a study of accuracy against cost: what is compared.
struct TradeoffInput {
  std::vector<Method> methods;  ///< empty: all that suit the scene
  std::vector<double> step_fractions = {0.4, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05, 0.035, 0.025};
  std::vector<double> tolerances = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};
  std::uint64_t phases = 32;  ///< of a step, at which a collision begins

  bool operator==(const TradeoffInput&) const = default;
};

}  // namespace scalebreak

#pragma once

#include <cmath>
#include <functional>

#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace scalebreak {

// Embedded Runge-Kutta pairs of Boost.Odeint, as EmbeddedSteps takes them:
//
//     State
//     root(norm)                                                 of an error: the ratio by which the step is too long
//     step(system, before, rate, after, end_rate, h, error)
//     finish(system, after, end_rate)                            the rate at the end of a step that is taken, unless `step` has it
//     at(system, before, rate, end_rate, u, h, state)            the state at u of the last step

/// A pair without more: within a step another one is made.
template <class Stepper>
class PlainPair {
 public:
  using State = typename Stepper::state_type;

  template <class System>
  void step(System& system, const State& before, const State& rate, State& after, State&, double h, State& error) {
    stepper_.do_step(std::ref(system), before, rate, 0.0, after, h, error);
  }
  template <class System>
  static void finish(System& system, const State& after, State& end_rate) {
    system(after, end_rate, 0.0);
  }
  template <class System>
  void at(System& system, const State& before, const State& rate, const State&, double u, double h, State& state) {
    stepper_.do_step(std::ref(system), before, rate, 0.0, state, u * h);
  }

 private:
  Stepper stepper_;
};

/// Fehlberg's of orders 7 and 8: twelve evaluations a step beside the rate at its start.
template <class State, class Algebra>
struct Fehlberg78 : PlainPair<boost::numeric::odeint::runge_kutta_fehlberg78<State, double, State, double, Algebra>> {
  static double root(double norm) { return std::sqrt(std::sqrt(std::sqrt(norm))); }
};

/// Cash and Karp's of orders 5 and 4: five evaluations.
template <class State, class Algebra>
struct CashKarp54 : PlainPair<boost::numeric::odeint::runge_kutta_cash_karp54<State, double, State, double, Algebra>> {
  static double root(double norm) { return std::pow(norm, 0.2); }
};

/// Dormand and Prince's of orders 5 and 4: six evaluations, of which the last is the rate at the end.
template <class State, class Algebra, bool dense>
class DormandPrince {
 public:
  using Stepper = boost::numeric::odeint::runge_kutta_dopri5<State, double, State, double, Algebra>;

  static double root(double norm) { return std::pow(norm, 0.2); }
  template <class System>
  void step(System& system, const State& before, const State& rate, State& after, State& end_rate, double h, State& error) {
    stepper_.do_step(std::ref(system), before, rate, 0.0, after, end_rate, h, error);
  }
  template <class System>
  static void finish(System&, const State&, State&) {}
  template <class System>
  void at(System& system, const State& before, const State& rate, const State& end_rate, double u, double h, State& state) {
    if constexpr (dense) {
      stepper_.calc_state(u * h, state, before, rate, 0.0, state, end_rate, h);
    } else {
      inner_rate_ = end_rate;
      inner_.do_step(std::ref(system), before, rate, 0.0, state, inner_rate_, u * h);
    }
  }

 private:
  Stepper stepper_, inner_;
  State inner_rate_{};
};
template <class State, class Algebra>
using DormandPrince54 = DormandPrince<State, Algebra, false>;
/// Within a step by its interpolant of fourth order.
template <class State, class Algebra>
using DenseDormandPrince54 = DormandPrince<State, Algebra, true>;

}  // namespace scalebreak

#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <boost/numeric/odeint/algebra/range_algebra.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/modified_midpoint.hpp>

#include <scalebreak/collisions/steps/step_tries.hpp>

namespace scalebreak {

/// Steps of Boost.Odeint's Bulirsch–Stoer, which chooses length and order; interface as that of EmbeddedSteps. It knows one scale of all
/// components, so that it is given the state over the system's scales.
class BulirschStoerSteps {
 public:
  using State = std::vector<double>;

  BulirschStoerSteps(double tolerance, double first_step) : stepper_(tolerance, 0.0, 0.0, 0.0), next_step_(first_step) {}

  template <class System>
  double take(System& system, const State& before, const State& rate, State& after, State& end_rate, double longest) {
    divide(system, before, before_);
    divide(system, rate, rate_);
    after_ = before_;
    Scaled<System> scaled{*this, system};
    for (;;) {
      const double h = std::min(next_step_, longest);
      double s = 0, next = h;
      scaled.evaluations = 0;
      const bool taken = stepper_.try_step(std::ref(scaled), before_, rate_, s, after_, next) == boost::numeric::odeint::success;
      tries_.add();
      const bool finite = std::all_of(after_.begin(), after_.end(), [](double y) { return std::isfinite(y); });
      if (taken && finite) {
        next_step_ = std::isfinite(next) ? next : h;
        columns_of(scaled.evaluations);
        after = before;
        multiply(system, after_, after);
        system(after, end_rate, 0.0);
        return h;
      }
      next_step_ = finite && std::isfinite(next) && next < h ? next : 0.1 * h;
      if (!finite) stepper_.reset();
      StepTries::check(next_step_, finite);
    }
  }

  /// By an extrapolation of as many columns as the step had.
  template <class System>
  void at(System& system, const State& before, const State&, const State&, double u, double h, State& state) {
    Scaled<System> scaled{*this, system};
    for (std::size_t k = 0; k < table_.size(); ++k) {
      midpoint_.set_steps(static_cast<unsigned short>(midpoints(k)));
      table_[k] = before_;
      midpoint_.do_step(std::ref(scaled), before_, rate_, 0.0, table_[k], u * h);
      for (std::size_t j = k; j-- > 0;) {
        const double ratio = static_cast<double>(midpoints(k)) / static_cast<double>(midpoints(j)), share = 1 / (ratio * ratio - 1);
        for (std::size_t i = 0; i < before.size(); ++i) table_[j][i] = table_[j + 1][i] + share * (table_[j + 1][i] - table_[j][i]);
      }
    }
    multiply(system, table_.front(), state);
  }

  void restart() { stepper_.reset(); }

 private:
  using Algebra = boost::numeric::odeint::range_algebra;

  template <class System>
  struct Scaled {
    BulirschStoerSteps& own;
    System& system;
    long evaluations = 0;
    void operator()(const State& y, State& rate, double s) {
      ++evaluations;
      own.state_ = y, own.state_rate_ = y;
      multiply(system, y, own.state_);
      system(own.state_, own.state_rate_, s);
      divide(system, own.state_rate_, rate);
    }
  };

  template <class System>
  static void divide(const System& system, const State& from, State& to) {
    to.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i] / system.scale(i);
  }
  template <class System>
  static void multiply(const System& system, const State& from, State& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i] * system.scale(i);
  }

  /// Evaluations of column k.
  static constexpr long midpoints(std::size_t k) { return 2 * (static_cast<long>(k) + 1); }
  void columns_of(long evaluations) {
    table_.clear();
    for (; evaluations > 0; evaluations -= midpoints(table_.size() - 1)) table_.emplace_back();
  }

  boost::numeric::odeint::bulirsch_stoer<State, double, State, double, Algebra> stepper_;
  boost::numeric::odeint::modified_midpoint<State, double, State, double, Algebra> midpoint_;
  double next_step_;
  State before_, rate_, after_, state_, state_rate_;
  std::vector<State> table_;  ///< of the extrapolation
  StepTries tries_;
};

}  // namespace scalebreak

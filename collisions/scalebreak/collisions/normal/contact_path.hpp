#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <scalebreak/base/error.hpp>

// The path of one contact in regular variables, and the events on it. Internal to the exact engine.

namespace scalebreak::contact_path {

/// Equation of motion in the law's regular coordinate x, unit mass, with dt = (dδ/dx) ds:
///
///     dx/ds = v,   dv/ds = −(F + c v) dδ/dx,   dt/ds = dδ/dx        state (x, v, t)
template <class T, class Law>
struct RegularMotion {
  using State = std::array<T, 3>;
  Law law;

  [[gnu::always_inline]] void operator()(const State& y, State& rate, T) const {
    const T slope = law.overlap_slope(y[0]);
    rate[0] = y[1];
    rate[1] = -(law.force(y[0]) + law.damping(y[0]) * y[1]) * slope;
    rate[2] = slope;
  }
  [[nodiscard]] T coordinate(const State& y) const { return y[0]; }
  [[nodiscard]] T damping(const State& y) const { return law.damping(y[0]); }
};

/// The same for a law whose dashpot is smooth in w = δ^{1/4} (see RootDamped), in w; x
/// rides along by dx/ds = v (dδ/dw)/(dδ/dx). Only for δ ≥ 0. State (w, v, t, x).
template <class T, class Law>
struct OverlapRootMotion {
  using State = std::array<T, 4>;
  Law law;

  [[gnu::always_inline]] void operator()(const State& y, State& rate, T) const {
    const T slope = 4 * y[0] * y[0] * y[0];
    rate[0] = y[1];
    rate[1] = -(law.force(y[3]) + law.damping_of_root(y[0]) * y[1]) * slope;
    rate[2] = slope;
    rate[3] = y[1] * slope / law.overlap_slope(y[3]);
  }
  [[nodiscard]] T coordinate(const State& y) const { return y[3]; }
  [[nodiscard]] T damping(const State& y) const { return law.damping_of_root(y[0]); }
};

/// How a path ended: at the asked coordinate, by turning back before it, or by dying down above it.
enum class End { separated, turned_back, settled };

template <class T, class Motion>
class Path {
 public:
  using State = typename Motion::State;

  /// `creeps`: overdamped (β ≥ 1), the contact never ends once it has turned.
  Path(Motion motion, const State& start, T tolerance, T max_step, bool creeps)
      : motion_(std::move(motion)),
        state_(start),
        tolerance_(tolerance),
        max_step_(max_step),
        creeps_(creeps),
        next_step_(std::sqrt(std::sqrt(std::sqrt(tolerance)))) {}

  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const State& deepest() const { return deepest_; }
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] T max_force() const { return max_force_; }

  /// Follows the contact inwards and out again to where state[0] falls through `end`. `barrier` is the
  /// potential there: a contact whose energy is below it can never part. `on_step(state)` is told of
  /// the start, every step and the end.
  template <class OnStep>
  End follow(T end, T barrier, bool find_max_force, OnStep&& on_step) {
    const T start_speed = std::abs(state_[1]);
    max_force_ = total_force(state_);
    deepest_ = state_;
    on_step(state_);
    for (;;) {
      const State before = state_;
      const T h = advance();
      if (before[1] > 0 && state_[1] > 0 && state_[0] < before[0]) {  // a dip within one step: look closer
        state_ = before;
        max_step_ = h / 4;
        continue;
      }
      T from = 0;
      if (before[1] > 0 && state_[1] <= 0) {
        const Point turn = root_of_speed(before, T(0), h);
        deepest_ = turn.state;
        from = turn.h;
      }
      if (find_max_force) track_max_force(before, h);
      const bool outgoing = before[1] <= 0 || from > 0;
      if (outgoing && creeps_) return End::settled;
      if (outgoing) {
        Point last{h, state_};
        const bool turned = state_[1] > 0 || (state_[1] == 0 && from == 0);
        // Far below the barrier it does not matter where it turned, and a creeping contact turns nowhere sharply.
        if (turned && energy() > barrier - T(0.01) * start_speed * start_speed) last = root_of_speed(before, from, h);
        if (last.state[0] <= end) {
          state_ = root_of_coordinate(before, end, from, last.h).state;
          on_step(state_);
          return End::separated;
        }
        if (turned) {
          state_ = last.state;
          on_step(state_);
          return End::turned_back;
        }
      }
      on_step(state_);
      // Inwards, so little speed that what it would still go deeper is below rounding.
      if (settled(start_speed, barrier) && (outgoing || std::abs(state_[1]) < T(1e-8) * start_speed)) {
        if (!outgoing) deepest_ = state_;
        return End::settled;
      }
    }
  }

  /// Spring and dashpot together.
  [[nodiscard]] T total_force(const State& y) const { return motion_.law.force(motion_.coordinate(y)) + motion_.damping(y) * y[1]; }

 private:
  using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<State, T, State, T, boost::numeric::odeint::array_algebra>;
  static constexpr int step_cap = 100'000;

  /// One accepted step; returns its length. The step follows the error by a proportional–integral rule
  /// (Hairer & Wanner II, IV.2) for an error of eighth order, which rejects fewer tries than the plain rule.
  T advance() {
    State rate, next, error;
    motion_(state_, rate, T(0));
    for (;;) {
      const T h = max_step_ > 0 ? std::min(next_step_, max_step_) : next_step_;
      stepper_.do_step(std::cref(motion_), state_, rate, T(0), next, h, error);
      T norm = T(1e-8);
      for (std::size_t i = 0; i < next.size(); ++i) norm = std::max(norm, std::abs(error[i]) / (tolerance_ * (1 + std::abs(state_[i]))));
      const bool finite = std::all_of(next.begin(), next.end(), [](T value) { return std::isfinite(value); }) && std::isfinite(norm);
      if (++tries_ > step_cap) throw WorkError(describe(fmt::format("did not end within {} steps", step_cap)));
      const T eighth_root = std::sqrt(std::sqrt(std::sqrt(norm)));
      if (!finite || norm > 1) {
        next_step_ = h * (finite ? std::max(T(0.2), T(0.85) / eighth_root) : T(0.1));
        if (next_step_ > std::numeric_limits<T>::epsilon() * tolerance_) continue;
        throw WorkError(describe(finite ? "stalled (its step fell to zero)" : "left the finite numbers"));
      }
      next_step_ = h * std::clamp(T(0.88) * std::sqrt(last_root_) / eighth_root, T(0.2), T(4));
      last_root_ = eighth_root;
      state_ = next;
      ++steps_;
      return step_ = h;
    }
  }

  [[nodiscard]] State stepped(const State& from, T h) {
    State to;
    stepper_.do_step(std::cref(motion_), from, T(0), to, h);
    return to;
  }

  /// A point of the path: how far into the step, and the state there.
  struct Point {
    T h;
    State state;
  };

  /// Where component k of the path from `before` passes `target`, in (low, high): Newton's iteration kept in
  /// its bracket, on the step itself, so that the event is as exact as the step. It starts from the
  /// crossing of the step's cubic, and the digits it is asked for are those before its last, doubling, step.
  Point root(const State& before, std::size_t k, T target, T low, T high, int digits) {
    if (high <= low) return {low, stepped(before, low)};
    Point last{};
    State rate{};
    const auto value = [&](T h) {
      last = {h, stepped(before, h)};
      motion_(last.state, rate, T(0));
      return std::make_pair(last.state[k] - target, rate[k]);
    };
    std::uintmax_t iterations = 100;
    T found;
    try {
      found =
          boost::math::tools::newton_raphson_iterate(value, cubic_crossing(before, k, target, low, high), low, high, digits, iterations);
    } catch (const boost::math::evaluation_error&) {
      // An overdamped contact that creeps to its equilibrium crosses it by rounding alone: no slope to follow.
      return {high, stepped(before, high)};
    }
    for (std::size_t i = 0; i < last.state.size(); ++i) last.state[i] += rate[i] * (found - last.h);
    last.h = found;
    return last;
  }
  /// The overlap is stationary at a turning point: half the digits give all of its depth.
  Point root_of_speed(const State& before, T low, T high) { return root(before, 1, T(0), low, high, std::numeric_limits<T>::digits / 3); }
  Point root_of_coordinate(const State& before, T end, T low, T high) {
    return root(before, 0, end, low, high, std::numeric_limits<T>::digits / 2 - 4);
  }

  /// Where the cubic through the last step's ends and slopes passes `target`, within (low, high).
  [[nodiscard]] T cubic_crossing(const State& before, std::size_t k, T target, T low, T high) const {
    State rate0, rate1;
    motion_(before, rate0, T(0));
    motion_(state_, rate1, T(0));
    const T h = step_;
    const T rise = state_[k] - before[k];
    const T square = 3 * rise - h * (2 * rate0[k] + rate1[k]);
    const T cube = h * (rate0[k] + rate1[k]) - 2 * rise;
    T left = low / h, right = high / h;
    const auto cubic = [&](T u) { return before[k] - target + u * (h * rate0[k] + u * (square + u * cube)); };
    const T sign = cubic(right) > 0 ? T(1) : T(-1);
    for (int i = 0; i < 24; ++i) {
      const T middle = (left + right) / 2;
      (sign * cubic(middle) > 0 ? right : left) = middle;
    }
    return h * (left + right) / 2;
  }

  /// The largest total force lies in this step if it is higher inside than at both ends.
  void track_max_force(const State& before, T h) {
    const auto minus_force = [&](T s) { return -total_force(stepped(before, s)); };
    const auto [where, value] = boost::math::tools::brent_find_minima(minus_force, T(0), h, std::numeric_limits<T>::digits / 2);
    (void)where;
    max_force_ = std::max({max_force_, -value, total_force(state_)});
  }

  /// A damped contact with less energy than the barrier that has all but stopped: it will never part.
  [[nodiscard]] bool settled(T start_speed, T barrier) const {
    const T speed = state_[1];
    const T missing = barrier - energy();
    return missing > 0 && speed * speed < T(1e-6) * std::min(start_speed * start_speed, missing);
  }

  /// Kinetic and potential, zero at rest at first touch.
  [[nodiscard]] T energy() const { return state_[1] * state_[1] / 2 + motion_.law.energy(motion_.coordinate(state_)); }

  [[nodiscard]] std::string describe(const std::string& what) const {
    return fmt::format("the path of the contact {} at reduced time {:.6g}, coordinate {:.6g}, approach speed {:.6g}", what,
                       static_cast<double>(state_[2]), static_cast<double>(state_[0]), static_cast<double>(state_[1]));
  }

  Motion motion_;
  Stepper stepper_;
  State state_;
  State deepest_{};
  T tolerance_;
  T max_step_;
  bool creeps_;
  T next_step_;
  T last_root_ = 1;  ///< eighth root of the last step's error
  T step_ = 0;       ///< length of the last accepted step
  T max_force_ = 0;
  int steps_ = 0;
  int tries_ = 0;
};

}  // namespace scalebreak::contact_path

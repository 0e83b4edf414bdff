#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

namespace scalebreak {

/// Steps a motion that is smooth between events by `Steps` (EmbeddedSteps, BulirschStoerSteps), and stops on every event. `System` provides
///
///     State                                    a range of doubles
///     operator()(y, rate, s)                   dy/ds
///     event_values(y, values)                  one number per event, at most 0 while it has not happened
///     double scale(i) const                    what an error of component i is measured against
///
/// An event lies where a value passes from at most 0 to above. Values are looked at four times in every step, on the cubic
/// through its ends, and between the looks where a parabola through three of them peaks about zero: a short slip shows itself in that alone. The
/// first that is found is located on the step itself.
template <class System, class Steps>
class EventIntegrator {
 public:
  using State = typename System::State;

  EventIntegrator(System& system, double tolerance, double first_step)
      : system_(system), stepping_(tolerance, first_step), tolerance_(tolerance) {}

  static constexpr int none = -1;

  /// One step from `state`, which it moves to the step's end or to the first event on it; returns that event or `none`.
  int advance(State& state) {
    const bool goes_on = goes_on_ && state == after_;
    before_ = state;
    after_ = before_;
    last_ = before_;
    if (goes_on) {
      std::swap(rate_, end_rate_);
      std::swap(looks_[0], looks_[parts]);
    } else {
      rate_ = before_;
      end_rate_ = before_;
      system_(before_, rate_, 0.0);
      system_.event_values(before_, looks_[0]);
    }
    goes_on_ = false;
    const double h = stepping_.take(system_, before_, rate_, after_, end_rate_, max_step_);
    look(h);
    for (int part = 0; part < parts; ++part) {
      const double from = mark(part), to = mark(part + 1);
      double earliest = 2;
      int first = none;
      for (std::size_t k = 0; k < looks_[0].size(); ++k) {
        const double seen = looks_[static_cast<std::size_t>(part) + 1][k] > 0 ? to : hidden_peak(k, part, h);
        if (!(seen > from)) continue;
        // One that has not happened shortly before the earliest does not matter: most fire because that one has passed.
        if (first != none && !(value_at(k, earliest - 1e-7, h) > 0)) continue;
        const double root = locate(k, from, seen, h);
        if (root < earliest) earliest = root, first = static_cast<int>(k), found_ = last_;
      }
      if (first == none) continue;
      state = found_;
      last_step_ = h, last_end_ = earliest;
      ++steps_;
      return first;
    }
    state = after_;
    goes_on_ = true;
    last_step_ = h, last_end_ = 1;
    ++steps_;
    return none;
  }

  /// The largest value of f(state) on the last step, if it lies inside and exceeds `known`; else `known`. The peak is looked
  /// for on the cubic and then climbed on the step itself.
  template <class F>
  double peak(const F& f, double known) {
    constexpr int looks = 4;
    const auto seen = [&](double u) {
      cubic(u, last_step_, scratch_);
      return f(scratch_);
    };
    const auto exact = [&](double u) {
      scratch_ = before_;
      if (u > 0) state_at(u, last_step_, scratch_);
      return f(scratch_);
    };
    const auto at = [&](int k) { return last_end_ * k / looks; };
    int top = 0;
    double highest = seen(0);
    for (int k = 1; k <= looks; ++k) {
      const double value = seen(at(k));
      if (value > highest) highest = value, top = k;
    }
    constexpr double inward = 1e-3;
    const bool at_an_end = (top == 0 && seen(inward * last_end_) <= highest) || (top == looks && seen((1 - inward) * last_end_) <= highest);
    // Between the marks a smooth peak stands little above them.
    if (at_an_end || highest < 0.8 * known) return known;
    std::uintmax_t iterations = 40;
    const auto lowest = boost::math::tools::brent_find_minima([&](double u) { return -exact(u); }, at(std::max(0, top - 1)),
                                                              at(std::min(looks, top + 1)), 22, iterations);
    return std::max(known, -lowest.second);
  }

  /// The motion has changed its law: no longer what the last steps were like.
  void restart() { stepping_.restart(); }
  void limit_step(double longest) { max_step_ = longest; }
  [[nodiscard]] int steps() const { return steps_; }

 private:
  static constexpr int parts = 3;
  static double mark(int part) { return static_cast<double>(part) / parts; }

  /// All values at the marks of the step after its start; at its end first, where the rate has just been taken.
  void look(double h) {
    system_.event_values(after_, looks_[parts]);
    for (int part = 1; part < parts; ++part) {
      cubic(mark(part), h, middle_);
      system_.event_values(middle_, looks_[static_cast<std::size_t>(part)]);
    }
  }

  /// Where, after mark `part` and before the next, value k rises above zero and falls again, to judge by its looks; else 0.
  double hidden_peak(std::size_t k, int part, double h) {
    for (const int middle : {part, part + 1}) {
      if (middle < 1 || middle >= parts) continue;
      const auto at = [&](int m) { return looks_[static_cast<std::size_t>(m)][k]; };
      const double a = at(middle - 1), b = at(middle), c = at(middle + 1), bend = a - 2 * b + c;
      if (!(bend < 0) || a > 0 || b > 0 || c > 0) continue;
      const double place = (a - c) / (2 * bend), top = b - (a - c) * (a - c) / (8 * bend);
      const double u = mark(middle) + place / parts;
      if (u <= mark(part) || u >= mark(part + 1) || top < -0.1 * (top - std::min(a, c))) continue;
      cubic(u, h, scratch_);
      if (value_of(k, scratch_) > 0) return u;
    }
    return 0;
  }

  /// The state at u of the step by the cubic through its ends and slopes.
  void cubic(double u, double h, State& y) {
    const double v = 1 - u, a = v * v * (1 + 2 * u), b = u * u * (3 - 2 * u), c = h * u * v * v, d = -h * u * u * v;
    y = before_;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = a * before_[i] + b * after_[i] + c * rate_[i] + d * end_rate_[i];
  }

  double value_of(std::size_t k, const State& y) {
    system_.event_values(y, scratch_values_);
    return scratch_values_[k];
  }

  /// Value k at u of the step, on the step itself; `last_` is the state there.
  double value_at(std::size_t k, double u, double h) {
    state_at(std::max(u, 0.0), h, last_);
    return value_of(k, last_);
  }

  void state_at(double u, double h, State& y) { stepping_.at(system_, before_, rate_, end_rate_, u, h, y); }

  /// Where value k passes zero between `from` and `to` of the step, 2 if it does not; `last_` is the state just past it.
  double locate(std::size_t k, double from, double to, double h) {
    const auto exact = [&](double u) { return value_at(k, u, h); };
    const auto estimate = [&](double u) {
      cubic(u, h, scratch_);
      return value_of(k, scratch_);
    };
    // On the cubic first: it is cheap.
    double low = from, high = to;
    while (high - low > 1e-3) {
      const double middle = (low + high) / 2;
      (estimate(middle) > 0 ? high : low) = middle;
    }
    // Then on the step itself, by secants from the cubic's slope; to just past the root, so that it is not found again.
    const double past = std::max(1e-14, 1e-4 * std::min(tolerance_, 1e-6));
    double u = high, value = exact(u), slope = (estimate(high) - estimate(low)) / (high - low);
    double last_u = u, last_value = value;
    // A value that falls through zero, as one that has just been dealt with may, is no event.
    for (int i = 0; i < 8 && slope > 0; ++i) {
      u = last_u - last_value / slope + past / 2;
      if (u < from || u > 1) break;
      value = exact(u);
      if (std::abs(u - last_u) > 1e-15) slope = (value - last_value) / (u - last_u);
      if (value > 0 && slope > 0 && (std::abs(u - last_u) <= past || value / slope <= past)) return u;
      last_u = u;
      last_value = value;
    }
    return bracketed(exact, from, to);
  }

  /// The same where secants fail: a root next to another, or at the step's start.
  template <class Exact>
  double bracketed(const Exact& exact, double low, double high) {
    double at_low = low > 0 ? exact(low) : -std::numeric_limits<double>::min(), at_high = exact(high);
    if (!(at_high > 0)) {
      high = 1;
      at_high = exact(high);
      if (!(at_high > 0)) return 2;  // the cubic saw what the step does not hold
    }
    // Above zero at once: it counts if it stays there, and else where it rises again.
    if (at_low > 0) {
      const double width = high - low, start = low;
      for (const double share : {0.003, 0.03, 0.1, 0.3, 0.6, 0.9}) {
        at_low = exact(low = start + share * width);
        if (at_low <= 0) break;
      }
      if (at_low > 0) return (void)exact(start), start;
    }
    if (at_low == 0) at_low = -std::numeric_limits<double>::min();
    std::uintmax_t iterations = 100;
    const auto close = [](double a, double b) { return b - a <= 1e-15 + 4 * std::numeric_limits<double>::epsilon() * b; };
    const auto [a, b] = boost::math::tools::toms748_solve(exact, low, high, at_low, at_high, close, iterations);
    (void)a;
    (void)exact(b);
    return b;
  }

  System& system_;
  Steps stepping_;
  double tolerance_;
  double max_step_ = std::numeric_limits<double>::infinity();
  bool goes_on_ = false;  ///< has the last step ended without an event, so that `end_rate_` and the last look are of where the next begins?
  State before_{}, after_{}, rate_{}, end_rate_{}, middle_{}, last_{}, found_{}, scratch_{};
  std::array<typename System::Values, parts + 1> looks_{};
  typename System::Values scratch_values_{};
  double last_step_ = 0, last_end_ = 1;  ///< of the last step: its length, and the share of it that was gone
  int steps_ = 0;
};

}  // namespace scalebreak

#include <scalebreak/collisions/normal/reference_collision.hpp>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/contact/reduced.hpp>

namespace scalebreak {
namespace {

using Function = std::function<double(double)>;

double call(double x, void* function) { return (*static_cast<Function*>(function))(x); }

void check(int status, const char* what) {
  if (status != GSL_SUCCESS) throw WorkError(fmt::format("the second method's {} failed: {}", what, gsl_strerror(status)));
}

double root(Function f, double low, double high) {
  std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent),
                                                                        gsl_root_fsolver_free);
  gsl_function g{call, &f};
  check(gsl_root_fsolver_set(solver.get(), &g, low, high), "bracket");
  for (int i = 0; i < 200; ++i) {
    check(gsl_root_fsolver_iterate(solver.get()), "root");
    const double a = gsl_root_fsolver_x_lower(solver.get()), b = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(a, b, 0, 4e-16) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

double integral(Function f, double low, double high) {
  if (high <= low) return 0;
  std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> space(gsl_integration_workspace_alloc(2000),
                                                                                         gsl_integration_workspace_free);
  gsl_function g{call, &f};
  double value = 0, error = 0;
  check(gsl_integration_qag(&g, low, high, 0, 1e-13, 2000, GSL_INTEG_GAUSS61, space.get(), &value, &error), "quadrature");
  return value;
}

/// ½v² + U(x) is kept; time is ∫ dδ/v. The turning point's square root goes with x = x_max − u², and an end
/// reached at rest is as regular.
template <class Law>
NormalOutcome<double> undamped(const Law& law, double speed) {
  const double kinetic = speed * speed / 2;
  const double barrier = law.energy(law.separation());
  NormalOutcome<double> outcome;
  double high = 2 * std::max(law.touch(), 1.0);
  while (law.energy(high) < kinetic) high *= 2;
  const double turn = root([&](double x) { return law.energy(x) - kinetic; }, law.touch(), high);
  outcome.max_coordinate = turn;
  outcome.max_overlap = law.overlap(turn);
  outcome.energy_residue = kinetic - barrier;
  outcome.stuck = outcome.energy_residue < 0;
  if (outcome.stuck) return outcome;
  outcome.restitution = std::sqrt(std::max(2 * outcome.energy_residue, 0.0)) / speed;
  const auto time_from = [&](double start) {
    return integral(
        [&](double u) {
          const double x = turn - u * u;
          // U(turn) − U(x) over u², so that no digits cancel near the turn.
          const double fall =
              u < 1e-4 ? law.force(turn - u * u / 2) * law.overlap_slope(turn - u * u / 2) : (kinetic - law.energy(x)) / (u * u);
          return 2 * law.overlap_slope(x) / std::sqrt(2 * fall);
        },
        0, std::sqrt(turn - start));
  };
  outcome.contact_time = time_from(law.touch()) + time_from(law.separation());
  return outcome;
}

/// y = (x, v, t) over the regular parameter s, for any law, by GSL.
template <class Law>
struct Motion {
  Law law;
  static int rate(double, const double y[], double f[], void* self) {
    const Law& law = static_cast<Motion*>(self)->law;
    const double slope = law.overlap_slope(y[0]);
    f[0] = y[1];
    f[1] = -(law.force(y[0]) + law.damping(y[0]) * y[1]) * slope;
    f[2] = slope;
    return GSL_SUCCESS;
  }
};

/// Follows y until `event(y)` falls through zero on the way out, or v turns back before; true if the event came.
bool follow(gsl_odeiv2_system system, std::vector<double>& y, const std::function<double(const std::vector<double>&)>& event,
            std::vector<double>& deepest) {
  const gsl_odeiv2_step_type* type = gsl_odeiv2_step_rk8pd;
  std::unique_ptr<gsl_odeiv2_step, void (*)(gsl_odeiv2_step*)> step(gsl_odeiv2_step_alloc(type, y.size()), gsl_odeiv2_step_free);
  std::vector<double> error(y.size());
  const auto stepped = [&](const std::vector<double>& from, double h) {
    std::vector<double> to = from;
    check(gsl_odeiv2_step_apply(step.get(), 0, h, to.data(), error.data(), nullptr, nullptr, &system), "step");
    return to;
  };
  double h = 0.02;
  for (int count = 0; count < 200'000; ++count) {
    const std::vector<double> next = stepped(y, h);
    double worst = 1e-4;
    for (std::size_t i = 0; i < y.size(); ++i) worst = std::max(worst, std::abs(error[i]) / (1e-14 * (1 + std::abs(y[i]))));
    if (!(worst <= 1)) {
      h *= std::isfinite(worst) ? std::max(0.2, 0.8 * std::pow(worst, -1.0 / 8)) : 0.1;
      continue;
    }
    const auto at = [&](double s) { return stepped(y, s); };
    double from = 0;
    if (y[1] > 0 && next[1] <= 0) {
      from = root([&](double s) { return at(s)[1]; }, 0, h);
      deepest = at(from);
    }
    if (y[1] <= 0 || from > 0) {
      const bool back = next[1] > 0;
      const double until = back ? root([&](double s) { return at(s)[1]; }, from > 0 ? from : 0, h) : h;
      if (event(at(until)) <= 0) {
        y = at(root([&](double s) { return event(at(s)); }, from, until));
        return true;
      }
      if (back) {
        y = at(until);
        return false;
      }
    }
    y = next;
    h *= std::min(3.0, 0.8 * std::pow(worst, -1.0 / 9));
  }
  throw WorkError("the second method did not reach the end of the contact");
}

template <class Law>
NormalOutcome<double> damped(const Law& law, double speed) {
  Motion<Law> motion{law};
  std::vector<double> y{law.touch(), speed, 0}, deepest;
  const double end = law.separation();
  const bool separated = follow(
      {Motion<Law>::rate, nullptr, 3, &motion}, y, [&](const auto& at) { return at[0] - end; }, deepest);
  NormalOutcome<double> outcome;
  outcome.max_coordinate = deepest[0];
  outcome.max_overlap = law.overlap(deepest[0]);
  outcome.stuck = !separated;
  outcome.energy_residue = y[1] * y[1] / 2 + (separated ? 0.0 : law.energy(y[0]) - law.energy(end));
  if (separated) outcome.restitution = -y[1] / speed, outcome.contact_time = y[2];
  return outcome;
}

/// A dashpot that is smooth in w = δ^{1/4} (see RootDamped): w, and x = √a from the branch-free root, no coordinate carried along; below
/// zero overlap nothing damps, so energy and quadrature finish.
template <class Law>
struct RootMotion {
  Law law;
  static int rate(double, const double y[], double f[], void* self) {
    const Law& law = static_cast<RootMotion*>(self)->law;
    const double w = y[0], slope = 4 * w * w * w;
    f[0] = y[1];
    f[1] = -(law.force(law.coordinate(w * w * w * w)) + law.damping_of_root(w) * y[1]) * slope;
    f[2] = slope;
    return GSL_SUCCESS;
  }
};

template <class Law>
NormalOutcome<double> damped_on_overlap(const Law& law, double speed) {
  RootMotion<Law> motion{law};
  std::vector<double> y{0, speed, 0}, deepest;
  const bool touched = follow(
      {RootMotion<Law>::rate, nullptr, 3, &motion}, y, [](const auto& at) { return at[0]; }, deepest);
  const double depth = std::pow(deepest[0], 4), barrier = law.energy(law.separation());
  NormalOutcome<double> outcome{.max_overlap = depth, .max_coordinate = law.coordinate(depth)};
  outcome.energy_residue = y[1] * y[1] / 2 - barrier + (touched ? 0.0 : law.energy(law.coordinate(std::pow(y[0], 4))));
  outcome.stuck = outcome.energy_residue < 0;
  if (outcome.stuck) return outcome;
  outcome.restitution = std::sqrt(2 * outcome.energy_residue) / speed;
  const double start = law.touch(), end = law.separation();
  outcome.contact_time =
      y[2] + integral([&](double x) { return law.overlap_slope(x) / std::sqrt(y[1] * y[1] - 2 * law.energy(x)); }, end, start);
  return outcome;
}

}  // namespace

NormalOutcome<double> resolve_by_second_method(const ContactKind& kind, double beta, double reduced_speed) {
  gsl_set_error_handler_off();
  const double speed = kind.adhesive() ? reduced_speed : 1.0;
  return visit_form(kind, [&]<template <class> class Law>(LawForm<Law>) {
    if (beta == 0) return undamped(reduced_law<Law>(0.0, kind.range), speed);
    if constexpr (RootDamped<Law<double>>) {
      return damped_on_overlap(reduced_law<Law>(beta, kind.range), speed);
    } else {
      return damped(reduced_law<Law>(beta, kind.range), speed);
    }
  });
}

}  // namespace scalebreak

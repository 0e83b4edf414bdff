#include <scalebreak/ensembles/prediction/cooling_gas.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace scalebreak {
namespace {

/// What friction does. The tangential impulse over the mass is P = min(A v, B w), v the speed of approach, w that of the surfaces: A = μ(1 + e)/2 while they slide,
/// and B = I/(2(1 + I)) brings them to rest. v² and w² have exponential distributions, of means 4T and 4S with S = T + R/I, so that P² has one too.
struct FrictionImpulse {
  double squared = 0;    ///< ⟨P²⟩
  double on_motion = 0;  ///< ⟨P w⟩
};

FrictionImpulse friction_impulse(const RoughCollision& c, double temperature, double surface) {
  if (c.friction == 0) return {};
  const double slides = c.friction * (1 + c.restitution) / 2, holds = c.inertia / (2 * (1 + c.inertia));
  const double sliding = 4 * temperature * slides * slides, held = 4 * surface * holds * holds;  // ⟨(Av)²⟩ and ⟨(Bw)²⟩
  const double rate = 1 / sliding + 1 / held, z = std::sqrt(held / sliding), q = 1 + z * z;
  // ⟨P w⟩ = ⟨(Bw)²; Bw < Av⟩/B + ⟨Av Bw; Av < Bw⟩/B
  const double where_held = 1 / (held * rate * rate);
  const double where_sliding = std::sqrt(sliding * held) / 2 * (std::atan(z) + z * (z * z - 1) / (q * q));
  return {1 / rate, (where_held + where_sliding) / holds};
}

}  // namespace

double sticking_share(double sticking_speed, double temperature) {
  return -std::expm1(-sticking_speed * sticking_speed / (4 * temperature));
}

GasTemperatures change_by_collision(const RoughCollision& c, const GasTemperatures& at) {
  const double t = at.translational, r = at.rotational, surface = t + r / c.inertia;
  const FrictionImpulse impulse = friction_impulse(c, t, surface);
  const double bounced = c.restitution * c.restitution * (1 - sticking_share(c.sticking_speed, t));
  return {-(1 - bounced) * t + impulse.squared - impulse.on_motion * t / surface,
          impulse.squared / c.inertia - impulse.on_motion * (r / c.inertia) / surface};
}

CooledGas cool(const CoolingGas& gas, double rarer) {
  using State = std::array<double, 5>;  // T, R, and the integrals of T, R and collision rate over time
  constexpr double step = 0.2, alike = 1e-12;
  const auto busy_at = [&](double t) { return gas.busy * std::pow(t / gas.temperature, (1 - gas.contact_time_power) / 2); };
  const auto rate_at = [&](double t) { return gas.collision_rate * std::sqrt(t / gas.temperature) * std::pow(1 + busy_at(t), rarer); };
  const auto slope = [&](const State& y) -> State {
    const double rate = rate_at(y[0]);
    const GasTemperatures change = change_by_collision(gas.collision, {y[0], y[1]});
    return {rate / 3 * change.translational, rate / 3 * change.rotational, y[0], y[1], rate};
  };
  const auto moved = [](const State& y, const State& k, double h) {
    State to;
    for (std::size_t i = 0; i < y.size(); ++i) to[i] = y[i] + h * k[i];
    return to;
  };
  State y = {gas.temperature, 0, 0, 0, 0};
  const auto run_to = [&](double from, double to) {
    for (double time = from; to - time > alike * to;) {
      const State a = slope(y);
      const double h = std::min(step / a[4], to - time);
      const State b = slope(moved(y, a, h / 2)), c = slope(moved(y, b, h / 2)), d = slope(moved(y, c, h));
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
      time += h;
    }
  };
  run_to(0, gas.begin);
  y[2] = y[3] = y[4] = 0;
  const double duration = gas.end - gas.begin;
  run_to(gas.begin, gas.end);
  CooledGas cooled{.mean = {y[0], y[1]}, .collision_rate = rate_at(y[0]), .last_temperature = y[0]};
  if (duration > 0) cooled.mean = {y[2] / duration, y[3] / duration}, cooled.collision_rate = y[4] / duration;
  cooled.busy = busy_at(cooled.mean.translational);
  return cooled;
}

}  // namespace scalebreak

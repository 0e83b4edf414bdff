#include <scalebreak/collisions/normal/normal_collision.hpp>

#include <cmath>

#include <scalebreak/collisions/normal/contact_path.hpp>
#include <scalebreak/contact/reduced.hpp>

namespace scalebreak {
namespace {

using contact_path::End;

/// Turns the work units of a path into the reduced units of its kind.
template <class T>
struct WorkUnits {
  T coordinate = 1, overlap = 1, time = 1, force = 1;
  [[nodiscard]] T speed() const { return overlap / time; }
};

template <class T>
struct Resolver {
  const CollisionOptions<T>& options;
  bool creeps;
  bool undamped;
  T step_tolerance;
  WorkUnits<T> units{};
  NormalOutcome<T> outcome{};

  template <class Motion>
  auto observer(const Motion& motion) const {
    return [this, motion](const typename Motion::State& y) {
      if (!options.observer) return;
      const T x = motion.coordinate(y);
      options.observer({y[2] * units.time, x * units.coordinate, motion.law.overlap(x) * units.overlap, y[1] * units.speed(),
                        motion.law.force(x) * units.force, motion.damping(y) * y[1] * units.force});
    };
  }

  /// Follows one stretch of the contact; returns how it ended and its last state.
  template <class Motion>
  std::pair<End, typename Motion::State> follow(const Motion& motion, const typename Motion::State& start, T end, T barrier) {
    contact_path::Path<T, Motion> path(motion, start, step_tolerance, options.max_step, creeps);
    const auto ended = path.follow(end, barrier, options.find_max_force, observer(motion));
    outcome.steps += path.steps();
    outcome.max_force = std::max(outcome.max_force, path.max_force() * units.force);
    if (start[1] > 0) {
      outcome.max_coordinate = motion.coordinate(path.deepest()) * units.coordinate;
      outcome.max_overlap = motion.law.overlap(motion.coordinate(path.deepest())) * units.overlap;
    }
    return {ended, path.state()};
  }

  /// `residue` as the path has it; where nothing damps the energy balance knows it better.
  void finish(T incoming, T time, T residue, T barrier) {
    if (undamped) residue = incoming * incoming / 2 - barrier;
    outcome.stuck = residue < 0 || creeps;
    outcome.energy_residue = residue * units.speed() * units.speed();
    if (outcome.stuck) return;
    outcome.restitution = std::sqrt(2 * residue) / incoming;
    outcome.contact_time = time * units.time;
  }

  /// A law that is smooth in its regular coordinate all the way.
  template <class Law>
  void resolve_smooth(const Law& law, T speed) {
    const contact_path::RegularMotion<T, Law> motion{law};
    const T barrier = law.energy(law.separation());
    const auto [ended, y] = follow(motion, {law.touch(), speed, T(0)}, law.separation(), barrier);
    const T energy = y[1] * y[1] / 2;
    finish(speed, y[2], ended == End::separated ? energy : below(energy + law.energy(y[0]) - barrier), barrier);
  }

  /// A dashpot on the overlap that is not smooth in the law's coordinate: damped in w = δ^{1/4} down to zero overlap, free below it.
  template <class Law>
  void resolve_root_damped(const Law& law, T speed) {
    const contact_path::OverlapRootMotion<T, Law> motion{law};
    const T barrier = law.energy(law.separation());
    const auto [ended, y] = follow(motion, {T(0), speed, T(0), law.touch()}, T(0), barrier);
    const T energy = y[1] * y[1] / 2;
    if (ended != End::separated) return finish(speed, y[2], below(energy + law.energy(y[3]) - barrier), barrier);
    const T residue = energy - barrier;
    if (law.separation() >= law.touch() || residue < 0) return finish(speed, y[2], residue, barrier);
    const auto free = law.undamped();
    const contact_path::RegularMotion<T, std::decay_t<decltype(free)>> free_motion{free};
    const auto [parted, z] = follow(free_motion, {law.touch(), y[1], y[2]}, law.separation(), barrier);
    finish(speed, z[2], residue, barrier);
  }

  /// A pair that turned back lacks energy, by rounding at least.
  static T below(T residue) { return std::min(residue, -std::numeric_limits<T>::min()); }

  template <class Law>
  void resolve(AdhesionRange range, T beta, T reduced_speed) {
    NormalPairOf<T> pair = Law::reduced_pair(beta);
    T speed = 1;
    if constexpr (Law::traits.adhesive()) {
      // Slow impacts in the units of the adhesion, fast ones in those of the impact: all numbers stay near 1.
      if (reduced_speed > 1) {
        pair = Law::pair_of_unit_impact(beta, reduced_speed);
      } else {
        speed = reduced_speed;
      }
    }
    const auto scales = Law::scales(pair, speed);
    units = {1 / scales.coordinate, 1 / scales.overlap, 1 / scales.time, 1 / scales.force};
    const Law law = Law::make(pair, range);
    if constexpr (RootDamped<Law>) {
      resolve_root_damped(law, speed);
    } else {
      resolve_smooth(law, speed);
    }
  }
};

}  // namespace

template <class T>
NormalOutcome<T> resolve_normal_collision(const ContactKind& kind, T damping_ratio, T reduced_speed, const CollisionOptions<T>& options) {
  if (!(reduced_speed > 0) || !std::isfinite(reduced_speed) || !(damping_ratio >= 0) || !std::isfinite(damping_ratio)) {
    throw WorkError(fmt::format("a collision needs a positive speed and a damping ratio of at least 0, found {} and {}",
                                static_cast<double>(reduced_speed), static_cast<double>(damping_ratio)));
  }
  // The error of a step is held to half the tolerance, to leave room for the sum over the steps. What a slow pair has left at
  // separation is the small difference of energies of order 1: they must be as much better.
  constexpr T finest = 4 * std::numeric_limits<T>::epsilon();
  const T slow = kind.adhesive() ? std::min(T(1), reduced_speed * reduced_speed) : T(1);
  Resolver<T> resolver{options, damping_ratio >= 1, damping_ratio == 0, std::max(finest, options.tolerance / 2 * slow)};
  visit_form(
      kind, [&]<template <class> class Law>(LawForm<Law>) { resolver.template resolve<Law<T>>(kind.range, damping_ratio, reduced_speed); });
  if (!resolver.outcome.stuck && damping_ratio > 0 && slow < 1e-9) {
    throw WorkError(fmt::format(
        "a contact of damping ratio {:g} parts again at a reduced speed of {:g}, so slow that rounding, not its dashpot, decides the restitution",
        static_cast<double>(damping_ratio), static_cast<double>(reduced_speed)));
  }
  return resolver.outcome;
}

template <class T>
T reduced_sticking_speed(const ContactKind& kind, T damping_ratio, T tolerance) {
  if (!kind.adhesive()) return T(0);
  if (damping_ratio >= 1) return std::numeric_limits<T>::infinity();
  if (kind.range == AdhesionRange::touch && damping_ratio == 0) return T(0);
  const CollisionOptions<T> options{.tolerance = tolerance};
  const auto residue = [&](T speed) { return resolve_normal_collision(kind, damping_ratio, speed, options).energy_residue; };
  // Undamped, the barrier alone decides; damping only raises the speed that is needed.
  const T barrier = visit_form(kind, [&]<template <class> class Law>(LawForm<Law>) {
    const Law<T> law = reduced_law<Law>(T(0), kind.range);
    return law.energy(law.separation());
  });
  const T undamped = std::sqrt(2 * barrier);
  if (damping_ratio == 0) return undamped;
  // A contact that ends at touch loses a fixed share of β in the slowest collisions: v_s ∝ √β, from where rounding is small.
  constexpr T least = T(1e-7);
  if (undamped == 0 && damping_ratio < least) return std::sqrt(damping_ratio / least) * reduced_sticking_speed(kind, least, tolerance);
  // In the squared speed the residue is nearly a line.
  const auto of_square = [&](T square) { return residue(std::sqrt(square)); };
  T low = undamped > 0 ? undamped * undamped : damping_ratio, high = low;
  T at_low = of_square(low), at_high = at_low;
  while (at_low > 0) high = low, at_high = at_low, at_low = of_square(low /= 2);
  while (at_high < 0) low = high, at_low = at_high, at_high = of_square(high *= 2);
  std::uintmax_t iterations = 100;
  const auto close = [&](T a, T b) { return std::abs(a - b) <= tolerance * std::abs(b); };
  const auto [left, right] = boost::math::tools::toms748_solve(of_square, low, high, at_low, at_high, close, iterations);
  return std::sqrt((left + right) / 2);
}

template NormalOutcome<double> resolve_normal_collision(const ContactKind&, double, double, const CollisionOptions<double>&);
template NormalOutcome<long double> resolve_normal_collision(const ContactKind&, long double, long double,
                                                             const CollisionOptions<long double>&);
template double reduced_sticking_speed(const ContactKind&, double, double);
template long double reduced_sticking_speed(const ContactKind&, long double, long double);

}  // namespace scalebreak

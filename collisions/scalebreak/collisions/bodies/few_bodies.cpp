#include <scalebreak/collisions/bodies/few_bodies.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <boost/numeric/odeint/algebra/range_algebra.hpp>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/bodies/few_body_system.hpp>
#include <scalebreak/collisions/event_integrator.hpp>
#include <scalebreak/collisions/steps/bulirsch_stoer_steps.hpp>
#include <scalebreak/collisions/steps/embedded_steps.hpp>

namespace scalebreak {
namespace {

/// Kinetic energy about the common centre of mass; where a body is held, all of it.
double inner_kinetic_energy(const std::vector<MovingBody>& bodies) {
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  double mass = 0;
  for (const MovingBody& body : bodies) {
    if (!std::isfinite(body.mass)) return kinetic_energy(bodies);
    mass += body.mass;
    drift += (body.velocity - drift) * (body.mass / mass);
  }
  double sum = 0;
  for (const MovingBody& body : bodies) {
    sum += body.mass * (body.velocity - drift).squaredNorm() / 2 + body.inertia * body.spin.squaredNorm() / 2;
  }
  return sum;
}

/// Follows a system through its links' lives and keeps count.
class Motion {
 public:
  Motion(std::vector<MovingBody> bodies, const std::function<MappedLaws(int, int)>& laws, const MotionOptions& options)
      : options_(options), system_(std::move(bodies), laws, options.duration), state_(system_.start()) {
    outcome_.before = system_.account(state_);
    first_kinetic_ = inner_kinetic_energy(system_.bodies(state_));
  }

  MotionOutcome run() {
    std::vector<FewBodySystem::Change> begun;
    system_.begin(state_, begun);
    note(begun);
    observe();
    while (!system_.duration_over()) {
      if (system_.links().empty()) {
        std::vector<FewBodySystem::Change> changes;
        const bool meets = system_.fly(state_, changes);
        note(changes);
        observe();
        if (!meets) break;
      }
      if (follow()) break;
    }
    outcome_.bodies = system_.bodies(state_);
    outcome_.time = system_.time(state_);
    outcome_.after = system_.account(state_);
    outcome_.force_evaluations = system_.force_evaluations();
    for (const Link& link : system_.links()) outcome_.open_contacts += link.touching;
    return std::move(outcome_);
  }

 private:
  template <template <class, class> class Pair>
  using By = EmbeddedSteps<FewBodySystem::State, Pair<FewBodySystem::State, boost::numeric::odeint::range_algebra>>;

  /// From one change of the links to the next; true if all rests.
  bool follow() {
    switch (options_.stepper) {
      case Stepper::cash_karp54: return follow_by<By<CashKarp54>>();
      case Stepper::dopri5: return follow_by<By<DormandPrince54>>();
      case Stepper::dopri5_dense: return follow_by<By<DenseDormandPrince54>>();
      case Stepper::bulirsch_stoer: return follow_by<BulirschStoerSteps>();
      case Stepper::fehlberg78: break;
    }
    return follow_by<By<Fehlberg78>>();
  }

  template <class Steps>
  bool follow_by() {
    EventIntegrator<FewBodySystem, Steps> integrator(system_, options_.tolerance / 16, next_step_);
    double longest = options_.sample_interval / system_.time_unit();
    for (;;) {
      if (options_.sample_interval > 0) {
        // Where time hardly goes on, steps may grow.
        longest = std::min(options_.sample_interval / system_.time_rate(state_), 2 * longest);
        integrator.limit_step(longest);
      }
      const std::size_t size = state_.size();
      const int event = integrator.advance(state_);
      ++outcome_.steps;
      if (options_.find_max_force) {
        outcome_.max_force = integrator.peak([this](const auto& y) { return system_.largest_force(y); }, outcome_.max_force);
      }
      observe();
      track();
      if (event == integrator.none) {
        if (settled() || (outcome_.steps % steps_between_looks == 0 && at_rest())) return outcome_.resting = true;
        continue;
      }
      const auto last_links = system_.links();
      turned(last_links);
      refuse_endless_events(system_.bodies_of(static_cast<std::size_t>(event)));
      const auto changes = system_.apply(static_cast<std::size_t>(event), state_);
      note(changes);
      if (++events_ > event_cap(options_)) {
        throw WorkError(fmt::format(
            "the motion has not ended after {} events of its contacts; give {}", events_ - 1,
            options_.duration > 0 ? "a shorter run.duration" : "its [[body]] scene a run.duration (a [pair] can be written as one)"));
      }
      // What has come to rest to rounding may have no other end.
      if (at_rest() || (changes.empty() && settled())) return outcome_.resting = true;
      if (state_.size() != size || system_.duration_over()) {
        observe();
        return false;
      }
      integrator.restart();
    }
  }

  /// Whoever gives no duration expects an end.
  static int event_cap(const MotionOptions& options) { return options.duration > 0 ? 1'000'000 : 50'000; }
  static constexpr int most_at_an_instant = 2'000;
  static constexpr int settled_steps = 30;
  static constexpr int steps_between_looks = 20;

  bool at_rest() const { return options_.duration == 0 && system_.rests(state_); }

  /// A contact that only creeps never turns back: what moves no more, step after step, rests. Time must go on meanwhile, which it
  /// hardly does where several contacts begin at once.
  bool settled() {
    if (options_.duration > 0) return false;
    const double moving = inner_kinetic_energy(system_.bodies(state_)), time = system_.time(state_);
    if (std::abs(moving - last_kinetic_) >= 1e-15 * moving + 1e-18 * first_kinetic_) still_ = 0, still_since_ = time;
    last_kinetic_ = moving;
    return ++still_ > settled_steps && time - still_since_ > system_.time_unit();
  }

  /// A contact that lets go and holds again while time stands still has no motion that its laws agree on.
  void refuse_endless_events(const std::array<int, 2>& between) {
    const double time = system_.time(state_);
    if (time - instant_ > 1e-9 * system_.time_unit()) instant_ = time, at_instant_ = 0;
    if (++at_instant_ <= most_at_an_instant || between[0] < 0) return;
    throw WorkError(fmt::format(
        "the contact of bodies {} and {} lets go and holds again without end at {:.6g} s: its laws contradict each other there; "
        "give a run.duration that ends before, a finer numerics.tolerance, or another contact.rolling",
        between[0] + 1, between[1] + 1, time));
  }

  /// Beyond the smaller radius the centres are about to pass each other, and no contact law means anything.
  void refuse_deep_overlap() const {
    const FewBodySystem::Deepest deepest = system_.deepest(state_);
    if (!(deepest.overlap > deepest.radius)) return;
    throw WorkError(
        fmt::format("bodies {} and {} overlap by {:g} m, more than the smaller radius of {:g} m, where no contact law holds; "
                    "give a stiffer material, less softening or slower bodies",
                    deepest.first + 1, deepest.second + 1, deepest.overlap, deepest.radius));
  }

  void track() {
    refuse_deep_overlap();
    outcome_.max_overlap = std::max(outcome_.max_overlap, system_.largest_overlap(state_));
    outcome_.max_depth = std::max(outcome_.max_depth, system_.largest_depth(state_));
    outcome_.max_force = std::max(outcome_.max_force, system_.largest_force(state_));
  }

  void turned(const std::vector<Link>& links) {
    for (const Link& link : links) {
      if (link.touching) outcome_.turned = std::max(outcome_.turned, system_.turned(state_, link));
    }
  }

  void note(const std::vector<FewBodySystem::Change>& changes) {
    for (const auto& change : changes) {
      switch (change.what) {
        case ContactChange::touch:
          ++outcome_.touches;
          if (outcome_.first_touch < 0) outcome_.first_touch = system_.time(state_);
          break;
        case ContactChange::separation: outcome_.last_separation = system_.time(state_); break;
        case ContactChange::rupture: ++outcome_.ruptures; break;
        case ContactChange::slide: ++outcome_.slides; break;
        case ContactChange::roll: ++outcome_.rolls; break;
        default: break;
      }
      if (options_.on_change) options_.on_change(system_.time(state_), change.first, change.second, change.what);
    }
  }

  void observe() {
    if (!options_.observer) return;
    const std::vector<MovingBody> bodies = system_.bodies(state_);
    options_.observer({system_.time(state_), bodies, system_.account(state_), system_.largest_overlap(state_),
                       options_.sample_contacts ? system_.contacts(state_) : std::vector<ContactState>{}});
  }

  const MotionOptions& options_;
  FewBodySystem system_;
  FewBodySystem::State state_;
  MotionOutcome outcome_;
  double next_step_ = 0.02;
  double first_kinetic_ = 0, last_kinetic_ = -1, still_since_ = 0;
  int still_ = 0, events_ = 0, at_instant_ = 0;
  double instant_ = -1;  ///< when the last events were
};

}  // namespace

MotionOutcome move_bodies(std::vector<MovingBody> bodies, const std::function<MappedLaws(int, int)>& laws, const MotionOptions& options) {
  return Motion(std::move(bodies), laws, options).run();
}

const char* to_string(ContactChange change) {
  switch (change) {
    case ContactChange::touch: return "touch";
    case ContactChange::separation: return "separation";
    case ContactChange::slide: return "slide";
    case ContactChange::stick: return "stick";
    case ContactChange::roll: return "roll";
    case ContactChange::roll_stop: return "roll_stop";
    case ContactChange::bridge: return "bridge";
    case ContactChange::rupture: break;
  }
  return "rupture";
}

Eigen::Vector3d momentum(const std::vector<MovingBody>& bodies) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const MovingBody& body : bodies) {
    if (std::isfinite(body.mass)) sum += body.mass * body.velocity;
  }
  return sum;
}

Eigen::Vector3d angular_momentum(const std::vector<MovingBody>& bodies) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const MovingBody& body : bodies) {
    if (std::isfinite(body.mass)) sum += body.mass * body.position.cross(body.velocity) + body.inertia * body.spin;
  }
  return sum;
}

double kinetic_energy(const std::vector<MovingBody>& bodies) {
  double sum = 0;
  for (const MovingBody& body : bodies) {
    if (std::isfinite(body.mass)) sum += body.mass * body.velocity.squaredNorm() / 2 + body.inertia * body.spin.squaredNorm() / 2;
  }
  return sum;
}

}  // namespace scalebreak

#include <scalebreak/collisions/oblique/oblique_collision.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

#include <boost/numeric/odeint/algebra/array_algebra.hpp>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/event_integrator.hpp>
#include <scalebreak/collisions/steps/embedded_steps.hpp>
#include <scalebreak/contact/normal_point.hpp>
#include <scalebreak/contact/slider.hpp>

namespace scalebreak {
namespace {

enum Component : std::size_t {
  root,
  coordinate,
  approach,
  sliding,
  spin1,
  spin2,
  slide_history,
  roll_history,
  time,
  displacement,
  turned,
  components
};

/// How large each quantity of a collision is.
struct Scales {
  double coordinate, overlap, speed, time;
};

template <class Law>
Scales scales_of(const Law& law, double mass, double speed) {
  // The coordinate that the energy of the impact, or the depth of the well, reaches.
  const double bottom = law.bottom();
  const double depth = bottom > 0 ? -law.energy(bottom) : 0.0, wanted = mass * speed * speed / 2;
  double x = bottom > 0 ? bottom : 1e-12;
  while (law.energy(x) < wanted) x *= 1.25;
  const double typical = std::sqrt(speed * speed + 2 * depth / mass);
  return {x, law.overlap(x), typical, law.overlap(x) / typical};
}

/// The motion between events. With dt = (dδ/dz) K ds, z the carried variable, every component is smooth in s.
template <class Law>
class PlanarSystem {
 public:
  using State = std::array<double, components>;
  enum Event : std::size_t { phase_end, phase_begin, slip_end, skid_begin, roll_change, load_sign, turn, events };
  using Values = std::array<double, events>;

  PlanarSystem(const Law& law, const ObliquePair& pair, const ObliqueImpact& impact)
      : law_(law), pair_(pair), laws_(pair.laws), scales_(scales_of(law, pair.mass, impact.normal_speed)) {
    rooted_ = laws_.needs_overlap_root();
    root_unit_ = std::sqrt(std::sqrt(scales_.overlap));
    const double lever = pair.wall ? pair.radius[0] : std::min(pair.radius[0], pair.radius[1]);
    const double along =
        std::abs(impact.tangential_speed) + pair.radius[0] * std::abs(impact.spin[0]) + pair.radius[1] * std::abs(impact.spin[1]);
    const double speed = std::max(scales_.speed, 0.1 * along);
    scale_ = {root_unit_,
              scales_.coordinate,
              scales_.speed,
              speed,
              speed / lever,
              speed / lever,
              scales_.overlap,
              scales_.overlap / laws_.radius,
              scales_.time,
              scales_.overlap,
              1e-3};
    if (std::isfinite(pair.distance)) scale_[turned] = std::abs(scales_.overlap / pair.distance);
    if (laws_.rolling.model == RollingModel::epsd || laws_.rolling.model == RollingModel::epsd2) {
      const ContactPoint deep{.overlap = scales_.overlap,
                              .root = scales_.coordinate,
                              .overlap_root = std::sqrt(std::sqrt(laws_.radius)) * root_unit_,
                              .load = 0};
      scale_[roll_history] *= std::max(laws_.rolling.at(deep, {}).stiffness, std::numeric_limits<double>::min());
    }
    clock_ = (rooted_ ? root_unit_ : scales_.coordinate) / scales_.speed;
  }

  [[nodiscard]] double scale(std::size_t i) const { return scale_[i]; }

  State start(const ObliqueImpact& impact, ObliqueOutcome& outcome) {
    State y{};
    y[coordinate] = law_.touch();
    y[approach] = impact.normal_speed;
    y[sliding] = impact.tangential_speed;
    y[spin1] = impact.spin[0];
    y[spin2] = impact.spin[1];
    State little = y;
    constexpr double share = 1e-5;
    little[rooted_ ? root : coordinate] += share * (rooted_ ? root_unit_ : scales_.coordinate);
    evaluate(little);
    const double stretched = normal_.point.overlap / y[approach];
    if (laws_.tangential.acts()) {
      slide_ = first_slider<1>(slide_law_, slide_speed_, stretched);
      outcome.slips += slide_.grip != Grip::holds;
    }
    if (laws_.rolling.acts() && !laws_.rolling.rigid()) roll_ = first_slider<1>(roll_law_, roll_speed_, stretched);
    if (laws_.rolling.rigid() && std::abs(roll_speed_[0]) > 1e-12 * scales_.speed / laws_.radius) roll_.slide_along(roll_speed_);
    outcome.rolls += roll_.grip != Grip::holds;
    keep(y);
    return y;
  }

  [[gnu::always_inline]] void operator()(const State& y, State& rate, double) {
    evaluate(y);
    const double dt = normal_.slope * clock_;
    rate[root] = rooted_ ? clock_ * y[approach] : 0.0;
    rate[coordinate] = rooted_ ? dt * y[approach] / normal_.coordinate_slope : clock_ * y[approach];
    rate[approach] = dt * approach_rate_;
    rate[sliding] = dt * sliding_rate_;
    rate[spin1] = dt * spin_rate_[0];
    rate[spin2] = dt * spin_rate_[1];
    rate[slide_history] = slide_.grip == Grip::holds && laws_.tangential.acts() ? dt * slide_speed_[0] : 0.0;
    rate[roll_history] =
        laws_.rolling.acts() && roll_.grip == Grip::holds && !laws_.rolling.rigid() ? roll_.rate(roll_law_, roll_speed_, {}, dt)[0] : 0.0;
    rate[time] = dt;
    rate[displacement] = dt * y[sliding];
    rate[turned] = dt * y[sliding] / separation_;
  }

  void event_values(const State& y, Values& values) {
    evaluate(y);
    if (slide_.grip != Grip::holds || roll_.grip != Grip::holds) rates(y);  // what holds is asked for its force alone
    values.fill(-1.0);
    values[phase_end] = rooted_ ? -y[root] / root_unit_ : (law_.separation() - y[coordinate]) / scales_.coordinate;
    if (!rooted_ && laws_.needs_overlap_root()) values[phase_begin] = (y[coordinate] - law_.touch()) / scales_.coordinate;
    if (laws_.tangential.acts()) {
      values[slip_end] = slide_.end_of_grip(slide_law_, slide_speed_, slide_acceleration_, dt_);
      values[skid_begin] = slide_.begin_of_skid(slide_law_, slide_speed_, slide_acceleration_);
    }
    if (laws_.rolling.rigid()) {
      values[roll_change] = roll_.grip == Grip::slides ? -roll_.history[0] * roll_speed_[0] / roll_unit() - 1e-13
                                                       : std::abs(torque_[0]) - roll_law_.limit * (1 + 1e-11);
    } else if (laws_.rolling.acts()) {
      values[roll_change] = roll_.end_of_grip(roll_law_, roll_speed_, roll_acceleration_, dt_);
    }
    if (laws_.uses_load()) values[load_sign] = -normal_.point.load;
    values[turn] = outgoing_ ? y[approach] : -y[approach];
  }

  /// Carries out an event; true if the contact is over.
  bool apply(std::size_t event, State& y, ObliqueOutcome& outcome) {
    evaluate(y);
    rates(y);
    const bool held = slide_.grip == Grip::holds, roll_held = roll_.grip == Grip::holds;
    switch (event) {
      case phase_end:
        if (!rooted_ || law_.separation() >= law_.touch()) {
          outcome.sliding_at_end = slide_.grip != Grip::holds;
          return true;
        }
        enter_phase(false, y);
        if (laws_.rolling.on_overlap()) roll_ = {};
        break;
      case phase_begin: enter_phase(true, y); break;
      case slip_end: slide_.let_go(slide_law_, slide_speed_, slide_acceleration_, dt_); break;
      case skid_begin: slide_.skid(slide_law_, slide_speed_); break;
      case roll_change: change_roll(y); break;
      case load_sign:
        load_sign_ = -load_sign_;
        evaluate(y);
        rates(y);
        slide_.restart(slide_law_, slide_speed_, slide_acceleration_, dt_);
        if (!laws_.rolling.rigid()) roll_.restart(roll_law_, roll_speed_, roll_acceleration_, dt_);
        break;
      case turn:
        if (!outgoing_) outcome.max_overlap = normal_.point.overlap;
        outcome.stuck = outgoing_;
        outgoing_ = true;
        if (outcome.stuck) return true;
        break;
      default: break;
    }
    const bool holds = slide_.grip == Grip::holds;
    outcome.slips += held && !holds;
    outcome.holds += !held && holds;
    outcome.rolls += roll_held && roll_.grip != Grip::holds;
    keep(y);
    return false;
  }

 private:
  [[nodiscard]] double roll_unit() const { return scales_.speed / laws_.radius; }

  void keep(State& y) const {
    y[slide_history] = slide_.history[0];
    y[roll_history] = roll_.history[0];
  }

  void enter_phase(bool rooted, State& y) {
    rooted_ = rooted;
    y[root] = 0;
    y[coordinate] = law_.touch();
    clock_ = (rooted_ ? root_unit_ : scales_.coordinate) / scales_.speed;
  }

  void change_roll(const State& y) {
    if (!laws_.rolling.rigid()) {
      roll_.let_go(roll_law_, roll_speed_, roll_acceleration_, dt_);
    } else if (roll_.grip == Grip::holds) {
      roll_.slide_along(torque_);
    } else {
      roll_ = {};
      evaluate(y);
      if (std::abs(torque_[0]) > roll_law_.limit) roll_.slide_along(torque_);
    }
  }

  /// Forces and accelerations.
  [[gnu::always_inline]] void evaluate(const State& y) {
    const bool holds = slide_.grip == Grip::holds;
    normal_ = normal_point(law_, rooted_, y[coordinate], y[root], y[approach], laws_.radius);
    normal_.point.load *= load_sign_;
    arm_ = pair_.radius;
    arm_rate_ = 0;
    if (laws_.arm == TorqueArm::contact) {
      const double share = pair_.wall ? 1.0 : 0.5;
      arm_[0] -= share * normal_.point.overlap;
      arm_[1] -= pair_.wall ? 0.0 : share * normal_.point.overlap;
      arm_rate_ = -share * y[approach];
    }
    separation_ = pair_.distance - normal_.point.overlap;
    friction_ = torque_ = Tangent<1>::Zero();
    if (laws_.tangential.acts()) {
      if (holds) slide_.history[0] = y[slide_history];
      slide_speed_[0] = y[sliding] + arm_[0] * y[spin1] + arm_[1] * y[spin2];
      slide_law_ = laws_.tangential.at(normal_.point, {});
      friction_ = slide_.force(slide_law_, slide_speed_);
    }
    const std::array<double, 2> pull = {arm_[0] * friction_[0], arm_[1] * friction_[0]};
    if (laws_.rolling.acts()) {
      roll_speed_[0] = y[spin1] - y[spin2];
      roll_law_ = laws_.rolling.at(normal_.point, {});
      if (laws_.rolling.rigid() && roll_.grip == Grip::holds) {
        const double ease = 1 / pair_.inertia[0] + 1 / pair_.inertia[1];
        torque_[0] = (pull[1] / pair_.inertia[1] - pull[0] / pair_.inertia[0]) / ease;
      } else {
        if (roll_.grip == Grip::holds) roll_.history[0] = y[roll_history];
        torque_ = roll_.force(roll_law_, roll_speed_);
      }
    }
    approach_rate_ = -normal_.total / pair_.mass - y[sliding] * y[sliding] / separation_;
    sliding_rate_ = -friction_[0] / pair_.mass + y[approach] * y[sliding] / separation_;
    spin_rate_ = {-(pull[0] + torque_[0]) / pair_.inertia[0], -(pull[1] - torque_[0]) / pair_.inertia[1]};
  }

  /// The laws' rates of change, per unit of s: asked for by events alone.
  void rates(const State& y) {
    dt_ = normal_.slope * clock_;
    const double root_rate = clock_ * y[approach];
    const double coordinate_rate = rooted_ ? dt_ * y[approach] / normal_.coordinate_slope : root_rate;
    ContactPoint rate =
        point_rate(law_, normal_, rooted_, y[coordinate], coordinate_rate, root_rate, y[approach], dt_ * approach_rate_, laws_.radius);
    rate.load *= load_sign_;
    if (laws_.tangential.acts()) {
      slide_law_ = laws_.tangential.at(normal_.point, rate);
      slide_acceleration_[0] = dt_ * (sliding_rate_ + arm_[0] * spin_rate_[0] + arm_[1] * spin_rate_[1] +
                                      arm_rate_ * (y[spin1] + (pair_.wall ? 0.0 : y[spin2])));
    }
    if (laws_.rolling.acts()) {
      roll_law_ = laws_.rolling.at(normal_.point, rate);
      roll_acceleration_[0] = dt_ * (spin_rate_[0] - spin_rate_[1]);
    }
  }

  const Law& law_;
  const ObliquePair& pair_;
  const ContactLaws& laws_;
  Scales scales_;
  double root_unit_, clock_;
  State scale_{};
  // Modes:
  bool rooted_, outgoing_ = false;
  double load_sign_ = 1;
  Slider<1> slide_{}, roll_{};
  // At the state last evaluated:
  NormalPoint normal_;
  std::array<double, 2> arm_{}, spin_rate_{};
  double arm_rate_ = 0, separation_ = 0, approach_rate_ = 0, sliding_rate_ = 0, dt_ = 0;
  SliderLaw slide_law_, roll_law_;
  Tangent<1> friction_{0.0}, torque_{0.0}, slide_speed_{0.0}, roll_speed_{0.0}, slide_acceleration_{0.0}, roll_acceleration_{0.0};
};

template <class Law>
ObliqueOutcome resolve(const Law& law, const ObliquePair& pair, const ObliqueImpact& impact, double tolerance) {
  ObliqueOutcome outcome;
  using System = PlanarSystem<Law>;
  System system(law, pair, impact);
  auto y = system.start(impact, outcome);
  // What a slow pair has left at separation is the small difference of larger energies.
  const double share = impact.normal_speed / system.scale(approach);
  using State = typename System::State;
  using Steps = EmbeddedSteps<State, Fehlberg78<State, boost::numeric::odeint::array_algebra>>;
  EventIntegrator<System, Steps> integrator(system, std::max(1e-15, 2 * tolerance * share * share), 0.05);
  for (int events = 0; events < 10'000;) {
    const int event = integrator.advance(y);
    if (event < 0) continue;
    ++events;
    if (!system.apply(static_cast<std::size_t>(event), y, outcome)) {
      integrator.restart();
      continue;
    }
    outcome.steps = integrator.steps();
    if (outcome.stuck) return outcome;
    outcome.normal_speed = -y[approach];
    outcome.tangential_speed = y[sliding];
    outcome.spin = {y[spin1], y[spin2]};
    outcome.contact_time = y[time];
    outcome.displacement = y[displacement];
    outcome.turned = y[turned];
    return outcome;
  }
  throw WorkError("an oblique collision had 10000 events");
}

}  // namespace

ObliqueOutcome resolve_oblique_collision(const ObliquePair& pair, const ObliqueImpact& impact, double tolerance) {
  if (!(impact.normal_speed > 0) || !std::isfinite(impact.normal_speed))
    throw WorkError("an oblique collision needs a positive normal speed");
  return std::visit([&](const auto& law) { return resolve(law, pair, impact, tolerance); }, pair.laws.normal);
}

}  // namespace scalebreak

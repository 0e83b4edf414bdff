#pragma once

#include <algorithm>
#include <cmath>

#include <scalebreak/contact/contact_point.hpp>

namespace scalebreak {

/// What a spring–dashpot–slider is made of at one instant, with the rates of change of its parts.
template <class T>
struct SliderLawOf {
  T stiffness = 0, stiffness_rate = 0;
  T damping = 0, damping_rate = 0;
  T limit = 0, limit_rate = 0;
  T limit_floor = 0;                ///< far below it a direction is not followed any more
  bool dashpot_is_limited = false;  ///< the limit is on spring plus dashpot; else on the spring, and what slides has no dashpot
  bool incremental = false;         ///< the history is the spring's force, dF = k du; else its displacement, F = k u
};
using SliderLaw = SliderLawOf<double>;

/// How a slider moves. `skids`: its dashpot alone exceeds the limit, and its spring is left as it is, unstretched or pushing forward.
/// (A spring that made up for the dashpot would be driven forward ever further where the contact begins; in one that stiffens as it
/// grows it would soon reverse the friction.)
/// `relaxes`: slides after a skid, while its spring still pushes forward, less and less.
enum class Grip { holds, slides, skids, relaxes };

/// A spring and dashpot in series with a slider, in a contact plane: the history of sliding and of rolling. While it holds,
/// `history` is the spring's displacement (or its force, if the law is incremental); while it slides, it is the unit direction
/// of the force, and the spring is such that what the limit is on equals the limit; while it skids, the displacement again. Forces are returned along
/// the motion that they oppose.
///
/// Velocities are per unit of true time; rates and accelerations per unit of the integrator's time, which is
/// `dt` of true time long.
template <int D>
struct Slider {
  Tangent<D> history = Tangent<D>::Zero();
  Grip grip = Grip::holds;

  /// The force against `speed`.
  [[nodiscard, gnu::always_inline]] Tangent<D> force(const SliderLaw& law, const Tangent<D>& speed) const {
    switch (grip) {
      case Grip::holds: return spring(law, speed) + law.damping * speed;
      case Grip::slides:
      case Grip::relaxes: return law.limit * direction();
      case Grip::skids: break;
    }
    return law.limit * unit(limited(law, speed));
  }

  /// The history's rate of change. `acceleration` is that of `speed`.
  [[nodiscard]] Tangent<D> rate(const SliderLaw& law, const Tangent<D>& speed, const Tangent<D>& acceleration, double dt) const {
    if (grip == Grip::holds) return (law.incremental ? law.stiffness : 1.0) * dt * speed;
    if (D == 1 || grip == Grip::skids) return Tangent<D>::Zero();
    const Tangent<D> along = direction(), trial = trial_rate(law, speed, acceleration, dt);
    return (trial - along * along.dot(trial)) * law.limit / (law.limit * law.limit + law.limit_floor * law.limit_floor);
  }

  /// Above zero where the grip ends: a spring at its limit, a sliding force that would fall faster than the limit, or
  /// a dashpot back below it.
  [[nodiscard]] double end_of_grip(const SliderLaw& law, const Tangent<D>& speed, const Tangent<D>& acceleration, double dt) const {
    switch (grip) {
      case Grip::holds: return length(limited(law, speed)) - law.limit * (1 + 1e-13);
      case Grip::slides:
      case Grip::relaxes: return rest(law, speed, acceleration, dt);
      case Grip::skids: break;
    }
    return law.limit - length(limited(law, speed));
  }
  /// Above zero where what slides begins to skid: its spring would be driven forward, or further forward.
  [[nodiscard]] double begin_of_skid(const SliderLaw& law, const Tangent<D>& speed, const Tangent<D>& acceleration) const {
    if (!law.dashpot_is_limited || grip == Grip::holds || grip == Grip::skids || !(law.stiffness > 0)) return -1;
    const double pull = direction().dot(spring(law, speed));
    if (grip == Grip::slides) return -pull;
    const double pull_rate = law.limit_rate - direction().dot(law.damping * acceleration + law.damping_rate * speed);
    const double relaxing = pull_rate - pull * law.stiffness_rate / law.stiffness;
    return std::min(-pull, -relaxing);
  }

  /// What follows the end of a grip.
  void let_go(const SliderLaw& law, const Tangent<D>& speed, const Tangent<D>& acceleration, double dt) {
    switch (grip) {
      case Grip::holds: return slip(law, speed);
      case Grip::slides:
      case Grip::relaxes: return hold(law, speed);
      case Grip::skids: break;
    }
    const Tangent<D> kept = history;
    slide_along(limited(law, speed));
    if (rest(law, speed, acceleration, dt) > 0) {
      history = kept, grip = Grip::holds;
    } else if (direction().dot(spring(law, speed)) < 0) {
      grip = Grip::relaxes;
    }
  }
  /// What slides skids from now on.
  void skid(const SliderLaw& law, const Tangent<D>& speed) {
    history = spring(law, speed) / law.stiffness;
    grip = Grip::skids;
  }
  /// Lets go of what exceeds the limit: slides, or skids where the spring would have to push forward.
  void slip(const SliderLaw& law, const Tangent<D>& speed) {
    const Tangent<D> kept = history, force = limited(law, speed);
    slide_along(force.norm() > 0 ? force : speed);
    if (law.dashpot_is_limited && direction().dot(spring(law, speed)) < 0) history = kept, grip = Grip::skids;
  }
  void slide_along(const Tangent<D>& force) {
    grip = Grip::slides;
    history = unit(force);
  }
  /// Where the limit passes zero, what slides has no force: it goes on the way that it is driven, or holds.
  void restart(const SliderLaw& law, const Tangent<D>& speed, const Tangent<D>& acceleration, double dt) {
    if (grip == Grip::holds || grip == Grip::skids) return;
    const Tangent<D> trial = trial_rate(law, speed, acceleration, dt);
    if (trial.norm() > 0) history = unit(trial);
    if (rest(law, speed, acceleration, dt) > 0) hold(law, speed);
  }

  /// Half the spring's stretch times its force.
  [[nodiscard]] double energy(const SliderLaw& law, const Tangent<D>& speed) const {
    return law.stiffness > 0 ? spring(law, speed).squaredNorm() / (2 * law.stiffness) : 0.0;
  }

  [[nodiscard]] Tangent<D> direction() const {
    if constexpr (D == 1) return history;
    return unit(history);
  }

 private:
  [[nodiscard]] static double length(const Tangent<D>& v) {
    if constexpr (D == 1) return std::abs(v[0]);
    return v.norm();
  }
  [[nodiscard]] static Tangent<D> unit(const Tangent<D>& v) {
    if constexpr (D == 1) return Tangent<D>(v[0] > 0 ? 1.0 : v[0] < 0 ? -1.0 : 0.0);
    const double norm = v.norm();
    return norm > 0 ? Tangent<D>(v / norm) : Tangent<D>::Zero();
  }
  /// The spring's force.
  [[nodiscard]] Tangent<D> spring(const SliderLaw& law, const Tangent<D>& speed) const {
    if (grip == Grip::holds || grip == Grip::skids) return (law.incremental ? 1.0 : law.stiffness) * history;
    return law.limit * direction() - (law.dashpot_is_limited ? law.damping : 0.0) * speed;
  }
  /// What the limit is on.
  [[nodiscard]] Tangent<D> limited(const SliderLaw& law, const Tangent<D>& speed) const {
    return spring(law, speed) + (law.dashpot_is_limited ? law.damping : 0.0) * speed;
  }
  /// Of what slides: above zero where its force would fall faster than the limit if it held from now on.
  [[nodiscard]] double rest(const SliderLaw& law, const Tangent<D>& speed, const Tangent<D>& acceleration, double dt) const {
    return law.limit_rate - direction().dot(trial_rate(law, speed, acceleration, dt));
  }
  /// How the limited force would change if the slider held from now on.
  [[nodiscard]] Tangent<D> trial_rate(const SliderLaw& law, const Tangent<D>& speed, const Tangent<D>& acceleration, double dt) const {
    Tangent<D> rate = law.stiffness * dt * speed;
    if (!law.incremental && law.stiffness > 0) rate += law.stiffness_rate / law.stiffness * spring(law, speed);
    if (law.dashpot_is_limited) rate += law.damping * acceleration + law.damping_rate * speed;
    return rate;
  }
  void hold(const SliderLaw& law, const Tangent<D>& speed) {
    const Tangent<D> force = spring(law, speed);
    history = law.incremental ? force : law.stiffness > 0 ? Tangent<D>(force / law.stiffness) : Tangent<D>::Zero();
    grip = Grip::holds;
  }
};

/// The slider of a contact that begins at `speed`: what it does from its first instant is asked at `law`, `time` later.
template <int D>
[[nodiscard]] Slider<D> first_slider(const SliderLaw& law, const Tangent<D>& speed, double time) {
  Slider<D> slider{Tangent<D>((law.incremental ? law.stiffness * time : time) * speed)};
  if (!(slider.end_of_grip(law, speed, Tangent<D>::Zero(), 0.0) > 0)) return {};
  slider.slip(law, speed);
  if (slider.grip == Grip::skids) slider.history.setZero();
  return slider;
}

}  // namespace scalebreak

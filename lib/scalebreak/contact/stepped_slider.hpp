#pragma once

#include <cmath>

#include <scalebreak/base/scalar.hpp>
#include <scalebreak/contact/slider.hpp>

namespace scalebreak {

/// A vector whose components are scalars of any kind, packs of doubles too.
template <class T>
struct Vector3Of {
  T x = 0, y = 0, z = 0;

  [[nodiscard, gnu::always_inline]] T dot(const Vector3Of& b) const { return x * b.x + y * b.y + z * b.z; }
  [[nodiscard, gnu::always_inline]] Vector3Of cross(const Vector3Of& b) const {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }
  [[nodiscard, gnu::always_inline]] T norm() const {
    using std::sqrt;
    return sqrt(dot(*this));
  }
  [[gnu::always_inline]] friend Vector3Of operator+(const Vector3Of& a, const Vector3Of& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  [[gnu::always_inline]] friend Vector3Of operator-(const Vector3Of& a, const Vector3Of& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  [[gnu::always_inline]] friend Vector3Of operator*(const T& s, const Vector3Of& a) { return {s * a.x, s * a.y, s * a.z}; }
};

/// A history turned into the plane across `normal`. What a turn by the angle α of one step takes off its length, α²/2, is left off.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3Of<T> in_plane(const Vector3Of<T>& history, const Vector3Of<T>& normal) {
  return history - history.dot(normal) * normal;
}

/// The slider of a soft-sphere engine: the same spring, dashpot and limit as Slider, stepped over `time` and set back to the limit
/// rather than located there. Changes `history` (see Slider: a displacement or, of an incremental law, a force) and returns the force
/// against `speed`. What slides has a spring that makes spring and dashpot equal the limit; where it would have to push forward, and
/// further than it does, it is left as it is (Slider's skid). A law without a spring gives its limit against the speed.
/// Then `history` goes on by `after` more, unless it skids: with a speed of the force's instant, half a step before the force and half a step
/// after it integrate the history to second order.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3Of<T> step_slider(const SliderLawOf<T>& law, bool rigid, Vector3Of<T>& history,
                                                                  const Vector3Of<T>& speed, const T& time, const T& after) {
  using std::sqrt;
  // By what a vector is shortened to the limit.
  const auto over = [](const Vector3Of<T>& v, const T& limit) __attribute__((always_inline)) {
    const T square = v.dot(v);
    const auto longer = square > limit * limit;
    if (!any(longer)) return T(1);
    return choose(longer, T(limit / sqrt(choose(longer, square, T(1)))), T(1));
  };
  if (rigid) {
    const T length = speed.norm();
    return choose(length > 0.0, T(law.limit / choose(length > 0.0, length, T(1))), T(0)) * speed;
  }
  if (law.incremental) {
    const Vector3Of<T> trial = history + (law.stiffness * time) * speed;
    const T share = over(trial, law.limit);
    const Vector3Of<T> force = share * trial;
    history = force + (law.stiffness * after) * speed;
    return force + choose(share < 1.0, T(0), law.damping) * speed;  // what slides has no dashpot
  }
  const Vector3Of<T> stretched = history + time * speed, carried = after * speed;
  if (!law.dashpot_is_limited) {
    const Vector3Of<T> trial = law.stiffness * stretched;
    const T share = over(trial, law.limit);
    history = share * stretched + carried;
    return share * trial;
  }
  const Vector3Of<T> dashpot = law.damping * speed, trial = law.stiffness * stretched + dashpot;
  const auto slides = trial.dot(trial) > law.limit * law.limit;
  if (!any(slides)) {
    history = stretched + carried;
    return trial;
  }
  const T share = choose(slides, T(law.limit / sqrt(choose(slides, trial.dot(trial), T(1)))), T(1));
  const Vector3Of<T> sliding = share * trial, spring = sliding - dashpot;
  const T softness = choose(law.stiffness > 0.0, T(1.0 / choose(law.stiffness > 0.0, law.stiffness, T(1))), T(0));
  const Vector3Of<T> slid = softness * spring + carried, held = stretched + carried;
  // Along the force: what the spring would pull, and what it pulls if it is left as it is; both times the limit.
  const T pull = sliding.dot(spring);
  const auto pushes = slides && pull < 0.0;
  if (!any(pushes)) {
    history = {choose(slides, slid.x, held.x), choose(slides, slid.y, held.y), choose(slides, slid.z, held.z)};
    return sliding;
  }
  const Vector3Of<T> left = law.stiffness * history;
  const auto skids = pushes && pull < sliding.dot(left);
  const Vector3Of<T> kept = left + dashpot, skidding = over(kept, law.limit) * kept;
  history.x = choose(slides, choose(skids, history.x, slid.x), held.x);
  history.y = choose(slides, choose(skids, history.y, slid.y), held.y);
  history.z = choose(slides, choose(skids, history.z, slid.z), held.z);
  return {choose(skids, skidding.x, sliding.x), choose(skids, skidding.y, sliding.y), choose(skids, skidding.z, sliding.z)};
}

}  // namespace scalebreak

#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// What an oblique, spinning, rolling or wet collision of a pair comes to, SI, along the directions at first touch.
struct PairMotion {
  bool stuck = false;                            ///< nothing but `max_overlap` and `turned` has a value then
  double restitution_normal = 0;                 ///< −(relative normal velocity after / before)
  std::optional<double> restitution_tangential;  ///< centres' relative tangential velocity after / before
  std::optional<double> restitution_surface;     ///< of the surface points, −after / before (β of Chung & Ooi 2011)
  std::optional<double> restitution_rolling;     ///< relative rolling speed (ω₁ − ω₂) × n after / before
  std::optional<double> contact_time;            ///< [s]
  double max_overlap = 0;                        ///< [m]
  std::array<Eigen::Vector3d, 2> spin_gained = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< [rad/s]
  Eigen::Vector3d tangential_gained{0, 0, 0};  ///< by the centres' relative velocity: tangential impulse over m* [m/s]
  /// What the spins gain of angular momentum over what the orbital motion loses: 1 where the collision conserves it.
  std::optional<double> angular_momentum_share;
  /// Angular momentum that the pair gains, over that of its surfaces' slip at touch, m* d v_s: 0 where it is conserved.
  std::optional<double> angular_momentum_change;
  int slides = 0;     ///< times that the contact began to slide after it had held
  double turned = 0;  ///< by the line of centres while they touched [rad]
};

/// Does more happen in an input's collision than its normal motion: an oblique impact, spins, rolling or a liquid?
[[nodiscard]] bool moves_beyond_normal(const Input& input);

/// Do all its lengths shrink with the overlap? A bridge outside the contact has a length of its own, which does not.
[[nodiscard]] bool has_small_overlap_limit(const Input& input);

/// The input with another normal impact speed, at the same angle and the same spins over speed.
[[nodiscard]] Input at_normal_speed(Input input, double speed);

/// The exact motion of an input's pair under a scaling law. `shrink` < 1 gives the same collision with overlaps over radius
/// smaller by that factor: the pair is stiffened, and all that acts in the contact with it, so that in the limit of small
/// overlaps nothing but lengths and times changes. Throws WorkError.
[[nodiscard]] PairMotion resolve_motion(const Input& input, const ScalingLaw& law, double factor, double tolerance, double shrink = 1);

}  // namespace scalebreak

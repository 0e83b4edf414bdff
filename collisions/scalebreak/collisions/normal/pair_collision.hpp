#pragma once

#include <array>
#include <optional>
#include <vector>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/contact/reduced.hpp>
#include <scalebreak/scaling/scaled_pair.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Overlap over R* beyond which the laws of small overlaps are out of their range.
inline constexpr double deep_overlap = 0.1;

/// A head-on collision of a scaled system, SI.
struct PairCollision {
  ContactKind kind;  ///< as it was modelled
  bool stuck = false;
  double restitution = 0;                ///< 0 if stuck
  std::optional<double> contact_time;    ///< [s]; none if stuck
  double max_overlap = 0;                ///< [m]
  double max_force = 0;                  ///< spring and dashpot [N]; only if asked for
  std::optional<double> sticking_speed;  ///< [m/s]; none without adhesion and where every collision sticks, 0 where nothing can
  int steps = 0;
};

/// One row of a trajectory, SI. The contact radius is that of the pair in which the force is evaluated, the
/// original one under a direct-force law; 0 for a linear contact.
struct TrajectoryPoint {
  double time, overlap, contact_radius, speed, elastic_force, damping_force;
};

/// What decides a collision once bodies, law and factor are known: built once, asked at many speeds.
class ScaledContact {
 public:
  /// A body that is `fixed` counts as infinitely heavy.
  ScaledContact(const ContactKind& kind, const Bodies& original, const ScalingLaw& law, double factor,
                std::array<bool, 2> fixed = {false, false});

  [[nodiscard]] const ContactKind& kind() const { return kind_; }
  /// Reduced speed and damping ratio at an impact speed [m/s], with the scales of the evaluated pair.
  [[nodiscard]] ReducedCollision reduced(double speed) const { return reduce(kind_, scaled_.pair, speed); }
  /// What turns the evaluated pair's overlaps, times and forces into those of the scaled system.
  [[nodiscard]] const ScaledPair& scaled() const { return scaled_; }

  /// Of the pair, by the exact engine [m/s]: none without adhesion, nor where a mapped dashpot makes every collision stick.
  [[nodiscard]] std::optional<double> sticking_speed(double tolerance) const;
  /// The exact collision at an impact speed [m/s], without its sticking speed.
  [[nodiscard]] PairCollision collide(double speed, double tolerance, bool find_max_force = false) const;
  /// By how far the bodies are apart beyond first touch when a collision at this speed ends [m].
  [[nodiscard]] double end_gap(double speed) const;
  /// Scaled energy that a torn contact has lost [J]; 0 without adhesion.
  [[nodiscard]] double tearing_energy() const;
  /// Depth of the contact's potential below first touch, scaled [J].
  [[nodiscard]] double well_depth() const;
  /// About `points` instants of the contact, by the exact engine, evenly spaced in its regular parameter s (docs/theory.md).
  [[nodiscard]] std::vector<TrajectoryPoint> trajectory(double speed, double tolerance, int points) const;

 private:
  ContactKind kind_;
  ScaledPair scaled_;
};

/// The normal contact of an input's pair, or of its first two bodies, the scaling law applied.
[[nodiscard]] ScaledContact contact_of(const Input& input);

}  // namespace scalebreak

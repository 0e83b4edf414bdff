#pragma once

#include <array>
#include <limits>

#include <Eigen/Core>

#include <scalebreak/contact/reduced.hpp>
#include <scalebreak/table/oblique_table.hpp>
#include <scalebreak/table/rolling_lookup.hpp>
#include <scalebreak/table/table_row.hpp>

namespace scalebreak {

/// Why the tables do not answer, so that a pair must be integrated.
enum class Refusal { none, sticks, outside_table, turns_too_far, coupled, liquid, no_table, count };
[[nodiscard]] const char* to_string(Refusal refusal);

/// Two bodies and what acts between them, SI. Mass and inertia are infinite of what does not move; of a flat wall, the second, the
/// radius is 0.
struct CollidingPair {
  ContactKind kind;
  SurfaceKind surface;
  NormalPair normal;
  std::array<double, 2> mass{}, radius{}, inertia{};
  bool wall = false;
};

/// How they meet, at first touch.
struct PairImpact {
  Eigen::Vector3d normal{0, 0, 1};  ///< unit vector from the first body to the second
  std::array<Eigen::Vector3d, 2> velocity{}, spin{};
};

/// What comes of it; nothing but the reason where it is refused.
struct PairOutcome {
  Refusal refusal = Refusal::none;
  bool stuck = false;  ///< told by exact engines alone: the tables refuse what sticks
  std::array<Eigen::Vector3d, 2> velocity{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::array<Eigen::Vector3d, 2> spin{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  double contact_time = 0;                ///< [s]; by table this and the displacement are those of a normal that does not turn
  double turning_error = 0;               ///< estimate of what the turning of the normal leaves out, of velocities over the normal speed
  double coupling_error = 0;              ///< the same of what sliding and rolling do to each other
  Eigen::Vector3d displacement{0, 0, 0};  ///< of the first body past the second from first touch to separation [m]
};

/// The collisions of one pair of bodies by table. Where the normal does not turn, sliding and rolling each keep to their line, whatever
/// angle is between them; twist is left alone. The turning of the normal is taken to first order where all motion is in one plane; what
/// that leaves out is estimated (docs/tables.md) and refused beyond the tolerance. So is what friction and rolling resistance leave out
/// where they change each other, as between unlike spheres and at a wall: each is looked up at what the other will have changed, or half of it.
class PairLookup {
 public:
  /// Tables that the laws do not ask for may be null; those that they ask for and are null are refused as `no_table`. Keeps the pointers.
  PairLookup(const CollidingPair& pair, const TableRow* normal, const ObliqueTable* oblique, const RollingLookup& rolling);

  /// `tolerance` is of the turning's error and of what sliding and rolling do to each other, of velocities over the normal speed; the
  /// tables have their own.
  [[nodiscard]] PairOutcome resolve(const PairImpact& impact, double tolerance) const;

  /// What no impact of this pair can change.
  [[nodiscard]] Refusal standing_refusal() const { return refusal_; }

  /// How far the turning's error reaches, over (overlap over distance) out of the plane and over its square: measured, see docs/tables.md.
  static constexpr double first_order = 1, second_order = 4;

 private:
  /// What friction and rolling resistance do to each other: what is added to the sliding [m/s] and to the relative spin [1/s] before each is
  /// looked up, and the error that is left, of velocities over the normal speed.
  struct Exchange {
    Eigen::Vector3d sliding{0, 0, 0}, rolling{0, 0, 0};
    double error = 0;
  };
  [[nodiscard]] std::optional<Exchange> exchange(const Eigen::Vector3d& normal, double normal_speed, double reduced_speed,
                                                 const Eigen::Vector3d& sliding, const Eigen::Vector3d& rolling) const;

  CollidingPair pair_;
  const TableRow* normal_;
  const ObliqueTable* oblique_;
  RollingLookup rolling_;
  Refusal refusal_ = Refusal::none;
  ReducedScales<double> scales_{};  ///< with adhesion
  double end_gap_ = 0;              ///< how far a stretched neck reaches [m]
  double coupling_ = 0;             ///< r₁/I₁ − r₂/I₂, where friction and rolling change each other [1/(kg m)]
  double mass_ = 0, distance_ = 0;
};

/// Does friction leave the rolling alone, and rolling the sliding? It does between bodies with one r/I, of which a tangential force
/// changes ω₁ + ω₂ alone.
[[nodiscard]] bool rolls_apart(const SurfaceKind& surface, const std::array<double, 2>& radius, const std::array<double, 2>& inertia);

}  // namespace scalebreak

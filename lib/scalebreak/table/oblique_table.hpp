#pragma once

#include <cmath>
#include <optional>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/contact/surface_kind.hpp>
#include <scalebreak/table/impact_plane.hpp>
#include <scalebreak/table/patch_table.hpp>

namespace scalebreak {

/// What the oblique collisions of a pair of materials depend on beside the reduced impact speed v̂ and the angle of impact: numbers
/// without a unit. Solid spheres of any sizes have `inertia` 5/2 under unscaled torques; the shares matter to the turning alone.
struct ObliqueKey {
  ContactKind kind;
  SurfaceKind surface;  ///< tangential law, its radius and the torque arm; rolling and liquid play no part
  double damping_ratio = 0;
  double friction = 0;
  double stiffness = 0;  ///< G*/E* of Mindlin's spring, k_t/k_n of the linear one
  double inertia = 2.5;  ///< m*(r₁²/I₁ + r₂²/I₂)
  double share = 0.5;    ///< of the first radius in r₁ + r₂, with torque arms at the contact; 1 against a wall
  double tolerance = 1e-4;

  bool operator==(const ObliqueKey&) const = default;
};

/// What comes of an impact (v_n, v_s) where the normal does not turn; v_t, the centres' own, plays no part.
struct ObliqueEntry {
  double surface_restitution;  ///< sliding speed v_s after over before
  double lag;                  ///< ∫ (v_t0 − v_t) dt over v_s t_c: how far the centres fall behind
};

/// How that outcome changes, to first order, with the turning of the contact: per (largest overlap)/(distance of the centres), over the
/// normal speed v_n, as polynomials c₀ + c₁ τ + c₂ τ² of τ = v_t/v_n, the centres' own tangential speed.
struct TurningEntry {
  Eigen::Array3d normal;      ///< of the speed of separation
  Eigen::Array3d tangential;  ///< of the centres' tangential speed in the turned frame
  Eigen::Array3d sliding;     ///< of the sliding speed
};

/// How well a table does at points between its nodes.
struct ObliqueQuality {
  double error_max = 0, error_rms = 0;  ///< of both numbers of ObliqueEntry
  double turning_error_median = 0;      ///< of TurningEntry, over (1 + ψ)²; across a kink it jumps, so that the largest says little
  int samples = 0;

  bool operator==(const ObliqueQuality&) const = default;
};

/// Oblique collisions of one pair of materials over ξ, the coordinate of v̂² − v̂_s² of CollisionTable, and η = ψ/(ψ + ψ₀) of
/// ψ = v_s/v_n. Kinks, where sliding begins or ends, lie in cells of their own.
class ObliqueTable {
 public:
  using Entries = PatchTable<2>;
  using Turnings = PatchTable<10>;  ///< the tenth is not used

  ObliqueTable() = default;
  ObliqueTable(ObliqueKey key, double sticking_squared, double half_way, Entries entries, Turnings turnings, ObliqueQuality quality)
      : key_(key),
        plane_{key.kind.adhesive(), sticking_squared, half_way},
        entries_(std::move(entries)),
        turnings_(std::move(turnings)),
        quality_(quality) {}

  /// At v̂ (1 without adhesion) and ψ = v_s/v_n ≥ 0; nothing where CollisionTable has nothing, or the pair sticks.
  [[nodiscard]] std::optional<ObliqueEntry> find(double speed, double ratio) const;
  /// The same with the turning; nothing too where v̂² − v̂_s² < turning_excess (1 + v̂_s²): next to sticking a little turning decides
  /// whether the pair parts, and there is no first order.
  [[nodiscard]] std::optional<TurningEntry> turning(double speed, double ratio) const;
  static constexpr double turning_excess = 0.02;

  [[nodiscard]] const ObliqueKey& key() const { return key_; }
  [[nodiscard]] const ObliqueQuality& quality() const { return quality_; }
  [[nodiscard]] double sticking_squared() const { return plane_.sticking_squared; }
  [[nodiscard]] double half_way() const { return plane_.half_way; }
  [[nodiscard]] const Entries& entries() const { return entries_; }
  [[nodiscard]] const Turnings& turnings() const { return turnings_; }
  [[nodiscard]] std::size_t bytes() const { return entries_.bytes() + turnings_.bytes(); }

 private:
  ObliqueKey key_;
  ImpactPlane plane_;
  Entries entries_;
  Turnings turnings_;
  ObliqueQuality quality_;
};

}  // namespace scalebreak

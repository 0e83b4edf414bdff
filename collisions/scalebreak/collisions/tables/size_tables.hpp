#pragma once

#include <optional>
#include <vector>

#include <scalebreak/collisions/tables/pair_resolver.hpp>

namespace scalebreak {

/// Radii of spheres of one material, scaled system [m].
struct RadiusRange {
  double least = 0, largest = 0;
};

/// The collisions between spheres of two materials, or of one and a wall, whatever their radii: by tables that all sizes share. Normal and
/// oblique collisions of solid spheres depend on no size once they are reduced. Their rolling depends on one number, `rolling_groups`:
/// of it there are tables 1.1 times apart, and between two of them the loss of rolling is interpolated. Masses, radii and
/// inertias are each pair's own.
class SizeTables {
 public:
  /// `input`: its pair is of the materials, its radii play no part. Obtains all tables that radii within the ranges (the second is not used
  /// for a wall) can ask for.
  SizeTables(const Input& input, const RadiusRange& first, const RadiusRange& second, const TableStore& store,
             const PairTolerance& tolerance);

  /// Of spheres of these radii [m]; the second is 0 of a wall. The impact's normal speed must be positive.
  [[nodiscard]] PairOutcome look_up(double radius1, double radius2, const PairImpact& impact) const;
  [[nodiscard]] PairOutcome integrate(double radius1, double radius2, const PairImpact& impact) const;
  /// What no impact can change.
  [[nodiscard]] Refusal standing_refusal() const { return refusal_; }
  [[nodiscard]] std::size_t rolling_tables() const { return rolling_.size(); }

 private:
  [[nodiscard]] CollidingPair resized(double radius1, double radius2) const;
  [[nodiscard]] std::optional<RollingKey> rolling_key_of(const CollidingPair& pair) const;
  /// Of the table of a strength: a pair of equal spheres, or of a sphere and the wall, of another inertia or size.
  [[nodiscard]] RollingKey rolling_key_at(double strength) const;
  /// Of the key of a pair, the number of the table that is next below it, not rounded.
  [[nodiscard]] double rolling_place(const RollingKey& key) const;
  void obtain_rolling_tables(const RadiusRange& first, const RadiusRange& second, const TableStore& store);
  [[nodiscard]] RollingLookup rolling_of(const CollidingPair& pair) const;

  Input input_;
  PairTolerance tolerance_;
  CollidingPair pair_;  ///< with the input's radii
  SurfacePair surfaces_;
  double adhesive_rolling_ = 1, size_ = 1;
  Refusal refusal_ = Refusal::none;
  std::optional<TableRow> row_;
  std::optional<ObliqueTable> oblique_;
  double first_strength_ = 1;  ///< of the table of number 0
  int first_table_ = 0;        ///< number of the weakest
  std::vector<RollingTable> rolling_;
};

/// Do all sizes share the oblique collisions of a pair of materials? Not where the arms of friction end at the contact, nor does a linear
/// tangential spring beside adhesion, which is another one at every size.
[[nodiscard]] bool sizes_share_oblique(const ContactKind& kind, const SurfaceKind& surface, bool wall);

}  // namespace scalebreak

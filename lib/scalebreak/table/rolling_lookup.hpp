#pragma once

#include <optional>

#include <scalebreak/table/rolling_table.hpp>

namespace scalebreak {

/// What of a RollingKey matters beside v̂, β and the kind: with χ over `unit`, every law but `cdt` depends on one number more, and `cdt` on
/// none. From dχ/dt̂ = −j M̂ and the spring and limit of each law (docs/tables.md):
///
///     cdt     unit j μ_r
///     epsd    unit j μ_r          strength j μ_r²   (its dashpot is η_r √(I_r/(m*R*²)) √j = η_r √(7/2) of solid spheres)
///     epsd2   unit j μ_r          strength j G*/E*  (linear contact: j k_t/k)
///     ar      unit θ_max R*/δ₀    strength j δ₀/R* × the torque factor
struct RollingGroups {
  double unit = 1, strength = 1;
};
[[nodiscard]] RollingGroups rolling_groups(const RollingKey& key);

/// The rolling of one pair by the tables that serve it: its own; or those of two other pairs of like materials, one whose spring is weaker and
/// one whose is stronger. Between these the loss of rolling over the strength is taken as linear in the strength: exact where the spring is
/// weak, and for `cdt`.
class RollingLookup {
 public:
  RollingLookup() = default;  ///< no table
  explicit RollingLookup(const RollingTable& own) : weaker_(&own) {}
  /// Keeps pointers to the tables, which may be one and the same if `pair` has its strength, or is of `cdt`.
  RollingLookup(const RollingTable& weaker, const RollingTable& stronger, const RollingKey& pair);

  [[nodiscard]] explicit operator bool() const { return weaker_ != nullptr; }
  /// As RollingTable::find.
  [[nodiscard]] std::optional<double> find(double speed, double ratio) const;

 private:
  const RollingTable *weaker_ = nullptr, *stronger_ = nullptr;
  double weaker_ratio_ = 1, stronger_ratio_ = 1;  ///< χ of the table over that of the pair
  double weaker_share_ = 1, stronger_share_ = 0;  ///< of their losses in that of the pair
};

}  // namespace scalebreak

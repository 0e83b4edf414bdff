#pragma once

#include <array>
#include <optional>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/table/pair_lookup.hpp>

namespace scalebreak {

/// How well the collisions of a PairResolver must be known.
struct PairTolerance {
  double normal = 1e-6;   ///< of the normal table
  double oblique = 1e-4;  ///< of the oblique and the rolling table
  double turning = 1e-4;  ///< of what the turning of the normal leaves out, over the normal speed
  double exact = 1e-8;    ///< of what is integrated
};

/// Two bodies of an input's scaled system, and what acts between them.
[[nodiscard]] CollidingPair colliding_pair(const Input& input);

/// An impact of the pair of a scene by the exact engine, to a tolerance.
[[nodiscard]] PairOutcome integrate_impact(const MovingScene& scene, const CollidingPair& pair, const PairImpact& impact, double tolerance);

/// The collisions of an input's pair, scaled by its law: by table where the tables answer, by the exact engine where they do not, and how
/// often each.
class PairResolver {
 public:
  /// Obtains the tables that the pair can use. A direct-force law has none.
  PairResolver(const Input& input, const TableStore& store, const PairTolerance& tolerance = {});
  PairResolver(const PairResolver&) = delete;
  PairResolver& operator=(const PairResolver&) = delete;

  /// The impact's normal speed must be positive.
  [[nodiscard]] PairOutcome collide(const PairImpact& impact);
  /// By table alone, uncounted, and by the exact engine alone.
  [[nodiscard]] PairOutcome look_up(const PairImpact& impact) const { return lookup_->resolve(impact, tolerance_.turning); }
  [[nodiscard]] PairOutcome integrate(const PairImpact& impact) const { return integrate_impact(scene_, pair_, impact, tolerance_.exact); }

  /// How many collisions were integrated for a reason; for Refusal::none, looked up.
  [[nodiscard]] long count(Refusal reason) const { return counts_[static_cast<std::size_t>(reason)]; }
  /// What no impact of this pair can change.
  [[nodiscard]] Refusal standing_refusal() const { return lookup_->standing_refusal(); }
  [[nodiscard]] const CollidingPair& pair() const { return pair_; }

 private:
  PairTolerance tolerance_;
  MovingScene scene_;
  CollidingPair pair_;
  std::optional<TableRow> row_;
  std::optional<ObliqueTable> oblique_;
  std::optional<RollingTable> rolling_;
  std::optional<PairLookup> lookup_;
  std::array<long, static_cast<std::size_t>(Refusal::count)> counts_{};
};

}  // namespace scalebreak

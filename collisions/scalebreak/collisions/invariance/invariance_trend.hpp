#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <scalebreak/collisions/invariance/invariance_motion.hpp>

namespace scalebreak {

inline constexpr double kept_tolerance = 1e-7;

/// How a quantity moves with a law's factor: kept, or as factor^exponent with its standard error over all speeds.
struct Trend {
  bool exists = false;
  bool kept = false;   ///< every ratio is 1 within `kept_tolerance`
  double largest = 0;  ///< largest |ratio − 1|
  double exponent = 0, exponent_error = 0;
};

/// Scaled over original, at a factor.
struct TrendPoint {
  double factor, ratio;
};

/// log ratio = p log factor, through the point (1, 1): p and its standard error. NaN with fewer than two points, or a ratio
/// that is not positive.
[[nodiscard]] Trend trend_of(const std::vector<TrendPoint>& points);

/// The scaled motion and the original's, at the input's own overlaps, at a tenth of them, and in the limit of small ones.
struct ComparedMotions {
  PairMotion scaled, original;
  std::optional<PairMotion> scaled_tenth, original_tenth;
  std::optional<PairMotion> scaled_limit, original_limit;
  double size = 1;  ///< scaled over original radius

  [[nodiscard]] bool stuck() const { return scaled.stuck || original.stuck; }
};

/// Something that can be kept of a motion.
struct MotionQuantity {
  std::string_view key;   ///< in files
  std::string_view name;  ///< in sentences
  bool by_ratio;          ///< kept where scaled over original is 1; else where their difference is 0
  /// Of a scaled and its original motion, which differ by a size factor.
  struct Pair {
    double scaled, original;
  };
  std::optional<Pair> (*of)(const PairMotion& scaled, const PairMotion& original, double size);

  /// Scaled over original; none where the original has nothing to be divided by.
  [[nodiscard]] std::optional<double> ratio(const PairMotion& scaled, const PairMotion& original, double size) const;
  /// How far it is from being kept.
  [[nodiscard]] std::optional<double> deviation(const PairMotion& scaled, const PairMotion& original, double size) const;
};

/// All of them, in the order of the documentation.
[[nodiscard]] const std::vector<MotionQuantity>& motion_quantities();
[[nodiscard]] const MotionQuantity& motion_quantity(std::string_view key);

enum class TrendVerdict {
  kept,                 ///< at the overlaps of the input
  kept_to_first_order,  ///< in the limit of small overlaps over radius
  moved
};

/// What becomes of one quantity under a law, over all its factors and speeds.
struct MotionTrend {
  const MotionQuantity* quantity = nullptr;
  TrendVerdict verdict = TrendVerdict::moved;
  double largest = 0;          ///< largest deviation at the overlaps of the input
  double largest_limit = 0;    ///< the same in the limit
  bool limit = false;          ///< is there one
  Trend power;                 ///< of its ratio in the limit, or at the input's overlaps if there is none
  bool overlap_power = false;  ///< kept in the limit only: the deviation goes as (overlap over radius)^p
  double overlap_exponent = 0, overlap_exponent_error = 0;
};

/// A compared motion at its factor.
struct MotionPoint {
  double factor;
  const ComparedMotions* motions;
};

/// One for every quantity that exists in at least one of the motions. Pairs of which one sticks are left out.
[[nodiscard]] std::vector<MotionTrend> motion_trends(const std::vector<MotionPoint>& points);

}  // namespace scalebreak

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace scalebreak {

/// What a table answers: a collision in reduced variables.
struct TableOutcome {
  bool stuck = false;
  double restitution = 0;
  double contact_time = 0;
  double max_overlap = 0;
};

/// The bounds that every table covers. Beyond them a collision is resolved exactly, and counted.
struct TableBounds {
  static constexpr double restitution_min = 0.05;
  static constexpr double excess_min = 1e-4;  ///< v̂² − v̂_s² of the slowest collision, over 1 + v̂_s²
  static constexpr double excess_max = 1e10;  ///< and of the fastest

  /// Next to the sticking speed no table answers: `excess` = v̂² − v̂_s² within this.
  [[nodiscard]] static double margin(double sticking_squared) { return excess_min * (1 + sticking_squared); }
};

/// A collision table at one damping ratio, which a pair of materials keeps for life: the fast lookup. Its cells
/// are quarters of the binary octaves of v̂² − v̂_s², found from the bits of that number, each with one
/// polynomial of fifth degree; what that adds to the table's error is below 1e-8.
class TableRow {
 public:
  /// A contact without adhesion: one outcome at every speed.
  explicit TableRow(TableOutcome scale_free) : scale_free_(scale_free) {}
  /// `at(excess)` is the outcome at v̂² − v̂_s² = excess.
  TableRow(double sticking_squared, const std::function<TableOutcome(double)>& at);

  /// The collision at reduced speed v̂, or nothing where the table does not reach (see CollisionTable::find).
  [[nodiscard]] std::optional<TableOutcome> find(double speed) const;
  [[nodiscard]] double sticking_speed() const;

 private:
  static constexpr int degree = 5;
  using Value = Eigen::Array4d;  ///< restitution, contact time, largest overlap, padding
  using Cell = std::array<Value, degree + 1>;

  double sticking_squared_ = 0;
  std::uint64_t first_cell_ = 0;
  std::vector<Cell> cells_;
  TableOutcome scale_free_;  ///< used where there are no cells
};

}  // namespace scalebreak

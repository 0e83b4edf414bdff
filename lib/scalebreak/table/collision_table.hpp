#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/table/lagrange.hpp>
#include <scalebreak/table/table_row.hpp>

namespace scalebreak {

/// One resolved collision of a table, in reduced variables (see contact/reduced.hpp).
struct TableNode {
  double damping_ratio;   ///< β
  double speed;           ///< v̂; 1 without adhesion
  double sticking_speed;  ///< at this β; 0 where nothing can stick
  double restitution;
  double contact_time;
  double max_overlap;
};

/// The sticking speed squared over the damping axis, a curve of its own on a finer grid.
struct StickingCurve {
  Axis axis;
  std::vector<double> squared;
};

/// What a table is of, and how well it must do. The node grid is the builder's to choose.
struct TableKey {
  ContactKind kind;
  double tolerance = 1e-6;  ///< of e² and of the relative contact time, between the nodes

  bool operator==(const TableKey&) const = default;
};

/// Errors of the table against fresh exact collisions between its nodes.
struct TableQuality {
  double error_max = 0;  ///< largest of |Δe²| and |Δt_c|/t_c
  double error_rms = 0;
  double sticking_speed_error = 0;  ///< relative, between the nodes of its curve
  double max_overlap_error = 0;     ///< relative
  int samples = 0;
};

/// What a table interpolates at a node, and one lane of padding: e²v̂²/(v̂² − v̂_s²) (e² without adhesion), the
/// contact time without its corner at rest, and √a at the largest overlap over x (that overlap without adhesion).
using SmoothNode = Eigen::Array4d;

/// Restitution, contact time and largest overlap of the normal collisions of one kind of contact, over the
/// impact speed and the damping ratio, by interpolation of fifth degree. The axes are those in which
/// the outcome is smooth: u = (−ln e/π)^{1/2} and ξ = x/(1 + x) with x⁵ = (v̂² − v̂_s²)^{1/2}, and
/// what is interpolated is e²v̂²/(v̂² − v̂_s²), the contact time without its corner at rest, and √a over x.
class CollisionTable {
 public:
  /// `nodes` row by row: speed runs fastest. Throws WorkError if the shapes disagree.
  CollisionTable(TableKey key, Axis damping, Axis speed, std::vector<TableNode> nodes, StickingCurve sticking, TableQuality quality);

  /// The collision at damping ratio β and reduced speed v̂, or nothing where the table does not reach:
  /// next to the sticking speed (|v̂² − v̂_s²| < 1e-4 (1 + v̂_s²)), beyond v̂ = 1e5, or e < 0.05.
  [[nodiscard]] std::optional<TableOutcome> find(double damping_ratio, double speed) const;

  /// The table at one damping ratio; nothing where e < 0.05.
  [[nodiscard]] std::optional<TableRow> row(double damping_ratio) const;

  [[nodiscard]] const TableKey& key() const { return key_; }
  [[nodiscard]] const TableQuality& quality() const { return quality_; }
  [[nodiscard]] const Axis& damping_axis() const { return damping_; }
  [[nodiscard]] const Axis& speed_axis() const { return speed_; }
  [[nodiscard]] const std::vector<TableNode>& nodes() const { return nodes_; }
  [[nodiscard]] const StickingCurve& sticking() const { return sticking_; }

  /// The coordinates of the axes.
  [[nodiscard]] static double damping_coordinate(double damping_ratio);
  [[nodiscard]] static double damping_ratio_at(double coordinate);
  [[nodiscard]] static double speed_coordinate(double excess_squared);
  [[nodiscard]] static double excess_squared_at(double coordinate);

 private:
  [[nodiscard]] SmoothNode smooth(const TableNode& node, double coordinate) const;
  [[nodiscard]] double sticking_squared(double coordinate) const;

  TableKey key_;
  Axis damping_, speed_;
  std::vector<TableNode> nodes_;
  StickingCurve sticking_;
  TableQuality quality_;
  std::vector<SmoothNode> smooth_;
};

}  // namespace scalebreak

#include <scalebreak/table/collision_table.hpp>

#include <cmath>
#include <numbers>

#include <scalebreak/base/error.hpp>
#include <scalebreak/contact/damping.hpp>
#include <scalebreak/contact/reduced.hpp>

namespace scalebreak {
namespace {

/// A JKR contact starts under the force −(8/9)F_po: with speed v it saves the time v/(8/9) of falling in from
/// rest. That term has a corner where v̂ and v̂_s vanish together; it is taken out of what is interpolated.
/// It fades for fast impacts, which hardly feel it.
double entry_time(double speed) { return 9.0 / 8.0 * speed / (1 + speed * speed); }

/// In its coordinate the largest overlap is smooth over the speed.
const Jkr<double>& unit_jkr() {
  static const auto law = reduced_law<JkrOnRadius>(0.0, AdhesionRange::full);
  return law;
}

/// From what is interpolated back to the outcome, with adhesion.
inline TableOutcome outcome(const SmoothNode& node, double speed, double excess, double coordinate) {
  return {.stuck = false,
          .restitution = std::sqrt(node[0] * excess) / speed,
          .contact_time = node[1] - entry_time(speed),
          .max_overlap = unit_jkr().overlap(node[2] * coordinate / (1 - coordinate))};
}

/// And without, where the speed is in the units.
TableOutcome scale_free_outcome(const SmoothNode& node) {
  return {.stuck = false, .restitution = std::sqrt(node[0]), .contact_time = node[1], .max_overlap = node[2]};
}

}  // namespace

double CollisionTable::damping_coordinate(double damping_ratio) {
  return std::sqrt(damping_ratio / std::sqrt(1 - damping_ratio * damping_ratio));
}

double CollisionTable::damping_ratio_at(double coordinate) {
  const double square = coordinate * coordinate;
  return square / std::sqrt(1 + square * square);
}

double CollisionTable::speed_coordinate(double excess_squared) {
  const double x = std::pow(excess_squared, 0.1);
  return x / (1 + x);
}

double CollisionTable::excess_squared_at(double coordinate) { return std::pow(coordinate / (1 - coordinate), 10); }

CollisionTable::CollisionTable(TableKey key, Axis damping, Axis speed, std::vector<TableNode> nodes, StickingCurve sticking,
                               TableQuality quality)
    : key_(key), damping_(damping), speed_(speed), nodes_(std::move(nodes)), sticking_(std::move(sticking)), quality_(quality) {
  const bool adhesive = key_.kind.adhesive();
  const auto count = static_cast<std::size_t>(damping_.count) * static_cast<std::size_t>(speed_.count);
  if (damping_.count < Stencil::width || (adhesive ? speed_.count < Stencil::width : speed_.count != 1) || nodes_.size() != count ||
      sticking_.squared.size() != static_cast<std::size_t>(sticking_.axis.count) || (adhesive && sticking_.axis.count < Stencil::width)) {
    throw WorkError("a collision table has a shape that does not fit its axes");
  }
  smooth_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    smooth_.push_back(smooth(nodes_[i], speed_.at(static_cast<double>(i % static_cast<std::size_t>(speed_.count)))));
  }
}

SmoothNode CollisionTable::smooth(const TableNode& node, double coordinate) const {
  const double energy = node.restitution * node.restitution;
  if (!key_.kind.adhesive()) return {energy, node.contact_time, node.max_overlap, 0};
  const double ratio = energy * node.speed * node.speed / excess_squared_at(coordinate);
  const double scaled = unit_jkr().coordinate(node.max_overlap) * (1 - coordinate) / coordinate;
  return {ratio, node.contact_time + entry_time(node.speed), scaled, 0};
}

double CollisionTable::sticking_squared(double coordinate) const {
  if (!key_.kind.adhesive()) return 0;
  return std::max(Stencil(sticking_.axis, coordinate).of(sticking_.squared.data()), 0.0);
}

std::optional<TableRow> CollisionTable::row(double damping_ratio) const {
  const double u = damping_coordinate(damping_ratio);
  if (!(u <= damping_.last())) return std::nullopt;
  if (!key_.kind.adhesive()) return TableRow(*find(damping_ratio, 1.0));
  const double sticking = sticking_squared(u);
  std::vector<SmoothNode> nodes(static_cast<std::size_t>(speed_.count), SmoothNode::Zero());
  const Stencil rows(damping_, u);
  for (int j = 0; j < Stencil::width; ++j) {
    const SmoothNode* from = smooth_.data() + static_cast<std::ptrdiff_t>(rows.begin + j) * speed_.count;
    for (int i = 0; i < speed_.count; ++i) nodes[static_cast<std::size_t>(i)] += rows.weight[static_cast<std::size_t>(j)] * from[i];
  }
  return TableRow(sticking, [&](double excess) {
    const double coordinate = speed_coordinate(excess);
    return outcome(Stencil(speed_, coordinate).of(nodes.data()), std::sqrt(excess + sticking), excess, coordinate);
  });
}

std::optional<TableOutcome> CollisionTable::find(double damping_ratio, double speed) const {
  const double u = damping_coordinate(damping_ratio);
  if (!(u <= damping_.last())) return std::nullopt;
  const Stencil rows(damping_, u);
  const bool adhesive = key_.kind.adhesive();
  const double sticking = sticking_squared(u), excess = speed * speed - sticking, margin = TableBounds::margin(sticking);
  if (adhesive && excess < -margin) return TableOutcome{.stuck = true};
  if (adhesive && !(excess >= margin && excess <= TableBounds::excess_max)) return std::nullopt;
  const double coordinate = adhesive ? speed_coordinate(excess) : 0;
  const Stencil columns(speed_, coordinate);
  SmoothNode sum = SmoothNode::Zero();
  for (int j = 0; j < Stencil::width; ++j) {
    const SmoothNode* row = smooth_.data() + static_cast<std::ptrdiff_t>(rows.begin + j) * speed_.count;
    sum += rows.weight[static_cast<std::size_t>(j)] * (adhesive ? columns.of(row) : *row);
  }
  return adhesive ? outcome(sum, speed, excess, coordinate) : scale_free_outcome(sum);
}

}  // namespace scalebreak

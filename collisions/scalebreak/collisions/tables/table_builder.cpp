#include <scalebreak/collisions/tables/table_builder.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/collisions/parallel.hpp>
#include <scalebreak/contact/damping.hpp>

namespace scalebreak {
namespace {

constexpr int largest_axis = 1025;
/// Of the table's tolerance, for the sticking curve: next to sticking its error is magnified in the contact time.
constexpr double curve_share = 1e-3;

/// Everything a build knows.
class Builder {
 public:
  Builder(const TableKey& key, int threads) : key_(key), threads_(threads), exact_tolerance_(1e-4 * std::min(key.tolerance, 1e-5)) {}

  /// Relative error of the curve's last grid, where a speed below the table's first counts as that speed; the
  /// curve is refined until it is far below the table's.
  double build_sticking_curve() {
    if (!key_.kind.adhesive()) {
      curve_ = {Axis::span(0, 0, 1), {0.0}};
      return 0;
    }
    const double last = damping_last();
    curve_ = {Axis::span(0, last, 129), std::vector<double>(129)};
    parallel_for(129, threads_, [&](int i) { curve_.squared[static_cast<std::size_t>(i)] = sticking_squared(curve_.axis.at(i)); });
    for (;;) {
      const int cells = curve_.axis.count - 1;
      std::vector<double> between(static_cast<std::size_t>(cells));
      parallel_for(cells, threads_, [&](int i) { between[static_cast<std::size_t>(i)] = sticking_squared(curve_.axis.at(i + 0.5)); });
      double error = 0;
      for (int i = 0; i < cells; ++i) {
        const double exact = between[static_cast<std::size_t>(i)];
        error = std::max(error, std::abs(stick(curve_.axis.at(i + 0.5)) - exact) / (exact + TableBounds::excess_min) / 2);
      }
      if (error < curve_share * key_.tolerance) return error;
      if (cells > 8 * largest_axis) {
        throw WorkError(fmt::format("the sticking speed of {} is not smooth enough: its error is {:.2g} with {} nodes, above {:.2g}",
                                    to_string(key_.kind), error, cells + 1, curve_share * key_.tolerance));
      }
      StickingCurve finer{Axis::span(0, last, 2 * cells + 1), {}};
      for (std::size_t i = 0; i < between.size(); ++i) finer.squared.insert(finer.squared.end(), {curve_.squared[i], between[i]});
      finer.squared.push_back(curve_.squared.back());
      curve_ = std::move(finer);
    }
  }

  CollisionTable build_nodes(int damping_count, int speed_count) const {
    const Axis damping = Axis::span(0, damping_last(), damping_count);
    const Axis speed = key_.kind.adhesive() ? Axis::span(CollisionTable::speed_coordinate(TableBounds::excess_min),
                                                         CollisionTable::speed_coordinate(TableBounds::excess_max), speed_count)
                                            : Axis::span(0, 0, 1);
    std::vector<TableNode> nodes(static_cast<std::size_t>(damping.count) * static_cast<std::size_t>(speed.count));
    parallel_for(static_cast<int>(nodes.size()), threads_, [&](int i) {
      const double u = damping.at(i / speed.count);
      nodes[static_cast<std::size_t>(i)] = node(CollisionTable::damping_ratio_at(u), stick(u), speed.at(i % speed.count));
    });
    return {key_, damping, speed, std::move(nodes), curve_, {}};
  }

  /// Errors at points that sit `shift` of a step off the nodes of each axis, in every `stride`-th cell.
  struct Errors {
    double energy_or_time = 0, overlap = 0, sum_of_squares = 0;
    int samples = 0;
  };
  Errors measure(const CollisionTable& table, double damping_shift, double speed_shift, int damping_stride, int speed_stride) const {
    const Axis& damping = table.damping_axis();
    const Axis& speed = table.speed_axis();
    const int rows = (damping.count - (damping_shift > 0 ? 2 : 1)) / damping_stride + 1;
    const int columns = speed.count == 1 ? 1 : (speed.count - (speed_shift > 0 ? 2 : 1)) / speed_stride + 1;
    // The sticking speed afresh, not the curve's: what the curve gets wrong is the table's error too.
    std::vector<double> stick_at(static_cast<std::size_t>(rows));
    const auto coordinate = [&](int row) { return damping.at(row * damping_stride + damping_shift); };
    parallel_for(rows, threads_, [&](int row) { stick_at[static_cast<std::size_t>(row)] = sticking_squared(coordinate(row)); });
    std::vector<std::optional<std::pair<double, double>>> errors(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    parallel_for(static_cast<int>(errors.size()), threads_, [&](int i) {
      const double beta = CollisionTable::damping_ratio_at(coordinate(i / columns));
      const double v = speed_at(stick_at[static_cast<std::size_t>(i / columns)], speed.at(i % columns * speed_stride + speed_shift));
      const auto found = table.find(beta, v);
      if (!found) return;  // closer to sticking than the table answers for
      const TableOutcome exact = exact_table_outcome(key_.kind, beta, v, exact_tolerance_ / 10);
      if (found->stuck || exact.stuck) {
        throw WorkError(
            fmt::format("a table point of {} sticks at β {:g}, v̂ {:g}, above its sticking speed", to_string(key_.kind), beta, v));
      }
      errors[static_cast<std::size_t>(i)] = {
          std::max(std::abs(found->restitution * found->restitution - exact.restitution * exact.restitution),
                   std::abs(found->contact_time / exact.contact_time - 1)),
          std::abs(found->max_overlap / exact.max_overlap - 1)};
    });
    Errors all;
    for (const auto& point : errors) {
      if (!point) continue;
      all.energy_or_time = std::max(all.energy_or_time, point->first);
      all.overlap = std::max(all.overlap, point->second);
      all.sum_of_squares += point->first * point->first;
      ++all.samples;
    }
    return all;
  }

 private:
  [[nodiscard]] static double damping_last() { return CollisionTable::damping_coordinate(damping_ratio(TableBounds::restitution_min)); }
  [[nodiscard]] double sticking_squared(double u) const {
    const double speed = reduced_sticking_speed(key_.kind, CollisionTable::damping_ratio_at(u), 1e-11);
    return speed * speed;
  }
  /// The curve's own value, so that a node sits where a lookup will think it does.
  [[nodiscard]] double stick(double u) const {
    return key_.kind.adhesive() ? std::max(Stencil(curve_.axis, u).of(curve_.squared.data()), 0.0) : 0.0;
  }
  [[nodiscard]] double speed_at(double sticking_squared, double coordinate) const {
    return key_.kind.adhesive() ? std::sqrt(sticking_squared + CollisionTable::excess_squared_at(coordinate)) : 1.0;
  }
  [[nodiscard]] TableNode node(double beta, double sticking_squared, double coordinate) const {
    const double speed = speed_at(sticking_squared, coordinate);
    const TableOutcome exact = exact_table_outcome(key_.kind, beta, speed, exact_tolerance_);
    return {beta, speed, std::sqrt(sticking_squared), exact.restitution, exact.contact_time, exact.max_overlap};
  }

  TableKey key_;
  int threads_;
  double exact_tolerance_;
  StickingCurve curve_;
};

}  // namespace

TableOutcome exact_table_outcome(const ContactKind& kind, double damping_ratio, double speed, double tolerance) {
  const auto exact = resolve_normal_collision<double>(kind, damping_ratio, speed, {.tolerance = tolerance});
  return {exact.stuck, exact.restitution, exact.contact_time, exact.max_overlap};
}

CollisionTable build_collision_table(const TableKey& key, int threads, const std::function<void(double)>& progress) {
  if (!(key.tolerance >= 1e-7 && key.tolerance <= 1e-2))
    throw WorkError(fmt::format("a collision table has a tolerance of 1e-7 to 1e-2, found {:g}", key.tolerance));
  const TableKey canonical_key{canonical(key.kind), key.tolerance};
  const auto report = [&](double done) {
    if (progress) progress(done);
  };
  Builder builder(canonical_key, threads);
  report(0);
  const double sticking_error = builder.build_sticking_curve();
  report(0.3);
  const bool adhesive = canonical_key.kind.adhesive();
  int damping_count = 17, speed_count = adhesive ? 33 : 1;
  for (;;) {
    const CollisionTable table = builder.build_nodes(damping_count, speed_count);
    // Half a step off along one axis alone tells which axis is too coarse; off along both is the measure.
    const auto along_damping = builder.measure(table, 0.5, 0, 1, 4);
    const auto along_speed = adhesive ? builder.measure(table, 0, 0.5, 4, 1) : Builder::Errors{};
    const double error = std::max({along_damping.energy_or_time, along_speed.energy_or_time, along_damping.overlap, along_speed.overlap});
    if (error < 0.5 * canonical_key.tolerance) {
      const auto all = builder.measure(table, 0.5, 0.5, 1, 1);
      if (all.energy_or_time < canonical_key.tolerance) {
        TableQuality quality;
        quality.error_max = std::max({all.energy_or_time, along_damping.energy_or_time, along_speed.energy_or_time});
        quality.samples = all.samples + along_damping.samples + along_speed.samples;
        quality.error_rms = std::sqrt((all.sum_of_squares + along_damping.sum_of_squares + along_speed.sum_of_squares) / quality.samples);
        quality.sticking_speed_error = sticking_error;
        quality.max_overlap_error = std::max({all.overlap, along_damping.overlap, along_speed.overlap});
        report(1);
        return {canonical_key, table.damping_axis(), table.speed_axis(), table.nodes(), table.sticking(), quality};
      }
    }
    const double damping_error = std::max(along_damping.energy_or_time, along_damping.overlap);
    const double speed_error = std::max(along_speed.energy_or_time, along_speed.overlap);
    if (damping_error >= 0.5 * canonical_key.tolerance || damping_error >= speed_error) damping_count = 2 * damping_count - 1;
    if (adhesive && (speed_error >= 0.5 * canonical_key.tolerance || speed_error > damping_error)) speed_count = 2 * speed_count - 1;
    if (std::max(damping_count, speed_count) > largest_axis) {
      throw WorkError(fmt::format(
          "the table of {} does not come safely below a tolerance of {:g}: its error along an axis is {:.2g} with {} x {} nodes",
          to_string(canonical_key.kind), canonical_key.tolerance, error, table.damping_axis().count, table.speed_axis().count));
    }
    report(0.6);
  }
}

}  // namespace scalebreak

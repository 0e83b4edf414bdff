#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <scalebreak/table/collision_table.hpp>
#include <scalebreak/table/oblique_table.hpp>
#include <scalebreak/table/rolling_table.hpp>

namespace scalebreak {

/// Where tables are kept and how they are made.
struct TableStore {
  std::filesystem::path folder;                      ///< of the cache
  int threads = 0;                                   ///< for building; 0: all
  std::function<void(const std::string&)> say = {};  ///< told, in a sentence, of a table that could not be used
  std::function<void(double)> progress = {};         ///< share of a build that is done
};

/// A table and how it was had.
struct StoredTable {
  CollisionTable table;
  bool built = false;
  double build_seconds = 0;  ///< 0 if it was read
};

/// The user's cache folder for tables: $XDG_CACHE_HOME or ~/.cache, then scalebreak/tables.
[[nodiscard]] std::filesystem::path default_table_folder();

/// Reads the table of a key from the store, or builds it and keeps it there. A stale or damaged file is named and
/// replaced. `rebuild` builds in any case. Throws WorkError as build_collision_table does.
[[nodiscard]] StoredTable obtain_table(const TableKey& key, const TableStore& store, bool rebuild = false);

/// An oblique table and how it was had.
struct StoredObliqueTable {
  ObliqueTable table;
  bool built = false;
  double build_seconds = 0;  ///< 0 if it was read
};

/// The same for an oblique table.
[[nodiscard]] StoredObliqueTable obtain_oblique_table(const ObliqueKey& key, const TableStore& store, bool rebuild = false);

/// And for a rolling table.
struct StoredRollingTable {
  RollingTable table;
  bool built = false;
  double build_seconds = 0;  ///< 0 if it was read
};
[[nodiscard]] StoredRollingTable obtain_rolling_table(const RollingKey& key, const TableStore& store, bool rebuild = false);

/// Collisions by table where it reaches, exactly where it does not, and how often each.
class CollisionSource {
 public:
  /// One row of `table`, at this damping ratio; where e < 0.05 everything is resolved exactly.
  CollisionSource(const CollisionTable& table, double damping_ratio, double exact_tolerance);

  [[nodiscard]] TableOutcome collide(double reduced_speed);
  [[nodiscard]] long looked_up() const { return looked_up_; }
  [[nodiscard]] long resolved_exactly() const { return resolved_exactly_; }

 private:
  ContactKind kind_;
  double damping_ratio_;
  double exact_tolerance_;
  std::optional<TableRow> row_;
  long looked_up_ = 0;
  long resolved_exactly_ = 0;
};

}  // namespace scalebreak

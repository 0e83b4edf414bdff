#include <scalebreak/collisions/tables/table_store.hpp>

#include <chrono>
#include <cstdlib>
#include <mutex>

#include <fmt/format.h>

#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>
#include <scalebreak/collisions/tables/table_builder.hpp>
#include <scalebreak/table/oblique_table_file.hpp>
#include <scalebreak/table/rolling_table_file.hpp>
#include <scalebreak/table/table_file.hpp>

namespace scalebreak {

std::filesystem::path default_table_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  const std::filesystem::path root =
      cache && *cache ? std::filesystem::path(cache) : std::filesystem::path(home && *home ? home : ".") / ".cache";
  return root / "scalebreak" / "tables";
}

namespace {

/// Reads what is kept, or builds and keeps it. One thread at a time: a table is two files, and what all want is built once, by all cores.
template <class Stored, class Read, class Build, class Write>
Stored obtain(const std::string& name, const TableStore& store, bool rebuild, const Read& read, const Build& build, const Write& write) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  if (!rebuild) {
    auto found = read();
    if (found.table) return {.table = std::move(*found.table)};
    if (!found.problem.empty() && store.say) {
      store.say(fmt::format("the table {} in {} is not used: {}; it is built anew", name, store.folder.string(), found.problem));
    }
  }
  const auto start = std::chrono::steady_clock::now();
  Stored stored{.table = build(), .built = true};
  stored.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write(stored.table);
  return stored;
}

}  // namespace

StoredTable obtain_table(const TableKey& key, const TableStore& store, bool rebuild) {
  return obtain<StoredTable>(
      table_file_name(key), store, rebuild, [&] { return read_table(store.folder, key); },
      [&] { return build_collision_table(key, store.threads, store.progress); },
      [&](const CollisionTable& table) { write_table(store.folder, table); });
}

StoredObliqueTable obtain_oblique_table(const ObliqueKey& key, const TableStore& store, bool rebuild) {
  return obtain<StoredObliqueTable>(
      oblique_table_file_name(key), store, rebuild, [&] { return read_oblique_table(store.folder, key); },
      [&] { return build_oblique_table(key, store.threads, store.progress); },
      [&](const ObliqueTable& table) { write_oblique_table(store.folder, table); });
}

StoredRollingTable obtain_rolling_table(const RollingKey& key, const TableStore& store, bool rebuild) {
  return obtain<StoredRollingTable>(
      rolling_table_file_name(key), store, rebuild, [&] { return read_rolling_table(store.folder, key); },
      [&] { return build_rolling_table(key, store.threads, store.progress); },
      [&](const RollingTable& table) { write_rolling_table(store.folder, table); });
}

CollisionSource::CollisionSource(const CollisionTable& table, double damping_ratio, double exact_tolerance)
    : kind_(table.key().kind), damping_ratio_(damping_ratio), exact_tolerance_(exact_tolerance), row_(table.row(damping_ratio)) {}

TableOutcome CollisionSource::collide(double reduced_speed) {
  if (row_) {
    if (const auto found = row_->find(reduced_speed)) {
      ++looked_up_;
      return *found;
    }
  }
  ++resolved_exactly_;
  return exact_table_outcome(kind_, damping_ratio_, reduced_speed, exact_tolerance_);
}

}  // namespace scalebreak

#include <scalebreak/collisions/table_store.hpp>

#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

#include <scalebreak/collisions/table_builder.hpp>
#include <scalebreak/table/table_file.hpp>

namespace scalebreak {

std::filesystem::path default_table_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  const std::filesystem::path root =
      cache && *cache ? std::filesystem::path(cache) : std::filesystem::path(home && *home ? home : ".") / ".cache";
  return root / "scalebreak" / "tables";
}

StoredTable obtain_table(const TableKey& key, const TableStore& store, bool rebuild) {
  if (!rebuild) {
    TableOnDisk found = read_table(store.folder, key);
    if (found.table) return {.table = std::move(*found.table)};
    if (!found.problem.empty() && store.say) {
      store.say(
          fmt::format("the table {} in {} is not used: {}; it is built anew", table_file_name(key), store.folder.string(), found.problem));
    }
  }
  const auto start = std::chrono::steady_clock::now();
  StoredTable stored{.table = build_collision_table(key, store.threads, store.progress), .built = true};
  stored.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_table(store.folder, stored.table);
  return stored;
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

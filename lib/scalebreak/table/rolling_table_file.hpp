#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <scalebreak/table/rolling_table.hpp>

namespace scalebreak {

/// A rolling table on disk is NAME.npy, the values at the nodes of the cells (cell by node), and NAME.json with the key, the tree of
/// cells, the measured error, versions and a checksum. See docs/tables.md.

/// The name without ending, made of the key.
[[nodiscard]] std::string rolling_table_file_name(const RollingKey& key);

/// Writes the files into `folder`, each whole or not at all.
void write_rolling_table(const std::filesystem::path& folder, const RollingTable& table);

/// What was found: a table, or why there is none that may be used.
struct RollingTableOnDisk {
  std::optional<RollingTable> table;
  std::string problem;  ///< empty with a table, and where there are no files at all
};

/// Reads the table of a key. A stale (other version or key) or damaged one is never returned.
[[nodiscard]] RollingTableOnDisk read_rolling_table(const std::filesystem::path& folder, const RollingKey& key);

}  // namespace scalebreak

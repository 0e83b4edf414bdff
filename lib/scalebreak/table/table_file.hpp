#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <scalebreak/table/collision_table.hpp>

namespace scalebreak {

/// A table on disk is NAME.npy, a NumPy structured array of its nodes (damping by speed), and NAME.json beside it
/// with its key, tolerance, measured error, axes, sticking curve, versions and a checksum. See docs/tables.md.

/// The name without ending, made of the key.
[[nodiscard]] std::string table_file_name(const TableKey& key);

/// Writes both files into `folder`, each whole or not at all.
void write_table(const std::filesystem::path& folder, const CollisionTable& table);

/// What was found: a table, or why there is none that may be used.
struct TableOnDisk {
  std::optional<CollisionTable> table;
  std::string problem;  ///< empty with a table, and where there are no files at all
};

/// Reads the table of a key. A stale (other version, key or tolerance) or damaged one is never returned.
[[nodiscard]] TableOnDisk read_table(const std::filesystem::path& folder, const TableKey& key);

}  // namespace scalebreak

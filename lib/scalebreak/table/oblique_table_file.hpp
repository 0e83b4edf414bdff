#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <scalebreak/table/oblique_table.hpp>

namespace scalebreak {

/// An oblique table on disk is three files: NAME-entries.npy and NAME-turnings.npy, the values at the nodes of the cells (cell by node by function), and
/// NAME.json with the key, the trees of cells, the measured error, versions and a checksum. See docs/tables.md.

/// The name without ending, made of the key.
[[nodiscard]] std::string oblique_table_file_name(const ObliqueKey& key);

/// Writes the files into `folder`, each whole or not at all.
void write_oblique_table(const std::filesystem::path& folder, const ObliqueTable& table);

/// What was found: a table, or why there is none that may be used.
struct ObliqueTableOnDisk {
  std::optional<ObliqueTable> table;
  std::string problem;  ///< empty with a table, and where there are no files at all
};

/// Reads the table of a key. A stale (other version or key) or damaged one is never returned.
[[nodiscard]] ObliqueTableOnDisk read_oblique_table(const std::filesystem::path& folder, const ObliqueKey& key);

}  // namespace scalebreak

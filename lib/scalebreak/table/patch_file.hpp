#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/table/npy.hpp>
#include <scalebreak/table/patch_table.hpp>

namespace scalebreak {

/// The values at the nodes as a NumPy file: cell by node by function.
template <int Lanes>
std::string array_of(const PatchTable<Lanes>& table) {
  using Table = PatchTable<Lanes>;
  std::string bytes = npy_header("'<f8'", {table.cells(), Table::nodes_of_cell, Lanes});
  bytes.append(reinterpret_cast<const char*>(table.values().data()), table.values().size() * sizeof(typename Table::Value));
  return bytes;
}

/// The tree as [next, axis].
template <int Lanes>
nlohmann::json tree_json(const PatchTable<Lanes>& table) {
  nlohmann::json tree = nlohmann::json::array();
  for (const auto& branch : table.tree()) tree.push_back({branch.next, branch.axis});
  return tree;
}

/// Throws nlohmann::json exceptions, or a sentence on what does not fit.
template <int Lanes>
PatchTable<Lanes> table_of(const nlohmann::json& tree_text, const std::string& array) {
  using Table = PatchTable<Lanes>;
  std::vector<typename Table::Branch> tree;
  for (const nlohmann::json& branch : tree_text) tree.push_back({branch.at(0), branch.at(1)});
  std::size_t leaves = 0;
  for (const auto& branch : tree) leaves += branch.axis < 0;
  std::vector<typename Table::Value> values(leaves * Table::nodes_of_cell);
  const std::size_t bytes = values.size() * sizeof(typename Table::Value);
  const std::string header = npy_header("'<f8'", {leaves, Table::nodes_of_cell, Lanes});
  if (array.size() != header.size() + bytes || array.compare(0, header.size(), header) != 0)
    throw std::string("its array does not fit its tree");
  for (const auto& branch : tree) {
    const bool leaf = branch.axis < 0;
    const std::size_t last = static_cast<std::size_t>(branch.next) + (leaf ? 0 : 1);
    if (branch.next < 0 || branch.axis > 1 || last >= (leaf ? leaves : tree.size())) throw std::string("its tree points outside");
  }
  std::memcpy(static_cast<void*>(values.data()), array.data() + header.size(), bytes);
  return {std::move(tree), std::move(values)};
}

}  // namespace scalebreak

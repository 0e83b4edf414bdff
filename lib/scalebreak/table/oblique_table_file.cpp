#include <scalebreak/table/oblique_table_file.hpp>

#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/table/npy.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

/// Of the layout *and* of the numbers: raise it when either changes.
constexpr int format_version = 1;

json key_json(const ObliqueKey& key) {
  return {{"contact", to_string(key.kind)},
          {"surface", to_string(key.surface)},
          {"damping_ratio", key.damping_ratio},
          {"friction", key.friction},
          {"stiffness", key.stiffness},
          {"inertia", key.inertia},
          {"share", key.share},
          {"tolerance", key.tolerance}};
}

template <int Lanes>
std::string array_of(const PatchTable<Lanes>& table) {
  using Table = PatchTable<Lanes>;
  std::string bytes = npy_header("'<f8'", {table.cells(), Table::nodes_of_cell, Lanes});
  bytes.append(reinterpret_cast<const char*>(table.values().data()), table.values().size() * sizeof(typename Table::Value));
  return bytes;
}

template <int Lanes>
json tree_json(const PatchTable<Lanes>& table) {
  json tree = json::array();
  for (const auto& branch : table.tree()) tree.push_back({branch.next, branch.axis});
  return tree;
}

/// Throws json exceptions, or a sentence on what does not fit.
template <int Lanes>
PatchTable<Lanes> table_of(const json& tree_text, const std::string& array) {
  using Table = PatchTable<Lanes>;
  std::vector<typename Table::Branch> tree;
  for (const json& branch : tree_text) tree.push_back({branch.at(0), branch.at(1)});
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

ObliqueTable parse(const std::string& text, const std::string& entries, const std::string& turnings, const ObliqueKey& key) {
  json j = json::parse(text);
  const json said = j.at("checksum");
  j.erase("checksum");
  if (j.at("format_version") != format_version)
    throw fmt::format("it has format version {}, this program has {}", j.at("format_version").dump(), format_version);
  if (j.at("key") != key_json(key)) throw std::string("it is of another key");
  const std::string body = j.dump();
  if (said != crc32({entries, turnings, body})) throw std::string("its checksum does not fit");
  const json& q = j.at("quality");
  return {key,
          j.at("sticking_speed_squared"),
          j.at("half_way_ratio"),
          table_of<2>(j.at("entry_cells"), entries),
          table_of<10>(j.at("turning_cells"), turnings),
          {q.at("error_max"), q.at("error_rms"), q.at("turning_error_median"), q.at("samples")}};
}

}  // namespace

std::string oblique_table_file_name(const ObliqueKey& key) {
  return fmt::format("oblique-{}-{:08x}", to_string(key.kind.normal), crc32({key_json(key).dump()}));
}

void write_oblique_table(const std::filesystem::path& folder, const ObliqueTable& table) {
  const std::string name = oblique_table_file_name(table.key());
  const std::string entries = array_of(table.entries()), turnings = array_of(table.turnings());
  const ObliqueQuality& quality = table.quality();
  json j = {{"format", "scalebreak oblique table"},
            {"format_version", format_version},
            {"arrays", {name + "-entries.npy", name + "-turnings.npy"}},
            {"key", key_json(table.key())},
            {"quality",
             {{"error_max", quality.error_max},
              {"error_rms", quality.error_rms},
              {"turning_error_median", quality.turning_error_median},
              {"samples", quality.samples}}},
            {"sticking_speed_squared", table.sticking_squared()},
            {"half_way_ratio", table.half_way()},
            {"entry_cells", tree_json(table.entries())},
            {"turning_cells", tree_json(table.turnings())}};
  const std::string body = j.dump();
  j["checksum"] = crc32({entries, turnings, body});
  write_file(folder / (name + "-entries.npy"), entries);
  write_file(folder / (name + "-turnings.npy"), turnings);
  write_file(folder / (name + ".json"), j.dump() + "\n");
}

ObliqueTableOnDisk read_oblique_table(const std::filesystem::path& folder, const ObliqueKey& key) {
  const std::string base = (folder / oblique_table_file_name(key)).string();
  const auto text = read_file(base + ".json"), entries = read_file(base + "-entries.npy"), turnings = read_file(base + "-turnings.npy");
  if (!text && !entries && !turnings) return {};
  if (!text || !entries || !turnings) return {{}, "one of its three files is missing"};
  try {
    return {parse(*text, *entries, *turnings, key), ""};
  } catch (const std::string& problem) {
    return {{}, problem};
  } catch (const std::exception& error) {
    return {{}, fmt::format("it cannot be read ({})", error.what())};
  }
}

}  // namespace scalebreak

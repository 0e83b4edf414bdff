#include <scalebreak/table/oblique_table_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/table/npy.hpp>
#include <scalebreak/table/patch_file.hpp>
#include <scalebreak/table/table_seal.hpp>

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

ObliqueTable parse(const std::string& text, const std::string& entries, const std::string& turnings, const ObliqueKey& key) {
  const json j = unsealed(text, {entries, turnings}, format_version, key_json(key));
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
  seal(j, {entries, turnings});
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

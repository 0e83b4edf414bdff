#include <scalebreak/table/rolling_table_file.hpp>

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

json key_json(const RollingKey& key) {
  return {{"contact", to_string(key.kind)},
          {"rolling", to_string(key.model)},
          {"damping_ratio", key.damping_ratio},
          {"limit", key.limit},
          {"stiffness", key.stiffness},
          {"dashpot", key.dashpot},
          {"inertia", key.inertia},
          {"tolerance", key.tolerance}};
}

RollingTable parse(const std::string& text, const std::string& entries, const RollingKey& key) {
  const json j = unsealed(text, {entries}, format_version, key_json(key));
  const json& q = j.at("quality");
  return {key,
          j.at("sticking_speed_squared"),
          j.at("half_way_ratios").get<std::vector<double>>(),
          table_of<1>(j.at("cells"), entries),
          {q.at("error_max"), q.at("error_rms"), q.at("samples")}};
}

}  // namespace

std::string rolling_table_file_name(const RollingKey& key) {
  return fmt::format("rolling-{}-{}-{:08x}", to_string(key.kind.normal), to_string(key.model), crc32({key_json(key).dump()}));
}

void write_rolling_table(const std::filesystem::path& folder, const RollingTable& table) {
  const std::string name = rolling_table_file_name(table.key());
  const std::string entries = array_of(table.entries());
  const RollingQuality& quality = table.quality();
  json j = {{"format", "scalebreak rolling table"},
            {"format_version", format_version},
            {"array", name + ".npy"},
            {"key", key_json(table.key())},
            {"quality", {{"error_max", quality.error_max}, {"error_rms", quality.error_rms}, {"samples", quality.samples}}},
            {"sticking_speed_squared", table.plane().sticking_squared},
            {"half_way_ratios", table.half_way()},
            {"cells", tree_json(table.entries())}};
  seal(j, {entries});
  write_file(folder / (name + ".npy"), entries);
  write_file(folder / (name + ".json"), j.dump() + "\n");
}

RollingTableOnDisk read_rolling_table(const std::filesystem::path& folder, const RollingKey& key) {
  const std::string base = (folder / rolling_table_file_name(key)).string();
  const auto text = read_file(base + ".json"), entries = read_file(base + ".npy");
  if (!text && !entries) return {};
  if (!text || !entries) return {{}, "one of its two files is missing"};
  try {
    return {parse(*text, *entries, key), ""};
  } catch (const std::string& problem) {
    return {{}, problem};
  } catch (const std::exception& error) {
    return {{}, fmt::format("it cannot be read ({})", error.what())};
  }
}

}  // namespace scalebreak

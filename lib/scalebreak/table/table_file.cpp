#include <scalebreak/table/table_file.hpp>

#include <cstring>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/table/npy.hpp>
#include <scalebreak/table/table_seal.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

/// Of the layout *and* of the numbers: raise it when either changes.
constexpr int format_version = 1;

constexpr const char* fields[] = {"damping_ratio", "speed", "sticking_speed", "restitution", "contact_time", "max_overlap"};
static_assert(sizeof(TableNode) == std::size(fields) * sizeof(double));

std::string header_of(const CollisionTable& table) {
  std::vector<std::string> types;
  for (const char* field : fields) types.push_back(fmt::format("('{}', '<f8')", field));
  return npy_header(fmt::format("[{}]", fmt::join(types, ", ")),
                    {static_cast<std::size_t>(table.damping_axis().count), static_cast<std::size_t>(table.speed_axis().count)});
}

std::string npy(const CollisionTable& table) {
  std::string bytes = header_of(table);
  const auto& nodes = table.nodes();
  bytes.append(reinterpret_cast<const char*>(nodes.data()), nodes.size() * sizeof(TableNode));
  return bytes;
}

json axis_json(const Axis& axis) { return {{"first", axis.first}, {"step", axis.step}, {"count", axis.count}}; }
Axis axis_of(const json& j) { return {j.at("first"), j.at("step"), j.at("count")}; }

json key_json(const TableKey& key) {
  return {{"normal", to_string(key.kind.normal)},
          {"adhesion_range", to_string(key.kind.range)},
          {"damping_on", to_string(key.kind.damping_on)},
          {"tolerance", key.tolerance}};
}

/// Throws json exceptions, WorkError and a std::string on anything that does not fit.
TableOnDisk parse(const std::string& text, const std::string& array, const TableKey& key) {
  const json j = unsealed(text, {array}, format_version, key_json(key));
  StickingCurve curve{axis_of(j.at("sticking_speed_squared").at("axis")),
                      j.at("sticking_speed_squared").at("values").get<std::vector<double>>()};
  const Axis damping = axis_of(j.at("damping_axis")), speed = axis_of(j.at("speed_axis"));
  const json& q = j.at("quality");
  const TableQuality quality{q.at("error_max"), q.at("error_rms"), q.at("sticking_speed_error"), q.at("max_overlap_error"),
                             q.at("samples")};
  const std::size_t count = static_cast<std::size_t>(damping.count) * static_cast<std::size_t>(speed.count);
  if (array.size() < count * sizeof(TableNode)) return {{}, "its array is short"};
  std::vector<TableNode> nodes(count);
  std::memcpy(nodes.data(), array.data() + (array.size() - count * sizeof(TableNode)), count * sizeof(TableNode));
  CollisionTable table(key, damping, speed, std::move(nodes), std::move(curve), quality);
  if (array.compare(0, array.size() - count * sizeof(TableNode), header_of(table)) != 0) return {{}, "its array header does not fit"};
  return {std::move(table), ""};
}

}  // namespace

std::string table_file_name(const TableKey& key) {
  const ContactKind kind = canonical(key.kind);
  return fmt::format("{}-{}-{}-{:g}", to_string(kind.normal), to_string(kind.range), to_string(kind.damping_on), key.tolerance);
}

void write_table(const std::filesystem::path& folder, const CollisionTable& table) {
  const std::string name = table_file_name(table.key());
  const std::string array = npy(table);
  const TableQuality& quality = table.quality();
  json j = {{"format", "scalebreak collision table"},
            {"format_version", format_version},
            {"array", name + ".npy"},
            {"key", key_json(table.key())},
            {"quality",
             {{"error_max", quality.error_max},
              {"error_rms", quality.error_rms},
              {"sticking_speed_error", quality.sticking_speed_error},
              {"max_overlap_error", quality.max_overlap_error},
              {"samples", quality.samples}}},
            {"damping_axis", axis_json(table.damping_axis())},
            {"speed_axis", axis_json(table.speed_axis())},
            {"sticking_speed_squared", {{"axis", axis_json(table.sticking().axis)}, {"values", table.sticking().squared}}}};
  seal(j, {array});
  write_file(folder / (name + ".npy"), array);
  write_file(folder / (name + ".json"), j.dump(1) + "\n");
}

TableOnDisk read_table(const std::filesystem::path& folder, const TableKey& key) {
  const TableKey canonical_key{canonical(key.kind), key.tolerance};
  const std::filesystem::path base = folder / table_file_name(canonical_key);
  const auto text = read_file(base.string() + ".json");
  const auto array = read_file(base.string() + ".npy");
  if (!text && !array) return {};
  if (!text || !array) return {{}, "one of its two files is missing"};
  try {
    return parse(*text, *array, canonical_key);
  } catch (const std::string& problem) {
    return {{}, problem};
  } catch (const std::exception& error) {
    return {{}, fmt::format("it cannot be read ({})", error.what())};
  }
}

}  // namespace scalebreak

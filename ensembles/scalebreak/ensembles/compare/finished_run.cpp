#include <scalebreak/ensembles/compare/finished_run.hpp>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/flow_json.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/scene/given.hpp>
#include <scalebreak/scene/toml_reader.hpp>

namespace scalebreak {
namespace {

Given input_of(const FinishedRun& run) {
  const auto text = read_file(run.folder / "input.toml");
  return text ? read_toml(*text, (run.folder / "input.toml").string()) : Given{};
}

std::string value_in(const Given& given, const std::string& key) {
  const Assignment* item = find_given(given, key);
  return item ? to_toml(item->value) : "not given";
}

}  // namespace

FinishedRun read_finished_run(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "result.json";
  const auto text = read_file(path);
  if (!text) {
    const bool begun = std::filesystem::exists(folder / "checkpoint.bin");
    throw InputError(fmt::format("{} holds no finished run: {}; allowed: the --out folder of scalebreak run", folder.string(),
                                 begun ? "it was interrupted, and run --resume goes on with it" : "there is no result.json"));
  }
  FinishedRun run{.folder = folder, .result = nlohmann::json::parse(*text, nullptr, false), .quantities = {}, .profiles = {}};
  if (!run.result.is_object() || !run.result.contains("engine") || !run.result.contains("measured_time"))
    throw InputError(fmt::format("{} is not the result of a flow; allowed: the --out folder of scalebreak run", path.string()));
  try {
    run.quantities = quantities_of(run.result);
  } catch (const WorkError& error) {
    throw InputError(fmt::format("{}: {}; allowed: what scalebreak run wrote", path.string(), error.what()));
  }
  run.profiles = read_file(folder / "profiles.csv").value_or("");
  return run;
}

std::vector<std::string> input_differences(const FinishedRun& first, const FinishedRun& second) {
  const Given a = input_of(first), b = input_of(second);
  std::vector<std::string> differences;
  if (a.empty() || b.empty()) return differences;
  for (const Assignment& item : a) {
    const std::string here = to_toml(item.value), there = value_in(b, item.key);
    if (here != there) differences.push_back(fmt::format("{}: {}, {}", item.key, here, there));
  }
  for (const Assignment& item : b) {
    if (!find_given(a, item.key)) differences.push_back(fmt::format("{}: not given, {}", item.key, to_toml(item.value)));
  }
  return differences;
}

}  // namespace scalebreak

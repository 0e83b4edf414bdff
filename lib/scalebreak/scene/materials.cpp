#include <scalebreak/scene/materials.hpp>

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/toml_reader.hpp>

namespace scalebreak {
namespace fs = std::filesystem;

fs::path data_folder() {
  if (const char* set = std::getenv("SCALEBREAK_DATA"); set && *set) return set;
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  for (const fs::path& folder : {program.parent_path().parent_path() / "share" / "scalebreak", fs::path(SCALEBREAK_SOURCE_DATA)}) {
    if (fs::is_directory(folder / "materials", failed)) return folder;
  }
  return {};
}

std::vector<Assignment> named_material(const std::string& name, const Where& where, const std::string& key) {
  const fs::path folder = data_folder() / "materials";
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InputError(fmt::format("{}: {}: found \"{}\"; allowed: a material of {}: {}", where.text, key, name, folder.string(),
                                 names.empty() ? "none there" : fmt::format("\"{}\"", fmt::join(names, "\", \""))));
  }
  std::vector<Assignment> assignments = read_toml_file(folder / (name + ".toml"));
  for (Assignment& item : assignments) {
    if (item.key.rfind("material.", 0) == 0) item.key.erase(0, std::string_view("material.").size());
  }
  std::erase_if(assignments, [](const Assignment& item) { return item.key == "source" || item.key == "name"; });
  return assignments;
}

}  // namespace scalebreak

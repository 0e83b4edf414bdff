#include <scalebreak/ensembles/breakdown/study_grid.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/ensembles/engine/engine_names.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>
#include <scalebreak/scaling/scaling_law.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/keys.hpp>
#include <scalebreak/scene/toml_reader.hpp>

namespace scalebreak {
namespace {

constexpr const char* fraction_key = "particles.volume_fraction";

/// What a cell is, without what only a study or its files need.
Input scene_of(const Input& study) {
  Input scene = study;
  const Input plain;
  scene.study = plain.study, scene.study_laws = plain.study_laws, scene.study_factors = plain.study_factors;
  scene.study_speeds = plain.study_speeds, scene.study_integrators = plain.study_integrators;
  scene.study_energy_growth = plain.study_energy_growth, scene.study_motion_error = plain.study_motion_error,
  scene.tradeoff = plain.tradeoff;
  scene.advise = plain.advise;
  scene.output = plain.output, scene.output.formats.clear();
  scene.scaling_law = "none", scene.scaling_factor = 1;
  scene.run.replicas = 1;
  return scene;
}

const Key& parameter_key(const std::string& dotted) {
  for (const Key& key : keys()) {
    if (key.dotted() == dotted && std::holds_alternative<double>(key.get(Input{}))) return key;
  }
  throw InputError(
      fmt::format("study.parameter: found \"{}\"; allowed: the dotted key of a number of the scene, as \"cell.shear_rate\"", dotted));
}

void check_study(const Input& input) {
  const StudyInput& study = input.study;
  if (study.parameter.empty() != study.values.empty())
    throw InputError(fmt::format("study.{} is given without study.{}; allowed: both or none",
                                 study.parameter.empty() ? "values" : "parameter", study.parameter.empty() ? "parameter" : "values"));
  if (study.parameter.empty()) return;
  const Key& key = parameter_key(study.parameter);
  for (const char* section : {"study", "scaling", "output", "numerics", "pair", "impact"}) {
    if (key.section == section)
      throw InputError(
          fmt::format("study.parameter: found \"{}\", which is no part of the original scene; allowed: a key of [material], [second], "
                      "[wall], [particles], [cell] or [run]",
                      study.parameter));
  }
  if (study.parameter == fraction_key && !study.volume_fractions.empty())
    throw InputError("study.parameter: particles.volume_fraction is varied by study.volume_fractions already; allowed: one of the two");
}

/// The scene with these keys changed, checked as any other.
Input changed(const Input& scene, std::vector<Assignment> changes, const std::string& name) {
  std::vector<Assignment> given = read_toml(write_input(scene), name);
  std::erase_if(given, [](const Assignment& item) { return item.key.rfind("scaling.", 0) == 0; });
  for (Assignment& change : changes) change.where = {name};
  given.insert(given.end(), changes.begin(), changes.end());
  return resolve_input(given);
}

std::vector<Assignment> changes_of(const Input& scene, const Input& study, const StudyPoint& point) {
  std::vector<Assignment> changes;
  if (point.volume_fraction) changes.push_back({fraction_key, *point.volume_fraction, {}});
  if (!point.value) return changes;
  const Key& key = parameter_key(study.study.parameter);
  changes.push_back({key.dotted(), *point.value, {}});
  if (key.section != "material") return changes;
  for (const std::string section : {"second", "wall"}) {
    const Key& other = parameter_key(section + "." + key.name);
    const bool written = section == "wall" || scene.particles.size == SizeKind::bidisperse;
    if (written && other.get(scene) == key.get(scene)) changes.push_back({other.dotted(), *point.value, {}});
  }
  return changes;
}

std::vector<StudyPoint> points_of(const StudyInput& study) {
  std::vector<std::optional<double>> fractions(study.volume_fractions.begin(), study.volume_fractions.end()),
      values(study.values.begin(), study.values.end());
  if (fractions.empty()) fractions.emplace_back();
  if (values.empty()) values.emplace_back();
  std::vector<StudyPoint> points;
  for (const auto& fraction : fractions) {
    for (const auto& value : values) points.push_back({fraction, value});
  }
  return points;
}

/// Fowler, Noll & Vo's hash of a text, 64 bits: the same on every machine.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// The keys of a cell that say what it is: not those of other commands, which later versions may add to.
std::string identity_of(const Input& cell) {
  std::string text;
  for (const Assignment& item : read_toml(write_input(cell), "cell")) {
    const std::string section = item.key.substr(0, item.key.find('.'));
    if (section == "study" || section == "advise" || section == "output") continue;
    text += item.key + " = " + to_toml(item.value) + "\n";
  }
  return text;
}

}  // namespace

std::string StudyPoint::name(const std::string& parameter) const {
  std::string text;
  if (volume_fraction) text += fmt::format("volume fraction {:g}", *volume_fraction);
  if (value) text += fmt::format("{}{} {:g}", text.empty() ? "" : ", ", parameter, *value);
  return text;
}

std::string StudyCell::folder() const {
  std::string name = fmt::format("{}_{:g}", law, factor);
  if (point.volume_fraction) name += fmt::format("_phi_{:g}", *point.volume_fraction);
  if (point.value) name += fmt::format("_at_{:g}", *point.value);
  return fmt::format("{}_{}_{:016x}", name, choice.engine, key);
}

std::size_t StudyGrid::original_of(std::size_t cell) const {
  const auto at = std::find_if(cells.begin(), cells.end(),
                               [&](const StudyCell& other) { return other.original() && other.point == cells[cell].point; });
  return static_cast<std::size_t>(at - cells.begin());
}

StudyCell study_cell(const Input& study, const StudyPoint& point, const std::string& engine, const std::string& law, double factor,
                     const std::vector<Assignment>& more) {
  const Input scene = scene_of(study);
  std::vector<Assignment> changes = changes_of(scene, study, point);
  const std::string at = changes.empty() ? "" : point.name(study.study.parameter) + ", ";
  changes.push_back({"scaling.law", law, {}});
  changes.push_back({"scaling.factor", factor, {}});
  if (size_factor(*find_scaling_law(law), factor) > 1)
    changes.push_back({"scaling.keep", std::string(keep_words[static_cast<std::size_t>(study.keep)]), {}});
  for (const Assignment& each : more) {
    std::erase_if(changes, [&](const Assignment& other) { return other.key == each.key; });
    changes.push_back(each);
  }
  StudyCell cell{.law = law, .factor = factor, .point = point, .asked = engine, .choice = {}, .input = {}};
  cell.input = changed(scene, changes, fmt::format("study, {}{} at {:g}", at, law, factor));
  cell.choice = choose_engine(engine, cell.input, 1, 0);
  cell.key = hash_of(cell.choice.engine + "\n" + identity_of(cell.input));
  return cell;
}

std::optional<std::string> why_unsuited(const StudyCell& cell) {
  try {
    if (flies(cell.choice.engine)) refuse_laws_without_tables(cell.input);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

StudyGrid study_grid(const Input& input) {
  check_study(input);
  StudyGrid grid;
  for (const StudyPoint& point : points_of(input.study)) {
    for (const std::string& engine : input.study.engines) {
      const auto add = [&](const std::string& law, double factor) {
        StudyCell cell = study_cell(input, point, engine, law, factor);
        if (why_unsuited(cell)) return void(++grid.skipped);
        const bool there = std::any_of(grid.cells.begin(), grid.cells.end(), [&](const StudyCell& other) { return other.key == cell.key; });
        if (!there) grid.cells.push_back(std::move(cell));  // another word for the engine, or "none" at 1
      };
      add("none", 1);
      for (const std::string& name : study_laws(input)) {
        for (const double factor : input.study_factors) {
          refusal(*find_scaling_law(name), factor, input.contact.normal) ? void(++grid.skipped) : add(name, factor);
        }
      }
    }
  }
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
    if (grid.original_of(cell) == grid.cells.size())
      throw InputError("study.engines: none of them runs the original; allowed: one that does, as \"auto\"");
  }
  return grid;
}

}  // namespace scalebreak

#include <scalebreak/scene/input_file.hpp>

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/alternatives.hpp>
#include <scalebreak/scene/check_bodies.hpp>
#include <scalebreak/scene/check_flow.hpp>
#include <scalebreak/scene/check_input.hpp>
#include <scalebreak/scene/keys.hpp>
#include <scalebreak/scene/materials.hpp>

namespace scalebreak {
namespace {

constexpr const char* materials[] = {"material", "second", "wall"};

Material& material_of(const std::string& section, Input& input) {
  return section == "material" ? input.material : section == "second" ? input.second : input.wall.material;
}

std::string section_of(const std::string& key) { return key.substr(0, key.find('.')); }

bool is_material(const std::string& section) {
  return std::find(std::begin(materials), std::end(materials), section) != std::end(materials);
}

/// Of the keys that could have been meant: the one whose name has the most letters of the word in the same order.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  std::size_t best = 0;
  std::string chosen;
  for (const std::string& dotted : candidates) {
    const std::string candidate = dotted.substr(dotted.rfind('.') + 1);
    std::vector<std::size_t> row(candidate.size() + 1, 0);
    for (const char c : word) {
      std::size_t diagonal = 0;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t above = row[j];
        row[j] = c == candidate[j - 1] ? diagonal + 1 : std::max(row[j], row[j - 1]);
        diagonal = above;
      }
    }
    if (row.back() > best && 2 * row.back() >= word.size()) best = row.back(), chosen = dotted;
  }
  return chosen;
}

const Key* find_key(const std::string& dotted) {
  for (const Key& key : keys()) {
    if (key.dotted() == dotted) return &key;
  }
  return nullptr;
}

[[noreturn]] void unknown(const Assignment& given) {
  std::vector<std::string> names, sections;
  const std::string section = section_of(given.key);
  for (const Key& key : keys()) {
    if (key.section == section) names.push_back(key.dotted());
    if (sections.empty() || sections.back() != key.section) sections.push_back(key.section);
  }
  if (is_material(section)) names.push_back(section + ".name");
  if (section == "body") {
    for (const Key& key : body_keys(0)) names.push_back(key.dotted());
  }
  if (names.empty()) {
    throw InputError(
        fmt::format("{}: {}: there is no such section; allowed: {}, body", given.where.text, given.key, fmt::join(sections, ", ")));
  }
  const std::string guess = nearest(given.key.substr(given.key.rfind('.') + 1), names);
  throw InputError(fmt::format("{}: {}: there is no such key{}; allowed: {}", given.where.text, given.key,
                               guess.empty() ? "" : fmt::format(" (did you mean {}?)", guess), fmt::join(names, ", ")));
}

void apply(const Key& key, Input& input, const Assignment& given) {
  try {
    key.set(input, given.value);
  } catch (const std::string& found) {
    throw InputError(fmt::format("{}: {}: {}; allowed: {}", given.where.text, given.key, found, key.allowed));
  }
}

/// "body.2.radius" → 2; 0 for anything else.
std::size_t body_index(const std::string& key) {
  const std::size_t first = key.find('.'), second = key.find('.', first + 1);
  if (key.rfind("body.", 0) != 0 || second == std::string::npos || key.find('.', second + 1) != std::string::npos) return 0;
  const std::string digits = key.substr(first + 1, second - first - 1);
  if (digits.empty() || digits.size() > 4 || digits.front() == '0' || digits.find_first_not_of("0123456789") != std::string::npos) return 0;
  return static_cast<std::size_t>(std::stoul(digits));
}

void apply_body(Input& input, const Assignment& given) {
  const std::size_t index = body_index(given.key);
  const std::string name = given.key.substr(given.key.rfind('.') + 1);
  for (const Key& key : body_keys(index - 1)) {
    if (key.name == name) return apply(key, input, given);
  }
  unknown(given);
}

/// What is given for a material, in one place.
void put(const std::string& section, Input& input, const Given& given) {
  for (const Assignment& item : given) {
    if (item.key.rfind(section + ".", 0) != 0 || item.key == section + ".name") continue;
    const Key* key = find_key(item.key);
    if (!key) unknown(item);
    apply(*key, input, item);
  }
  settle_alternatives(material_of(section, input), section, given);
}

/// A named material first, then what is said beside it.
void apply_material(const std::string& section, Input& input, const Given& given) {
  if (const Assignment* named = find_given(given, section + ".name")) {
    const auto* name = std::get_if<std::string>(&named->value);
    if (!name)
      throw InputError(fmt::format("{}: {}: found {}; allowed: the name of a material, as a string", named->where.text, named->key,
                                   to_toml(named->value)));
    Given properties = named_material(*name, named->where, named->key);
    for (Assignment& property : properties) property.key = section + "." + property.key;
    put(section, input, properties);
    check_alternatives(section, properties);
  }
  put(section, input, given);
}

/// So many bodies, each of the default material.
std::vector<Body> blank_bodies(std::size_t count) {
  std::vector<Body> bodies(count);
  if (count == 2) bodies[1].second = true;  // as in a pair of [pair]
  return bodies;
}

/// A section that says nothing is not written: few inputs are for advice.
bool says_nothing(const Key& key, const Input& input) { return key.section == "advise" && input.advise == AdviseInput{}; }

/// Keys of other scenes, what nothing uses, and those of a material that another one overrules.
bool left_out(const Key& key, const Input& input) {
  if (input.flow && !holds_in_flow(input, key.dotted())) return true;
  if (!input.flow && of_flow_only(key.dotted())) return true;
  if (!input.flow && key.section == "run") return input.bodies.empty();
  if (key.section == "pair" || key.section == "impact") return !input.bodies.empty();
  return is_material(key.section) && overruled(material_of(key.section, const_cast<Input&>(input)), key.name);
}

/// Why the value of a key changes with others.
const char* remark(const std::string& section) {
  if (section == "second" || section == "wall") return "# each defaults to the key of [material]\n";
  if (section == "contact")
    return "# hertz and linear end at \"touch\", are damped on \"overlap\" and have tangential_radius = \"overlap\"\n";
  return "";
}

}  // namespace

Input resolve_input(const std::vector<Assignment>& all) {
  Given given;  // the last word on each key, where it was first named
  for (const Assignment& item : all) {
    const auto same = std::find_if(given.begin(), given.end(), [&](const Assignment& other) { return other.key == item.key; });
    same == given.end() ? given.push_back(item) : void(*same = item);
  }
  std::size_t bodies = 0;
  for (const Assignment& item : given) {
    const bool named = is_material(section_of(item.key)) && item.key == section_of(item.key) + ".name";
    bodies = std::max(bodies, body_index(item.key));
    if (!named && !find_key(item.key) && body_index(item.key) == 0) unknown(item);
  }
  if (bodies > most_bodies) {
    const auto at = std::find_if(given.begin(), given.end(), [](const Assignment& item) { return body_index(item.key) > most_bodies; });
    refuse_number_of_bodies(*at, bodies);
  }
  Input input;
  input.bodies = blank_bodies(bodies);
  // Wrong values first, each in the order of the input, into a copy: what follows may then rely on them.
  for (const Assignment& item : given) {
    Input scratch = input;
    if (body_index(item.key) > 0) {
      apply_body(scratch, item);
    } else if (const Key* key = find_key(item.key)) {
      apply(*key, scratch, item);
    }
  }
  apply_material("material", input, given);
  input.second = input.wall.material = input.material;
  apply_material("second", input, given);
  apply_material("wall", input, given);
  for (const Assignment& item : given) {
    if (is_material(section_of(item.key))) continue;
    body_index(item.key) > 0 ? apply_body(input, item) : apply(*find_key(item.key), input, item);
  }
  complete_and_check(input, given);
  return input;
}

std::string write_input(const Input& input) {
  std::string text, section;
  for (const Key& key : keys()) {
    if (left_out(key, input) || says_nothing(key, input)) continue;
    if (key.section != section) {
      text += fmt::format("{}[{}]\n", section.empty() ? "" : "\n", key.section);
      section = key.section;
    }
    text += fmt::format("{} = {}\n", key.name, to_toml(key.get(input)));
  }
  for (std::size_t i = 0; i < input.bodies.size(); ++i) {
    text += "\n[[body]]\n";
    for (const Key& key : body_keys(i)) text += fmt::format("{} = {}\n", key.name, to_toml(key.get(input)));
  }
  return text;
}

std::string describe_keys() {
  Input defaults;
  std::string text =
                  "# Every key with its default, in SI units. name = \"...\" in [material], [second] or [wall] takes a material of "
                  "data/materials.\n",
              section;
  const auto line = [&](const std::string& start, const Key& key, const std::string& value) {
    text += fmt::format("{:<40} # [{}] {}; allowed: {}\n", fmt::format("{}{} = {}", start, key.name, value), key.unit, key.meaning,
                        key.allowed);
  };
  for (const Key& key : keys()) {
    if (left_out(key, defaults)) continue;
    if (key.section != section) text += fmt::format("\n[{}]\n{}", section = key.section, remark(key.section));
    line("", key, to_toml(key.get(defaults)));
  }
  text +=
      fmt::format("\n# {} to {} [[body]] tables may stand in place of [pair] and [impact], and [run] beside them; {} have no default.\n",
                  fewest_bodies, most_bodies, fmt::join(required_body_keys, " and "));
  const auto commented = [&](const Key& key, const std::string& value) {
    if (key.section != section) text += key.section == "body" ? "# [[body]]\n" : fmt::format("# [{}]\n", key.section);
    section = key.section;
    line("# ", key, value);
  };
  defaults.bodies.resize(1);
  for (const Key& key : body_keys(0)) {
    const bool required = std::count(std::begin(required_body_keys), std::end(required_body_keys), key.name) > 0;
    commented(key, required ? "" : to_toml(key.get(defaults)));
  }
  commented(*find_key("run.duration"), to_toml(find_key("run.duration")->get(defaults)));
  text +=
      "\n# [particles] or [cell] in place of [pair] and [impact] make a flow, with [run], [output] and scaling.keep beside them. couette has\n"
      "# walls along z and wall_speed = 0.3, box walls all around; where nothing is sheared duration = 0.1 and there is no strain; in a cell\n"
      "# with walls keep = \"cell\". These are the defaults of kind = \"shear\":\n";
  section.clear();
  const Input flow = resolve_input({{"cell.kind", std::string("shear"), {"the defaults"}}});
  for (const Key& key : keys()) {
    if (of_flow_only(key.dotted()) || key.section == "run") commented(key, to_toml(key.get(flow)));
  }
  return text;
}

}  // namespace scalebreak

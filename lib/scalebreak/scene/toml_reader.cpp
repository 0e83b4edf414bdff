#include <scalebreak/scene/toml_reader.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

Where where_of(const toml::node& node, const std::string& name) { return {fmt::format("{}, line {}", name, node.source().begin.line)}; }

/// A number from TOML's integer or float.
std::optional<double> number_of(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  if (const auto* real = node.as_floating_point()) return real->get();
  return std::nullopt;
}

Value array_of(const toml::array& array, const std::string& key, const Where& where) {
  std::vector<double> numbers;
  std::vector<std::string> words;
  for (const toml::node& item : array) {
    if (const auto number = number_of(item)) {
      numbers.push_back(*number);
    } else if (const auto* word = item.as_string()) {
      words.push_back(word->get());
    } else {
      throw InputError(fmt::format("{}: {}: an array holds numbers or strings, found neither", where.text, key));
    }
  }
  if (!numbers.empty() && !words.empty())
    throw InputError(fmt::format("{}: {}: an array holds numbers or strings, found both", where.text, key));
  if (!words.empty()) return words;
  return numbers;
}

Value value_of(const toml::node& node, const std::string& key, const Where& where) {
  if (const auto number = number_of(node)) return *number;
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* word = node.as_string()) return word->get();
  if (const auto* array = node.as_array()) return array_of(*array, key, where);
  throw InputError(fmt::format("{}: {}: found a date or time; allowed: a number, true or false, a string, an array", where.text, key));
}

/// Every part of a dotted key is a level of tables, and the parser's stack bears only so many. Two full studies have fewer dots.
constexpr int most_dots = 3000;

/// Throws if the text could nest deeper, wherever its dots stand.
void check_depth(std::string_view text, const std::string& name) {
  int line = 1, dots = 0;
  for (const char c : text) {
    line += c == '\n';
    dots += c == '.';
    if (dots > most_dots)
      throw InputError(fmt::format("{}, line {}: found more than {} dots; allowed: fewer, an input needs no deeper keys nor more numbers",
                                   name, line, most_dots));
  }
}

using Placed = std::pair<toml::source_position, Assignment>;

void flatten(const toml::table& table, const std::string& prefix, const std::string& name, std::vector<Placed>& out) {
  for (const auto& [key_name, node] : table) {
    const std::string key = prefix.empty() ? std::string(key_name.str()) : fmt::format("{}.{}", prefix, key_name.str());
    if (const auto* inner = node.as_table()) {
      flatten(*inner, key, name, out);
    } else if (const auto* array = node.as_array(); array && !array->empty() && array->is_homogeneous(toml::node_type::table)) {
      int index = 0;
      for (const toml::node& item : *array) {
        const std::string numbered = fmt::format("{}.{}", key, ++index);
        if (item.as_table()->empty()) out.push_back({item.source().begin, {numbered, true, where_of(item, name)}});  // not passed over
        flatten(*item.as_table(), numbered, name, out);
      }
    } else {
      const Where where = where_of(node, name);
      out.push_back({node.source().begin, {key, value_of(node, key, where), where}});
    }
  }
}

}  // namespace

std::vector<Assignment> read_toml(std::string_view text, const std::string& name) {
  check_depth(text, name);
  std::vector<Placed> placed;
  try {
    const toml::table table = toml::parse(text);
    flatten(table, "", name, placed);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}, line {}: this is not TOML: {}", name, error.source().begin.line, error.description()));
  }
  std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.first < b.first; });
  std::vector<Assignment> assignments;
  for (Placed& item : placed) assignments.push_back(std::move(item.second));
  return assignments;
}

std::vector<Assignment> read_toml_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(fmt::format("{}: there is no such file, or it cannot be read", path.string()));
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return read_toml(text, path.string());
}

Assignment read_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError(fmt::format("--set {}: allowed: dotted.key=value, like contact.normal=hertz", text));
  }
  const std::string key = text.substr(0, equals), value = text.substr(equals + 1);
  const Where where{fmt::format("--set {}", text)};
  check_depth(value, "--set " + key);
  try {
    const toml::table table = toml::parse("value = " + value);
    const toml::node* node = table.get("value");
    if (table.size() == 1 && !node->is_table()) return {key, value_of(*node, key, where), where};
  } catch (const toml::parse_error&) {
  }
  const bool word = !value.empty() && std::all_of(value.begin(), value.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '+' || c == '-' || c == '.' || c == '/';
  });
  if (!word)
    throw InputError(fmt::format("{}: found {}; allowed: a number, a bare word, \"a string\", [an, array], true or false", where.text,
                                 value.empty() ? "nothing" : value));
  return {key, value, where};
}

}  // namespace scalebreak

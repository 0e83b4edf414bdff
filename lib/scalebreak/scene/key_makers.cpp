#include <scalebreak/scene/key_makers.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scalebreak {
namespace {

void check(const Bounds& bounds, const std::vector<double>& numbers, const Value& value) {
  for (const double number : numbers) {
    if (!std::isfinite(number) || !bounds.contain(number)) throw found(value);
  }
}

}  // namespace

std::string found(const Value& value) { return "found " + to_toml(value); }

Key number(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning,
           Member<double> member) {
  const Bounds bounds = bounds_of(section + "." + name);
  return {section,
          name,
          unit,
          meaning,
          "a number " + bounds.text(),
          [=](Input& input, const Value& value) {
            const double given = expect<double>(value);
            check(bounds, {given}, value);
            member(input) = given;
          },
          [=](const Input& input) { return Value(member(const_cast<Input&>(input))); }};
}

Key numbers(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning, std::size_t least,
            std::size_t most, Member<std::vector<double>> member) {
  const Bounds bounds = bounds_of(section + "." + name);
  const std::string how_many = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
  return {section,
          name,
          unit,
          meaning,
          fmt::format("an array of {} numbers {}", how_many, bounds.text()),
          [=](Input& input, const Value& value) {
            const auto& given = expect<std::vector<double>>(value);
            if (given.size() < least || given.size() > most) throw found(value);
            check(bounds, given, value);
            member(input) = given;
          },
          [=](const Input& input) { return Value(member(const_cast<Input&>(input))); }};
}

Key vector3(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning,
            Member<Eigen::Vector3d> member) {
  const Bounds bounds = bounds_of(section + "." + name);
  return {section,
          name,
          unit,
          meaning,
          fmt::format("an array of 3 numbers {}", bounds.text()),
          [=](Input& input, const Value& value) {
            const auto& given = expect<std::vector<double>>(value);
            if (given.size() != 3) throw found(value);
            check(bounds, given, value);
            member(input) = Eigen::Vector3d(given[0], given[1], given[2]);
          },
          [=](const Input& input) {
            const Eigen::Vector3d& v = member(const_cast<Input&>(input));
            return Value(std::vector<double>{v[0], v[1], v[2]});
          }};
}

Key whole_number(const std::string& section, const std::string& name, const std::string& meaning, Member<std::uint64_t> member) {
  const Bounds bounds = bounds_of(section + "." + name);
  return {section,
          name,
          "-",
          meaning,
          "a whole number " + bounds.text(),
          [=](Input& input, const Value& value) {
            const double given = expect<double>(value);
            check(bounds, {given}, value);
            if (given != std::floor(given)) throw found(value);
            member(input) = static_cast<std::uint64_t>(given);
          },
          [=](const Input& input) { return Value(static_cast<double>(member(const_cast<Input&>(input)))); }};
}

Key flag(const std::string& section, const std::string& name, const std::string& meaning, Member<bool> member) {
  return {section,
          name,
          "-",
          meaning,
          "true or false",
          [=](Input& input, const Value& value) { member(input) = expect<bool>(value); },
          [=](const Input& input) { return Value(member(const_cast<Input&>(input))); }};
}

Key choice(const std::string& section, const std::string& name, const std::string& meaning, std::vector<std::string> words,
           std::function<void(Input&, std::size_t)> put, std::function<std::size_t(const Input&)> take) {
  return {section,
          name,
          "-",
          meaning,
          fmt::format("\"{}\"", fmt::join(words, "\", \"")),
          [=](Input& input, const Value& value) {
            const auto at = std::find(words.begin(), words.end(), expect<std::string>(value));
            if (at == words.end()) throw found(value);
            put(input, static_cast<std::size_t>(at - words.begin()));
          },
          [=](const Input& input) { return Value(words[take(input)]); }};
}

Key choices(const std::string& section, const std::string& name, const std::string& meaning, std::vector<std::string> words,
            std::size_t least, std::size_t most, std::function<void(Input&, const std::vector<std::size_t>&)> put,
            std::function<std::vector<std::size_t>(const Input&)> take) {
  return {section,
          name,
          "-",
          meaning,
          fmt::format("an array of {}\"{}\"", least == most ? fmt::format("{} of ", least) : "", fmt::join(words, "\", \"")),
          [=](Input& input, const Value& value) {
            const auto* none = std::get_if<std::vector<double>>(&value);  // how an empty array is read
            const auto given = none && none->empty() ? std::vector<std::string>{} : expect<std::vector<std::string>>(value);
            if (given.size() < least || given.size() > most) throw found(value);
            std::vector<std::size_t> indices;
            for (const std::string& word : given) {
              const auto at = std::find(words.begin(), words.end(), word);
              if (at == words.end()) throw found(value);
              indices.push_back(static_cast<std::size_t>(at - words.begin()));
            }
            put(input, indices);
          },
          [=](const Input& input) {
            std::vector<std::string> taken;
            for (const std::size_t index : take(input)) taken.push_back(words[index]);
            return Value(taken);
          }};
}

}  // namespace scalebreak

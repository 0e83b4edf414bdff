#pragma once

#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <scalebreak/scene/keys.hpp>

namespace scalebreak {

/// A reference to a member of an Input, given one: lets a key be written once for reading and writing.
template <class T>
using Member = std::function<T&(Input&)>;

/// "found 0.5": what a key throws for a value that it does not take.
[[nodiscard]] std::string found(const Value& value);

/// The value as what a key expects; throws what was found if it is of another kind.
template <class T>
const T& expect(const Value& value) {
  if (const T* held = std::get_if<T>(&value)) return *held;
  throw found(value);
}

/// The words of an enumeration.
template <std::size_t count>
[[nodiscard]] std::vector<std::string> words_of(const char* const (&words)[count]) {
  return {std::begin(words), std::end(words)};
}

/// A number, or an array of `least` to `most` numbers or of three coordinates, within the bounds of the key.
[[nodiscard]] Key number(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning,
                         Member<double> member);
[[nodiscard]] Key numbers(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning,
                          std::size_t least, std::size_t most, Member<std::vector<double>> member);
[[nodiscard]] Key vector3(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning,
                          Member<Eigen::Vector3d> member);

/// A number without a fraction.
[[nodiscard]] Key whole_number(const std::string& section, const std::string& name, const std::string& meaning,
                               Member<std::uint64_t> member);

/// true or false.
[[nodiscard]] Key flag(const std::string& section, const std::string& name, const std::string& meaning, Member<bool> member);

/// A word out of a list; `put` takes its index, `take` gives it.
[[nodiscard]] Key choice(const std::string& section, const std::string& name, const std::string& meaning, std::vector<std::string> words,
                         std::function<void(Input&, std::size_t)> put, std::function<std::size_t(const Input&)> take);

/// An array of `least` to `most` words out of a list; `put` takes their indices, `take` gives them.
[[nodiscard]] Key choices(const std::string& section, const std::string& name, const std::string& meaning, std::vector<std::string> words,
                          std::size_t least, std::size_t most, std::function<void(Input&, const std::vector<std::size_t>&)> put,
                          std::function<std::vector<std::size_t>(const Input&)> take);

/// The same as `choice` for an enumerator of a part of the input, in the order of its enumeration.
template <class Part, class Enum>
Key choice_of(const std::string& section, const std::string& name, const std::string& meaning, std::vector<std::string> words,
              Part Input::*part, Enum Part::*member) {
  return choice(
      section, name, meaning, std::move(words), [=](Input& input, std::size_t i) { input.*part.*member = static_cast<Enum>(i); },
      [=](const Input& input) { return static_cast<std::size_t>(input.*part.*member); });
}

}  // namespace scalebreak

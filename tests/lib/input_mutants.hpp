#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <lib/surroundings.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/keys.hpp>

// Inputs, and what may happen to their text.

namespace scalebreak::tests {

using Random = std::mt19937_64;

inline std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

template <class List>
const auto& any_of(Random& random, const List& list) {
  return list[below(random, std::size(list))];
}

inline constexpr const char* two_bodies = R"([contact]
normal = "hertz"
[scaling]
law = "sup"
factor = 2
[[body]]
position = [0, 0, 0.01]
velocity = [0, 0, -0.5]
radius = 1e-3
[[body]]
position = [0, 0, 0]
velocity = [0, 0, 0.25]
radius = 2e-3
)";

inline constexpr const char* three_bodies = R"([contact]
tangential = "mindlin"
rolling = "ar"
[run]
duration = 0.5
[[body]]
position = [0, 0, 0.01]
velocity = [0, 0.1, -0.5]
spin = [1, 2, 3]
radius = 1e-3
material = "second"
[[body]]
position = [0, 0, 0]
radius = 2e-3
fixed = true
[[body]]
position = [0, 0.002, 0.0204]
radius = 2e-3
fixed = false
)";

inline constexpr const char* wet_pair = R"([contact]
tangential = "linear"
torque_arm = "contact"
rolling = "epsd"
attraction = "capillary+viscous"
attraction_range = "bridge"
[material]
liquid_fraction = 0.01
separation_min = 1e-7
contact_angle = 0.3
[second]
liquid_volume = 1e-12
separation_min_ratio = 0.001
[impact]
tangential_speed = 0.2
spin1 = [1, 2, 3]
spin2 = [-1e3, 0, 0.1]
)";

inline constexpr const char* sheared_flow = R"([particles]
count = 500
volume_fraction = 0.2
size = "gaussian"
size_spread = 0.1
[cell]
kind = "shear"
shear_rate = 40
[scaling]
law = "sup"
factor = 2
keep = "cell"
[run]
strain = 3
seed = 4
[output]
formats = ["csv", "vtp", "xyz", "dump"]
)";

inline constexpr const char* walled_flow = R"([particles]
radius = 0.5e-3
size = "bidisperse"
large_radius = 1e-3
large_mass_fraction = 0.5
speed = 0.2
[second]
density = 3000
[cell]
kind = "couette"
size = [0.02, 0.01, 0.02]
boundary = ["periodic", "periodic", "wall"]
wall_speed = 0.5
wall_no_slip = true
gravity = [0, 0, -9.81]
[run]
duration = 0.5
warmup_strain = 1
step_fraction = 0.2
integrator = "synchronized"
[output]
interval = 0.01
fields = ["radius", "spin"]
)";

inline constexpr const char* cooling_flow = R"([cell]
kind = "cooling"
[particles]
count = 300
speed = 0.3
[contact]
rolling = "sds"
)";

inline std::vector<std::string> seed_texts() {
  std::vector<std::string> texts = {write_input(Input{}), two_bodies,   three_bodies, wet_pair,
                                    describe_keys(),      sheared_flow, walled_flow,  cooling_flow};
  for (const char* folder : {"scenes", "materials"}) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(SCALEBREAK_SOURCE) / "data" / folder))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) {
      texts.push_back(tests::content_of(file));
      // A material's source is no key of an input: with it, every mutant of that file would fail alike.
      if (const std::size_t source = texts.back().find("source = "); source != std::string::npos) texts.back().insert(source, "# ");
    }
  }
  return texts;
}

struct Span {
  std::size_t begin, end;
};

/// Where the values of "key = value" lines stand in a text.
inline std::vector<Span> values_of(const std::string& text) {
  std::vector<Span> spans;
  for (std::size_t at = text.find(" = "); at != std::string::npos; at = text.find(" = ", at + 3)) {
    const std::size_t end = text.find_first_of("#\n", at + 3);
    spans.push_back({at + 3, end == std::string::npos ? text.size() : end});
  }
  return spans;
}

inline std::string repeated(const std::string& part, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += part;
  return all;
}

inline std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words = {""};
  for (const char c : text) c == '|' ? words.emplace_back() : words.back().append(1, c);
  return words;
}

/// A value of any kind: odd numbers, words, arrays, deep brackets, things that are no value.
inline std::string odd_value(Random& random) {
  static const std::vector<std::string> odd = words_of(
      "nan|inf|-inf|-0.0|0|1|1.0000000000000002|-1|1e308|1e999|-1e-320|4.9e-324|99999999999999999999999|0x1f|1_000|1e-9|1e-13|0.5|2|1e3|"
      "1e14|100|0.1|true|false|\"\"|\"rps\"|\"wall\"|\"hertz\"|\"linear\"|\"none\"|\"mindlin\"|\"ar\"|\"viscous\"|\"bridge\"|\"second\"|"
      "\"glass\"|\"latex\"|\"shear\"|\"couette\"|\"box\"|\"gaussian\"|\"lognormal\"|\"cell\"|0.3|[0.01, 0.02, 0.02]|[\"wall\", \"open\", \"periodic\"]|[\"csv\"]|\"\\u0000\"|'''x'''|1979-05-27|"
      "07:32:00|[]|[[]]|[1e-3]|[1e-3, 2e-3]|[0, 0, 1]|[nan, 1]|[1, \"a\"]|[true]|[\"rps\", \"sup\"]|{}|{a = 1}|velvet||=|\"open|[1, 2|"
      "\xff\xfe|\"\xc3\x28\"");
  const std::size_t depth = 1 + below(random, 600);
  switch (below(random, 12)) {
    case 0: return fmt::format("{}", std::ldexp(static_cast<double>(random()), static_cast<int>(below(random, 200)) - 160));
    case 1: return fmt::format("{}", std::ldexp(1.0, static_cast<int>(below(random, 2100)) - 1050));
    case 2: return repeated("[", depth) + "1" + repeated("]", depth);
    case 3: return repeated("{a=", depth) + "1" + repeated("}", depth);
    default: return any_of(random, odd);
  }
}

inline void flip_bytes(std::string& text, Random& random) {
  for (std::size_t i = 0; i <= below(random, 4) && !text.empty(); ++i) text[below(random, text.size())] = static_cast<char>(random());
}

inline void delete_part(std::string& text, Random& random) { text.erase(below(random, text.size() + 1), 1 + below(random, 60)); }

inline void duplicate_part(std::string& text, Random& random) {
  const std::string part = text.substr(below(random, text.size() + 1), 1 + below(random, 200));
  text.insert(below(random, text.size() + 1), repeated(part, 1 + below(random, 3)));
}

inline void splice(std::string& text, Random& random, const std::vector<std::string>& seeds) {
  const std::string& other = any_of(random, seeds);
  text = text.substr(0, below(random, text.size() + 1)) + other.substr(below(random, other.size() + 1));
}

inline void swap_values(std::string& text, Random& random) {
  const auto spans = values_of(text);
  if (spans.size() < 2) return;
  const std::size_t i = below(random, spans.size() - 1), j = i + 1 + below(random, spans.size() - 1 - i);
  const std::string first = text.substr(spans[i].begin, spans[i].end - spans[i].begin),
                    second = text.substr(spans[j].begin, spans[j].end - spans[j].begin);
  text.replace(spans[j].begin, second.size(), first);  // the later one first, so that the earlier one stays in place
  text.replace(spans[i].begin, first.size(), second);
}

inline void replace_value(std::string& text, Random& random) {
  const auto spans = values_of(text);
  if (spans.empty()) return;
  const Span span = any_of(random, spans);
  text.replace(span.begin, span.end - span.begin, odd_value(random));
}

/// A number times something, so that some mutants are another sound input.
inline void rescale_number(std::string& text, Random& random) {
  const auto spans = values_of(text);
  if (spans.empty()) return;
  const Span span = any_of(random, spans);
  const std::string old = text.substr(span.begin, span.end - span.begin);
  char* end = nullptr;
  const double number = std::strtod(old.c_str(), &end);
  if (end == old.c_str()) return;
  text.replace(span.begin, static_cast<std::size_t>(end - old.c_str()),
               fmt::format("{}", number * std::pow(10.0, static_cast<double>(below(random, 8001)) / 1000 - 4)));
}

/// The lines, one of them gone, doubled or elsewhere.
inline void move_line(std::string& text, Random& random) {
  const std::size_t begin = text.find('\n', below(random, text.size() + 1));
  if (begin == std::string::npos) return;
  const std::string line = text.substr(begin, text.find('\n', begin + 1) - begin);
  const std::size_t what = below(random, 3);
  if (what != 0) text.erase(begin, line.size());
  if (what != 1) text.insert(std::min(text.size(), text.find('\n', below(random, text.size() + 1))), line);
}

inline void insert_odd(std::string& text, Random& random) {
  constexpr const char* odd[] = {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xef\xbb\xbf", "[[body]]\n", "\n[body]\n", "\n[",
                                 "]",    "\"",       "\"\"\"",       "\n= 1\n",          "\r",           "\x7f",       "#",          ".",
                                 "\\"};
  const std::size_t depth = 1 + below(random, 400);
  const std::string part = below(random, 6) == 0   ? "\n" + repeated("a.", depth) + "a = 1\n"
                           : below(random, 6) == 0 ? std::string(1, '\0')
                                                   : std::string(any_of(random, odd));
  text.insert(below(random, text.size() + 1), part);
}

inline std::string mutant(std::string text, Random& random, const std::vector<std::string>& seeds) {
  const std::size_t changes = 1 + below(random, 4);
  for (std::size_t i = 0; i < changes; ++i) {
    switch (below(random, 20)) {
      case 0: flip_bytes(text, random); break;
      case 1: delete_part(text, random); break;
      case 2: duplicate_part(text, random); break;
      case 3: splice(text, random, seeds); break;
      case 4:
      case 5: swap_values(text, random); break;
      case 6: insert_odd(text, random); break;
      case 7:
      case 8:
      case 9: move_line(text, random); break;
      case 10:
      case 11:
      case 12:
      case 13:
      case 14: rescale_number(text, random); break;
      default: replace_value(text, random);
    }
  }
  return text;
}

/// Settings that each put one odd value on a key that exists.
inline std::vector<std::string> odd_settings(Random& random) {
  std::vector<std::string> settings;
  for (std::size_t count = below(random, 4); count > 0; --count)
    settings.push_back(any_of(random, keys()).dotted() + "=" + odd_value(random));
  return settings;
}

}  // namespace scalebreak::tests

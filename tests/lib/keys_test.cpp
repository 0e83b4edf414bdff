#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/keys.hpp>

namespace scalebreak {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The only key that takes any string.
bool is_free_text(const Key& key) { return key.dotted() == "particles.file" || key.dotted() == "study.parameter"; }

bool is_whole(const Key& key) { return key.allowed.rfind("a whole number", 0) == 0; }

bool is_numeric(const Value& value) { return std::holds_alternative<double>(value) || std::holds_alternative<std::vector<double>>(value); }

std::vector<double> numbers_in(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return {*number};
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return *numbers;
  return {};
}

/// A value of the same kind and length that holds this number everywhere.
Value filled(const Value& like, double number) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&like)) {
    return std::vector<double>(std::max<std::size_t>(numbers->size(), 1), number);
  }
  return number;
}

/// The words in quotes of what is allowed.
std::vector<std::string> words_of(const Key& key) {
  std::vector<std::string> words;
  for (std::size_t at = key.allowed.find('"'); at != std::string::npos; at = key.allowed.find('"', at + 1)) {
    const std::size_t end = key.allowed.find('"', at + 1);
    words.push_back(key.allowed.substr(at + 1, end - at - 1));
    at = end;
  }
  return words;
}

/// What was found, if the key refuses the value and leaves the input alone; otherwise why that is not so.
std::string refused(const Key& key, const Value& value) {
  Input input;
  input.bodies.resize(2);
  const Input before = input;
  try {
    key.set(input, value);
  } catch (const std::string& found) {
    return input == before ? found : "(refused, but the input was changed)";
  }
  return "(it was taken)";
}

/// All keys, those of the second [[body]] with them, and an input that has a place for each.
std::vector<Key> keys_and_body_keys() {
  std::vector<Key> all = keys();
  for (const Key& key : body_keys(1)) all.push_back(key);
  return all;
}

Input with_bodies() {
  Input input;
  input.bodies = {Body{.radius = 1e-3}, Body{.radius = 1e-3}};
  return input;
}

TEST(Keys, AreNamedOnceWithUnitMeaningAndWhatIsAllowed) {
  std::set<std::string> seen;
  for (const Key& key : keys_and_body_keys()) {
    EXPECT_TRUE(seen.insert(key.dotted()).second) << key.dotted();
    EXPECT_FALSE(key.unit.empty() || key.meaning.empty() || key.allowed.empty()) << key.dotted();
    EXPECT_EQ(key.meaning.find('\n'), std::string::npos) << key.dotted();
  }
}

TEST(Keys, EveryDefaultLiesInItsBounds) {
  for (const Key& key : keys_and_body_keys()) {
    for (const double number : numbers_in(key.get(with_bodies()))) {
      EXPECT_TRUE(bounds_of(key.dotted()).contain(number)) << key.dotted() << " = " << number;
    }
  }
}

TEST(Keys, SettingWhatWasReadChangesNothing) {
  for (const Key& key : keys_and_body_keys()) {
    Input input = with_bodies();
    key.set(input, key.get(input));
    EXPECT_TRUE(input == with_bodies()) << key.dotted();
  }
}

TEST(Keys, EachNumberHasAPlaceOfItsOwn) {
  Input input = with_bodies();
  std::vector<std::pair<Key, Value>> put;
  for (const Key& key : keys_and_body_keys()) {
    const Value old = key.get(input);
    if (!is_numeric(old)) continue;
    const Bounds bounds = bounds_of(key.dotted());
    const double share = (1.0 + static_cast<double>(put.size())) / 200;
    const double number = bounds.low + share * (bounds.high - bounds.low);
    put.emplace_back(key, filled(old, is_whole(key) ? std::floor(number) : number));
    key.set(input, put.back().second);
  }
  EXPECT_GT(put.size(), 90u);
  for (const auto& [key, value] : put) EXPECT_EQ(key.get(input), value) << key.dotted();
}

TEST(Keys, EveryAllowedWordIsTakenAndGivenBackAndNoOther) {
  int choices = 0;
  for (const Key& key : keys_and_body_keys()) {
    if (!std::holds_alternative<std::string>(key.get(with_bodies())) || is_free_text(key)) continue;
    ++choices;
    EXPECT_FALSE(words_of(key).empty()) << key.dotted();
    for (const std::string& word : words_of(key)) {
      Input input = with_bodies();
      key.set(input, word);
      EXPECT_EQ(key.get(input), Value(word)) << key.dotted();
    }
    EXPECT_EQ(refused(key, std::string("velvet")), "found \"velvet\"") << key.dotted();
    EXPECT_EQ(refused(key, std::string("")), "found \"\"") << key.dotted();
    EXPECT_EQ(refused(key, 1.0), "found 1") << key.dotted();
  }
  EXPECT_GE(choices, 16);
}

TEST(Keys, BoundsAreTheEdgeOfWhatIsTaken) {
  for (const Key& key : keys_and_body_keys()) {
    const Value like = key.get(with_bodies());
    if (!is_numeric(like)) continue;
    const Bounds bounds = bounds_of(key.dotted());
    Input input = with_bodies();
    EXPECT_NO_THROW(key.set(input, filled(like, bounds.high))) << key.dotted();
    if (bounds.low_allowed) {
      EXPECT_NO_THROW(key.set(input, filled(like, bounds.low))) << key.dotted();
    }
    std::vector<double> outside = {std::nextafter(bounds.low, -infinity), std::nextafter(bounds.high, infinity), NAN, infinity, -infinity};
    if (!bounds.low_allowed) outside.push_back(bounds.low);
    for (const double number : outside) {
      const Value value = filled(like, number);
      EXPECT_EQ(refused(key, value), "found " + to_toml(value)) << key.dotted();
    }
  }
}

TEST(Keys, OneWrongNumberInAnArrayIsEnough) {
  for (const Key& key : keys()) {
    if (key.dotted() != "study.factors" && key.dotted() != "pair.radius") continue;
    EXPECT_EQ(refused(key, std::vector<double>{1, -1}), "found [1, -1]") << key.dotted();
  }
}

TEST(Keys, RefuseAnotherKindOfValue) {
  for (const Key& key : keys_and_body_keys()) {
    const Value own = key.get(with_bodies());
    if (!std::holds_alternative<double>(own)) {
      EXPECT_EQ(refused(key, 0.5), "found 0.5") << key.dotted();
    }
    if (!std::holds_alternative<bool>(own)) {
      EXPECT_EQ(refused(key, true), "found true") << key.dotted();
    }
    if (!std::holds_alternative<std::string>(own) && !is_free_text(key)) {
      EXPECT_EQ(refused(key, std::string("0.5")), "found \"0.5\"") << key.dotted();
    }
    if (is_numeric(own)) {
      EXPECT_EQ(refused(key, std::vector<std::string>{"a"}), "found [\"a\"]") << key.dotted();
    }
  }
}

TEST(Keys, TheWordsOfTheSurfaceLawsAreTheirNames) {
  const auto named = [](const std::string& dotted, const std::string& word) {
    Input input;
    for (const Key& key : keys()) {
      if (key.dotted() == dotted) key.set(input, word);
    }
    const SurfaceKind& kind = input.surface;
    if (dotted == "contact.tangential") return to_string(kind.tangential);
    if (dotted == "contact.tangential_radius") return to_string(kind.tangential_radius);
    if (dotted == "contact.torque_arm") return to_string(kind.torque_arm);
    if (dotted == "contact.rolling") return to_string(kind.rolling);
    return dotted == "contact.attraction" ? to_string(kind.attraction) : to_string(kind.attraction_range);
  };
  for (const char* name : {"tangential", "tangential_radius", "torque_arm", "rolling", "attraction", "attraction_range"}) {
    const std::string dotted = std::string("contact.") + name;
    for (const Key& key : keys()) {
      if (key.dotted() != dotted) continue;
      for (const std::string& word : words_of(key)) EXPECT_EQ(named(dotted, word), word) << dotted;
    }
  }
}

TEST(Keys, ArraysHaveLengths) {
  const auto key = [](const std::string& dotted) {
    for (const Key& item : keys_and_body_keys()) {
      if (item.dotted() == dotted) return item;
    }
    throw WorkError("no key " + dotted);
  };
  const auto length_taken = [&](const std::string& dotted, std::size_t length) {
    Input input = with_bodies();
    try {
      key(dotted).set(input, std::vector<double>(length, 1.0));
      return true;
    } catch (const std::string&) {
      return false;
    }
  };
  const std::vector<std::tuple<std::string, std::size_t, std::size_t>> lengths = {
      {"pair.radius", 1, 2}, {"study.factors", 1, 1000}, {"study.speeds", 0, 1000}, {"body.position", 3, 3}, {"body.velocity", 3, 3},
      {"body.spin", 3, 3},   {"impact.spin1", 3, 3},     {"impact.spin2", 3, 3},    {"cell.size", 3, 3},     {"cell.gravity", 3, 3}};
  for (const auto& [dotted, least, most] : lengths) {
    EXPECT_TRUE(length_taken(dotted, least)) << dotted;
    EXPECT_TRUE(length_taken(dotted, most)) << dotted;
    EXPECT_FALSE(length_taken(dotted, most + 1)) << dotted;
    if (least > 0) {
      EXPECT_FALSE(length_taken(dotted, least - 1)) << dotted;
    }
  }
}

TEST(Keys, StudyLawsTakeAnyNumberOfLawsAndNothingElse) {
  for (const Key& key : keys()) {
    if (key.dotted() != "study.laws") continue;
    Input input;
    key.set(input, std::vector<std::string>{"rps", "sup"});
    EXPECT_THAT(input.study_laws, testing::ElementsAre("rps", "sup"));
    key.set(input, std::vector<double>{});  // how an empty array is read
    EXPECT_TRUE(input.study_laws.empty());
    EXPECT_EQ(refused(key, std::vector<std::string>{"rps", "velvet"}), "found [\"rps\", \"velvet\"]");
    EXPECT_EQ(refused(key, std::vector<double>{1}), "found [1]");
    EXPECT_EQ(refused(key, std::string("rps")), "found \"rps\"");
  }
}

TEST(Keys, WholeNumbersHaveNoFraction) {
  int whole = 0;
  for (const Key& key : keys()) {
    if (!is_whole(key)) continue;
    ++whole;
    EXPECT_EQ(refused(key, 2.5), "found 2.5") << key.dotted();
    Input input;
    key.set(input, 3.0);
    EXPECT_EQ(key.get(input), Value(3.0)) << key.dotted();
  }
  EXPECT_EQ(whole, 5);
}

TEST(Keys, ArraysOfWordsTakeTheirWordsAndNoOther) {
  int lists = 0;
  for (const Key& key : keys()) {
    Input input;
    if (!std::holds_alternative<std::vector<std::string>>(key.get(input))) continue;
    ++lists;
    const auto words = words_of(key);
    const std::size_t length = key.dotted() == "cell.boundary" ? 3 : 2;
    std::vector<std::string> some(words.rbegin(), words.rbegin() + static_cast<std::ptrdiff_t>(length));
    key.set(input, some);
    EXPECT_EQ(key.get(input), Value(some)) << key.dotted();
    some[1] = "velvet";
    EXPECT_EQ(refused(key, some), "found " + to_toml(Value(some))) << key.dotted();
    EXPECT_EQ(refused(key, words.front()), "found \"" + words.front() + "\"") << key.dotted();
  }
  EXPECT_EQ(lists, 7);
}

TEST(Keys, ThoseOfABodyGoToThatBody) {
  Input input = with_bodies();
  const auto second = body_keys(1);
  ASSERT_EQ(second.size(), 6u);
  second[0].set(input, std::vector<double>{1, 2, 3});
  second[1].set(input, std::vector<double>{4, 5, 6});
  second[2].set(input, std::vector<double>{7, 8, 9});
  second[3].set(input, 0.25);
  second[4].set(input, true);
  second[5].set(input, std::string("second"));
  EXPECT_EQ(input.bodies[0], with_bodies().bodies[0]);
  EXPECT_EQ(input.bodies[1],
            (Body{.position = {1, 2, 3}, .velocity = {4, 5, 6}, .spin = {7, 8, 9}, .radius = 0.25, .fixed = true, .second = true}));
}

TEST(Bounds, AreReadAloud) {
  EXPECT_EQ(bounds_of("material.restitution").text(), "above 0 and at most 1");
  EXPECT_EQ(bounds_of("pair.radius").text(), "of at least 1e-09 and at most 100");
}

TEST(Bounds, OfMaterialsAreSharedAndOfOtherKeysUnknown) {
  EXPECT_EQ(bounds_of("second.young").high, bounds_of("material.young").high);
  EXPECT_EQ(bounds_of("wall.restitution").low_allowed, false);
  EXPECT_THROW((void)bounds_of("contact.normal"), WorkError);
  EXPECT_THROW((void)bounds_of("nonsense"), WorkError);
}

}  // namespace
}  // namespace scalebreak

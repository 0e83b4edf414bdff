#include <cfloat>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <scalebreak/scene/toml_reader.hpp>
#include <scalebreak/scene/value.hpp>

namespace scalebreak {
namespace {

Value read_back(const Value& value) { return read_toml("key = " + to_toml(value), "text").at(0).value; }

TEST(Value, NumbersAreWrittenInTheFewestDigits) {
  EXPECT_EQ(to_toml(0.1), "0.1");
  EXPECT_EQ(to_toml(1.0), "1");
  EXPECT_EQ(to_toml(-2.5), "-2.5");
  EXPECT_EQ(to_toml(1e-9), "1e-09");
  EXPECT_EQ(to_toml(1e10), "10000000000");
  EXPECT_EQ(to_toml(1e300), "1e+300");
}

TEST(Value, NumbersReadBackToTheSameBits) {
  const std::vector<double> edges = {0.0,         1.0 / 3,  0.1 + 0.2, DBL_MIN, DBL_MAX,           DBL_TRUE_MIN, 1e15,
                                     123456789e7, 1e16 - 2, 1e16,      -1e17,   9007199254740993., 4.9e-324,     1e22};
  for (const double number : edges) EXPECT_EQ(read_back(number), Value(number)) << number;
  std::mt19937_64 random(20240501);
  for (int i = 0; i < 5000; ++i) {
    const double number = std::ldexp(static_cast<double>(random()) - 9e18, static_cast<int>(random() % 2000) - 1060);
    if (std::isfinite(number)) {
      EXPECT_EQ(read_back(number), Value(number)) << number;
    }
  }
}

TEST(Value, WordsReadBackWhateverTheyHold) {
  for (const char* word : {"", "glass", "a \"quoted\" one", "back\\slash", "tab\tand\nline", "\x01\x1f", "\x7f", "Stöße"}) {
    EXPECT_EQ(read_back(std::string(word)), Value(std::string(word))) << word;
  }
}

TEST(Value, FlagsAndArraysReadBack) {
  EXPECT_EQ(to_toml(true), "true");
  EXPECT_EQ(to_toml(false), "false");
  EXPECT_EQ(to_toml(std::vector<double>{1, 0.5, -2e-7}), "[1, 0.5, -2e-07]");
  EXPECT_EQ(to_toml(std::vector<std::string>{"rps", "sup"}), "[\"rps\", \"sup\"]");
  EXPECT_EQ(to_toml(std::vector<double>{}), "[]");
  EXPECT_EQ(to_toml(std::vector<std::string>{}), "[]");
  for (const Value& value :
       {Value(true), Value(std::vector<double>{1, 0.1}), Value(std::vector<std::string>{"a", "b\""}), Value(std::vector<double>{})}) {
    EXPECT_EQ(read_back(value), value) << to_toml(value);
  }
}

}  // namespace
}  // namespace scalebreak

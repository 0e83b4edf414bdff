#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <lib/input_mutants.hpp>
#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>
#include <scalebreak/scene/keys.hpp>

// Damaged inputs: whatever the bytes, the reader either refuses them with an InputError or gives an Input whose every
// number lies in its bounds and which reads back the same. Each mutant is a function of its number alone.

namespace scalebreak {
namespace {

namespace fs = std::filesystem;

using tests::any_of;
using tests::below;
using tests::mutant;
using tests::odd_settings;
using tests::Random;
using tests::seed_texts;

testing::AssertionResult in_bounds(const Input& input, const Key& key) {
  const Value value = key.get(input);
  std::vector<double> numbers;
  if (const auto* number = std::get_if<double>(&value)) numbers = {*number};
  if (const auto* array = std::get_if<std::vector<double>>(&value)) numbers = *array;
  for (const double number : numbers) {
    if (!std::isfinite(number) || !bounds_of(key.dotted()).contain(number))
      return testing::AssertionFailure() << key.dotted() << " = " << number;
  }
  return testing::AssertionSuccess();
}

struct Tally {
  int accepted = 0, refused = 0, with_bodies = 0, with_three = 0, against_wall = 0, wet = 0, flows = 0;
};

/// Reads a mutant: refused in a sentence, or an Input that keeps every promise. Anything else fails the test.
void read(const std::string& text, const std::vector<std::string>& settings, Tally& tally) {
  Input input;
  try {
    input = tests::resolved(text, settings);
  } catch (const InputError& error) {
    ++tally.refused;
    EXPECT_STRNE(error.what(), "");
    return;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "not an InputError: " << error.what();
    return;
  } catch (...) {
    ADD_FAILURE() << "not an InputError, and no std::exception";
    return;
  }
  ++tally.accepted;
  tally.with_bodies += !input.bodies.empty();
  tally.with_three += input.bodies.size() > 2;
  tally.wet += input.surface.attraction != Attraction::none;
  tally.against_wall += input.against_wall;
  tally.flows += input.flow;
  for (const Key& key : keys()) EXPECT_TRUE(in_bounds(input, key));
  for (std::size_t i = 0; i < input.bodies.size(); ++i) {
    for (const Key& key : body_keys(i)) EXPECT_TRUE(in_bounds(input, key));
  }
  EXPECT_NO_THROW(EXPECT_TRUE(tests::resolved(write_input(input)) == input) << write_input(input));
}

struct InputFuzz : testing::Test {
  const std::string data = std::string(SCALEBREAK_SOURCE) + "/data";
  tests::EnvironmentVariable environment{"SCALEBREAK_DATA", data.c_str()};
  const std::vector<std::string> seeds = seed_texts();
  Tally tally;
};

TEST_F(InputFuzz, DamagedFilesAndSettingsAreRefusedOrKeepEveryPromise) {
  for (std::uint64_t i = 0; i < 52'000 && !HasFailure(); ++i) {
    Random random(i);
    const std::string text = mutant(any_of(random, seeds), random, seeds);
    const std::vector<std::string> settings = below(random, 3) == 0 ? odd_settings(random) : std::vector<std::string>{};
    SCOPED_TRACE(fmt::format("mutant {}:\n{}\nsettings: {}", i, text, fmt::join(settings, " ")));
    read(text, settings, tally);
  }
  // The mutants are neither all hopeless nor all harmless.
  EXPECT_GT(tally.accepted, 4000);
  EXPECT_GT(tally.refused, 10'000);
  EXPECT_GT(tally.with_bodies, 200);
  EXPECT_GT(tally.with_three, 200);
  EXPECT_GT(tally.wet, 200);
  EXPECT_GT(tally.against_wall, 200);
  EXPECT_GT(tally.flows, 300);
}

TEST_F(InputFuzz, DamagedMaterialFilesAreRefusedOrKeepEveryPromise) {
  const tests::TemporaryFolder folder;
  const tests::EnvironmentVariable elsewhere("SCALEBREAK_DATA", folder.path().c_str());
  const std::string latex = tests::content_of(fs::path(SCALEBREAK_SOURCE) / "data/materials/latex.toml");
  for (std::uint64_t i = 0; i < 1500 && !HasFailure(); ++i) {
    Random random(i);
    const std::string text = mutant(latex, random, seeds);
    SCOPED_TRACE(fmt::format("material {}:\n{}", i, text));
    tests::put_file(folder / "materials/mutant.toml", text);
    read("[material]\nname = \"mutant\"\n[wall]\nname = \"mutant\"\n", {}, tally);
  }
  EXPECT_GT(tally.accepted, 150);
  EXPECT_GT(tally.refused, 500);
}

TEST_F(InputFuzz, SettingsOfRandomBytesAreRefused) {
  for (std::uint64_t i = 0; i < 2000 && !HasFailure(); ++i) {
    Random random(i);
    std::string text(below(random, 30), ' ');
    for (char& c : text) c = static_cast<char>(random());
    SCOPED_TRACE(fmt::format("setting {}: {}", i, text));
    read("", {text}, tally);
    read("", {"material.young=" + text}, tally);
  }
  EXPECT_GT(tally.refused, 3900);
}

}  // namespace
}  // namespace scalebreak

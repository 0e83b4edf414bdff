#include <gmock/gmock.h>

#include <apps/program.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

/// Tables of a coarse tolerance, which are built in a moment.
struct Table : ProgramTest {
  const std::string coarse = "numerics.table_tolerance=1e-3";
  const std::string name = tables + "/jkr-full-contact_radius-0.001";

  [[nodiscard]] ProgramRun table(std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"table", "--json", "--tables", tables, "--set", coarse};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(Table, JsonHasTheDocumentedKeysAndTheErrorIsBelowTheTolerance) {
  const ProgramRun result = table();
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  const json j = result.json();
  for (const char* key : {"entries", "error_max", "error_rms", "build_seconds", "lookup_ns"}) {
    ASSERT_TRUE(j.contains(key)) << key;
    EXPECT_GT(j[key].get<double>(), 0) << key;
  }
  EXPECT_LE(j["error_max"].get<double>(), 1e-3);
  EXPECT_LE(j["error_rms"].get<double>(), j["error_max"].get<double>());
  EXPECT_TRUE(fs::exists(name + ".npy") && fs::exists(name + ".json"));
  EXPECT_EQ(entries_in(tables), 2);
}

TEST_F(Table, IsReadTheSecondTimeAndSaysTheSame) {
  const json first = table().json();
  const std::string array = content_of(name + ".npy");
  const ProgramRun again = table({"--quiet"});
  ASSERT_EQ(again.status, 0);
  const json second = again.json();
  EXPECT_EQ(first["built"], true);
  EXPECT_EQ(second["built"], false);
  EXPECT_EQ(second["build_seconds"], 0);
  for (const char* key : {"kind", "tolerance", "entries", "error_max", "error_rms"}) EXPECT_EQ(first[key], second[key]) << key;
  EXPECT_EQ(content_of(name + ".npy"), array);
  EXPECT_EQ(table({"--rebuild"}).json()["built"], true);
}

TEST_F(Table, IsTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(table({"--threads", "1"}).status, 0);
  const std::string array = content_of(name + ".npy"), text = content_of(name + ".json");
  ASSERT_EQ(table({"--threads", "2", "--rebuild"}).status, 0);
  EXPECT_EQ(content_of(name + ".npy"), array);
  EXPECT_EQ(content_of(name + ".json"), text);
}

TEST_F(Table, ADamagedOneIsNamedAndBuiltAnew) {
  ASSERT_EQ(table().status, 0);
  const std::string array = content_of(name + ".npy"), text = content_of(name + ".json");
  std::string flipped = array, retold = text;
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
  retold.insert(retold.find("\"error_max\": ") + 13, "1");
  const auto damage = [&](const std::string& npy, const std::string& json_text) {
    put_file(name + ".npy", npy), put_file(name + ".json", json_text);
  };
  const std::vector<std::pair<std::string, std::function<void()>>> damages = {
      {"its checksum does not fit", [&] { damage(flipped, text); }},
      {"its checksum does not fit", [&] { damage(array.substr(0, array.size() - 8), text); }},
      {"its checksum does not fit", [&] { damage("", text); }},
      {"its checksum does not fit", [&] { damage(array, retold); }},
      {"it cannot be read (", [&] { damage(array, text.substr(0, text.size() / 2)); }},
      {"it cannot be read (", [&] { damage(array, ""); }},
      {"it cannot be read (", [&] { damage(array, "[1, 2]"); }},
      {"one of its two files is missing", [&] { damage(array, text), fs::remove(name + ".npy"); }},
      {"one of its two files is missing", [&] { damage(array, text), fs::remove(name + ".json"); }},
  };
  for (const auto& [reason, spoil] : damages) {
    spoil();
    const ProgramRun result = table();
    ASSERT_EQ(result.status, 0) << reason << ": " << result.err;
    EXPECT_EQ(result.json()["built"], true) << reason;
    EXPECT_THAT(result.err, HasSubstr("scalebreak: the table jkr-full-contact_radius-0.001 in " + tables + " is not used: " + reason));
    EXPECT_EQ(content_of(name + ".npy"), array) << reason;
    EXPECT_EQ(content_of(name + ".json"), text) << reason;
  }
}

TEST_F(Table, OfTheRollingIsKeptBesideIt) {
  const ProgramRun first = table({"--quiet", "--set", "contact.rolling=cdt"});
  ASSERT_EQ(first.status, 0) << first.err;
  const json rolling = first.json()["rolling"];
  EXPECT_EQ(rolling["surface"], "rolling cdt");
  EXPECT_LE(rolling["error_max"].get<double>(), 1e-4);
  EXPECT_EQ(rolling["built"], true);
  EXPECT_EQ(entries_in(tables), 4);
  EXPECT_EQ(table({"--set", "contact.rolling=cdt"}).json()["rolling"]["built"], false);
  const ProgramRun none = table({"--set", "contact.normal=hertz", "--set", "contact.rolling=ar"});
  ASSERT_EQ(none.status, 0) << none.err;
  EXPECT_TRUE(none.json()["rolling"].is_null());
  EXPECT_THAT(none.err, HasSubstr("no rolling table: adhesive rolling beside a contact without adhesion is another one at every speed"));
}

TEST_F(Table, OfAnotherToleranceOrKindIsAnotherTable) {
  ASSERT_EQ(table().status, 0);
  EXPECT_EQ(table({"--set", "numerics.table_tolerance=1e-2"}).json()["built"], true);
  EXPECT_EQ(table({"--set", "contact.adhesion_range=touch"}).json()["built"], true);
  EXPECT_EQ(entries_in(tables), 6);
  EXPECT_EQ(table().json()["built"], false);
}

TEST_F(Table, OfAllKindsGivesOneObject) {
  const ProgramRun result = run({"table", "--all", "--json", "--quiet", "--tables", tables, "--set", "numerics.table_tolerance=1e-2"});
  ASSERT_EQ(result.status, 0) << result.err;
  std::set<std::string> kinds;
  const json j = result.json();
  for (const json& one : j["tables"]) kinds.insert(one["kind"].get<std::string>());
  EXPECT_EQ(kinds.size(), 8u);
  EXPECT_EQ(entries_in(tables), 16);
}

TEST_F(Table, IsKeptInTheUsersCacheUnlessToldOtherwise) {
  ASSERT_EQ(run({"table", "--quiet", "--set", coarse}).status, 0);
  EXPECT_TRUE(fs::exists(folder.path() / "cache/scalebreak/tables/jkr-full-contact_radius-0.001.npy"));
}

TEST_F(Table, WritesACurveFileAndItsInput) {
  const ProgramRun result = table({"--out", out});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_file(out + "/result.json"), result.json());
  EXPECT_THAT(content_of(out + "/jkr-full-contact_radius-0.001.csv"), testing::StartsWith("restitution_given [-],speed_reduced [-],"));
  EXPECT_THAT(content_of(out + "/input.toml"), HasSubstr("table_tolerance = 0.001\n"));
}

TEST_F(Table, QuietLeavesStandardErrorEmptyAndOtherwiseThereIsProgress) {
  EXPECT_THAT(table({"--quiet"}).err, IsEmpty());
  EXPECT_THAT(table({"--rebuild"}).err, HasSubstr("building a collision table"));
  put_file(name + ".json", "{");
  EXPECT_THAT(table({"--quiet"}).err, IsEmpty());
}

}  // namespace
}  // namespace scalebreak::tests

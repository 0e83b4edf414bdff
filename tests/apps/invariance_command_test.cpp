#include <gmock/gmock.h>

#include <apps/program.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

/// Small studies, with a coarse table that is built in a moment.
struct Invariance : ProgramTest {
  const std::string small = scene("small.toml", R"([study]
laws = ["none", "rps", "sup"]
factors = [0.1, 2]
speeds = [1e-4, 0.05, 0.5]
[numerics]
table_tolerance = 1e-3
)");

  [[nodiscard]] ProgramRun invariance(std::vector<std::string> words) const {
    words.insert(words.begin(), {"invariance", "--tables", tables});
    return run(words);
  }
};

TEST_F(Invariance, JsonHasTheDocumentedRecords) {
  const ProgramRun result = invariance({small, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  const json j = result.json();
  EXPECT_EQ(keys_of(j), std::set<std::string>{"records"});
  ASSERT_EQ(j["records"].size(), 4u * 3) << "none takes both factors, rps and sup one each, at three speeds";
  for (const json& record : j["records"]) {
    for (const char* key : {"law", "factor", "normal_speed", "stuck", "restitution_normal", "sticking_speed", "contact_time_ratio",
                            "max_overlap_ratio", "sticking_speed_ratio", "spin_ratio"}) {
      EXPECT_TRUE(record.contains(key)) << key;
    }
    EXPECT_TRUE(record["spin_ratio"].is_null());
    if (record["stuck"] == true) {
      EXPECT_TRUE(record["restitution_normal"] == 0 && record["contact_time_ratio"].is_null()) << record;
    }
  }
}

TEST_F(Invariance, TheSlowestSpeedSticksAndExactLawsKeepTheRest) {
  std::map<double, double> original;
  for (const char* speed : {"0.05", "0.5"})
    original[std::stod(speed)] =
        run({"collide", "--json", "--set", std::string("impact.normal_speed=") + speed}).json()["restitution_normal"];
  const json records = invariance({small, "--json"}).json()["records"];
  EXPECT_EQ(records.size(), 12u);
  for (const json& record : records) {
    const double speed = record["normal_speed"];
    EXPECT_EQ(record["stuck"].get<bool>(), speed == 1e-4) << record;
    if (record["law"] == "none" || speed == 1e-4) continue;
    EXPECT_NEAR(record["restitution_normal"].get<double>(), original.at(speed), 1e-6) << record;
    EXPECT_NEAR(record["sticking_speed_ratio"].get<double>(), 1, 1e-9) << record;
  }
}

TEST_F(Invariance, IsTheSameForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(invariance({"--set", "numerics.table_tolerance=1e-3", "--threads", threads, "--quiet", "--out", out + threads}).status, 0);
  const std::string first = content_of(out + "1/result.json");
  EXPECT_GT(first.size(), 1000u);
  EXPECT_EQ(first, content_of(out + "2/result.json"));
  for (const char* file : {"invariance.csv", "summary.csv", "restitution.csv", "loops.csv", "input.toml"})
    EXPECT_EQ(content_of(out + "1/" + file), content_of(out + "2/" + file)) << file;
}

TEST_F(Invariance, OneFileWritesItsResultsAndAReport) {
  const ProgramRun result = invariance({small, "--out", out, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_file(out + "/result.json"), result.json());
  EXPECT_THAT(content_of(out + "/invariance.csv"), testing::StartsWith("law,factor [-],normal_speed [m/s],"));
  const std::string page = content_of(out + "/index.html");
  EXPECT_THAT(page, HasSubstr("<h2>small</h2>"));
  EXPECT_THAT(page, HasSubstr("rps keeps the restitution at every speed"));
  if (gnuplot_is_there()) {
    EXPECT_THAT(page, HasSubstr("<svg"));
    EXPECT_THAT(page, testing::Not(HasSubstr("was not drawn")));
    for (const char* plot : {"restitution", "contact_time", "force_overlap", "sticking_speed"})
      EXPECT_TRUE(fs::exists(out + "/" + plot + ".svg") && fs::exists(out + "/" + plot + ".png")) << plot;
  }
}

TEST_F(Invariance, TheWrittenInputRunsAgainToTheSameBytes) {
  ASSERT_EQ(invariance({small, "--out", out, "--quiet"}).status, 0);
  ASSERT_EQ(invariance({out + "/input.toml", "--out", out + "/again", "--quiet"}).status, 0);
  for (const char* file : {"result.json", "input.toml", "invariance.csv", "summary.csv", "restitution.csv"})
    EXPECT_EQ(content_of(out + "/" + file), content_of(out + "/again/" + file)) << file;
}

TEST_F(Invariance, TwoFilesMakeTwoChaptersOfOneReport) {
  const std::string wall = scene("on_wall.toml", R"([pair]
partner = "wall"
[study]
laws = ["rps"]
factors = [0.1]
speeds = [0.1]
[numerics]
table_tolerance = 1e-3
)");
  const ProgramRun result = invariance({small, wall, "--out", out, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json scenes = result.json()["scenes"];
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(json_file(out + "/small/result.json"), scenes[0]);
  EXPECT_EQ(json_file(out + "/on_wall/result.json"), scenes[1]);
  const std::string page = content_of(out + "/index.html");
  const std::size_t first = page.find("<h2>small</h2>"), second = page.find("<h2>on wall</h2>");
  EXPECT_LT(first, second);
  EXPECT_NE(second, std::string::npos);
  EXPECT_THAT(page, HasSubstr("A sphere and a flat wall"));
}

TEST_F(Invariance, AnObliqueImpactFillsTheSpinRatioAndDrawsItsCharts) {
  const std::string oblique = scene("oblique.toml", R"([contact]
tangential = "mindlin"
[impact]
tangential_speed = 0.5
[study]
laws = ["sup", "rps"]
factors = [0.1, 2]
speeds = [0.1, 0.5]
[numerics]
table_tolerance = 1e-3
)");
  const ProgramRun result = invariance({oblique, "--out", out, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json records = result.json()["records"];
  ASSERT_EQ(records.size(), 4u);
  for (const json& record : records) {
    if (record["law"] != "sup") continue;
    EXPECT_NEAR(record["spin_ratio_limit"].get<double>(), 0.5, 1e-6) << "it slides throughout";
    EXPECT_NEAR(record["spin_ratio"].get<double>(), 0.5, 1e-3);
    EXPECT_LT(record["angular_momentum_change"].get<double>(), -0.01);
  }
  EXPECT_THAT(content_of(out + "/motion.csv"), HasSubstr("sup,1 and above,spin_ratio,moved,"));
  EXPECT_THAT(content_of(out + "/index.html"), HasSubstr("spin gained × size as factor^-1.000"));
  if (gnuplot_is_there()) {
    for (const char* plot : {"spin_ratio", "spin_ratio_stiffness", "tangential_restitution", "angular_momentum"})
      EXPECT_TRUE(fs::exists(out + "/" + plot + ".png")) << plot;
  }
}

TEST_F(Invariance, FilesOfOneNameGetChaptersOfTheirOwn) {
  const std::string other =
      scene("elsewhere/small.toml", "[study]\nlaws = [\"sup\"]\nfactors = [2]\nspeeds = [0.1]\n[numerics]\ntable_tolerance = 1e-3\n");
  ASSERT_EQ(invariance({small, other, "--out", out, "--quiet"}).status, 0);
  EXPECT_EQ(json_file(out + "/small/result.json")["records"].size(), 12u);
  EXPECT_EQ(json_file(out + "/small_2/result.json")["records"].size(), 1u);
}

TEST_F(Invariance, AWrongSecondFileStopsEverything) {
  const std::string bad = scene("bad.toml", "[study]\nlaws = [\"rps\"]\nfactors = [2]\n");
  const std::string bodies = scene("bodies.toml", R"([[body]]
position = [0, 0, 1]
velocity = [0, 0, -1]
radius = 0.1
[[body]]
position = [0, 0, 0]
radius = 0.1
)");
  const ProgramRun wrong = invariance({small, bad, "--out", out});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("bad.toml, line 2: study.laws holds \"rps\", which no factor of study.factors suits"));
  const ProgramRun few = invariance({small, bodies, "--out", out});
  EXPECT_EQ(few.status, 2);
  EXPECT_THAT(few.err, HasSubstr("bodies.toml: invariance compares pairs"));
  EXPECT_FALSE(fs::exists(out) || fs::exists(tables));
}

TEST_F(Invariance, CheckRefusesWhatTheRunRefuses) {
  const std::string bodies = scene("bodies.toml", R"([[body]]
position = [0, 0, 1]
velocity = [0, 0, -1]
radius = 0.1
[[body]]
position = [0, 0, 0]
radius = 0.1
)");
  const ProgramRun result = invariance({bodies, "--check"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("bodies.toml: invariance compares pairs"));
}

TEST_F(Invariance, WithoutGnuplotTheReportShowsNoOlderDrawings) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not on PATH";
  ASSERT_EQ(invariance({small, "--out", out, "--quiet"}).status, 0);
  const EnvironmentVariable nowhere("PATH", folder.path().c_str());
  ASSERT_EQ(invariance({small, "--out", out, "--quiet", "--set", "material.restitution=0.5"}).status, 0);
  EXPECT_EQ(content_of(out + "/index.html").find("<svg"), std::string::npos);
}

TEST_F(Invariance, QuietLeavesStandardErrorEmptyAndOtherwiseThereIsProgress) {
  EXPECT_THAT(invariance({small, "--quiet"}).err, IsEmpty());
  const std::string err = invariance({small}).err;
  EXPECT_THAT(err, HasSubstr("comparing laws, small"));
  EXPECT_THAT(err, HasSubstr("2 pairs of law and factor were left out"));
}

TEST_F(Invariance, AFileNameRunsNoCommands) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not on PATH";
  const std::string odd = scene("a`touch ran`\"b'.toml", content_of(small));
  ASSERT_EQ(invariance({odd, "--out", out, "--quiet"}).status, 0);
  EXPECT_FALSE(fs::exists(out + "/ran"));
  EXPECT_TRUE(fs::exists(out + "/restitution.svg"));
}

}  // namespace
}  // namespace scalebreak::tests

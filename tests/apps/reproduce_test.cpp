#include <gmock/gmock.h>

#include <apps/program.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

struct Reproduce : ProgramTest {
  [[nodiscard]] ProgramRun reproduce(std::vector<std::string> words) const {
    words.insert(words.begin(), "reproduce");
    return run(words);
  }
};

const std::vector<std::string> names = {"w-case1", "w-case2", "w-case3", "c-case-a", "c-case-b", "c-case-c", "gap-row"};

TEST_F(Reproduce, ListsTheCasesAndEveryOneHasAnInputThatIsValid) {
  const ProgramRun text = reproduce({"--list"});
  ASSERT_EQ(text.status, 0) << text.err;
  const json cases = reproduce({"--list", "--json"}).json()["cases"];
  ASSERT_EQ(cases.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(cases[i]["name"], names[i]);
    EXPECT_THAT(text.out, HasSubstr(names[i]));
    const ProgramRun checked = reproduce({names[i], "--check", "--json"});
    ASSERT_EQ(checked.status, 0) << checked.err;
    EXPECT_EQ(checked.json()["checked"].size(), 1u);
  }
}

TEST_F(Reproduce, AnUnknownOrMissingNameIsAWrongInput) {
  const ProgramRun unknown = reproduce({"w-case9", "--out", out});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("reproduce: found the case \"w-case9\"; allowed: \"w-case1\""));
  const ProgramRun missing = reproduce({"--out", out});
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.err, HasSubstr("the name of a case is missing"));
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Reproduce, RefusesWhatIsNotTheCaseAnyMore) {
  const ProgramRun scaled = reproduce({"c-case-c", "--set", "scaling.law=rps", "--set", "scaling.factor=0.1", "--check"});
  EXPECT_EQ(scaled.status, 2);
  EXPECT_THAT(scaled.err, HasSubstr("scaling.law = \"rps\" with scaling.factor = 0.1 cannot be used"));
  const ProgramRun oblique = reproduce({"c-case-a", "--set", "body.1.velocity=[0.4, 0.1, 0]", "--out", out});
  EXPECT_EQ(oblique.status, 2);
  EXPECT_THAT(oblique.err, HasSubstr("body.1 moves across the line"));
  const std::string pair = scene("pair.toml", "[pair]\nradius = [1e-3, 1e-3]\n");
  const ProgramRun few = reproduce({"gap-row", pair, "--out", out});
  EXPECT_EQ(few.status, 2);
  EXPECT_THAT(few.err, HasSubstr("found 0 [[body]] tables; allowed: 3"));
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Reproduce, WritesItsFilesAndRunsAgainFromThem) {
  const ProgramRun result = reproduce({"c-case-c", "--out", out, "--json", "--quiet"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_EQ(json_file(out + "/result.json"), result.json());
  EXPECT_THAT(content_of(out + "/speeds.csv"), testing::StartsWith("law,factor [-],impact_speed [m/s],"));
  EXPECT_THAT(content_of(out + "/input.toml"), HasSubstr("scalebreak reproduce c-case-c input.toml"));
  const std::string page = content_of(out + "/index.html");
  EXPECT_THAT(page, HasSubstr("What the paper says, and what comes out"));
  if (gnuplot_is_there()) {
    EXPECT_THAT(page, testing::Not(HasSubstr("was not drawn")));
    for (const char* plot : {"restitution", "contact_time"})
      EXPECT_TRUE(fs::exists(out + "/" + plot + ".svg") && fs::exists(out + "/" + plot + ".png")) << plot;
  }
  ASSERT_EQ(reproduce({"c-case-c", out + "/input.toml", "--out", out + "/again", "--quiet"}).status, 0);
  for (const char* file : {"result.json", "input.toml", "speeds.csv"})
    EXPECT_EQ(content_of(out + "/" + file), content_of(out + "/again/" + file)) << file;
}

TEST_F(Reproduce, PrintsALineOfNumbersPerCurveAndWhetherEachBarHolds) {
  const ProgramRun result = reproduce({"c-case-c", "--quiet"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\noriginal: restitution_change 0, "));
  EXPECT_THAT(result.out, HasSubstr("\nchen_elliott, 4: restitution_change "));
  EXPECT_THAT(result.out, HasSubstr("at most 1e-07: holds\n"));
}

TEST_F(Reproduce, ABarThatDoesNotHoldIsSaidNotHidden) {
  // Stickier spheres stay together: the smaller one then leaves no faster than it came.
  const std::string statement = "the smaller sphere leaves faster than it came: speed after over before";
  const ProgramRun stuck = reproduce({"c-case-a", "--quiet", "--set", "material.surface_energy=2.5"});
  ASSERT_EQ(stuck.status, 0) << stuck.err;
  EXPECT_THAT(stuck.out, testing::ContainsRegex(statement + ": 0\\.[0-9]+, at least 1: DOES NOT HOLD"));
  EXPECT_THAT(reproduce({"c-case-a", "--quiet"}).out, testing::ContainsRegex(statement + ": 2\\.[0-9]+, at least 1: holds"));
}

TEST_F(Reproduce, AMissingDataFolderIsAWrongInput) {
  const EnvironmentVariable data("SCALEBREAK_DATA", folder.path().c_str());
  const ProgramRun result = reproduce({"gap-row"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("the input of \"gap-row\" is missing"));
}

}  // namespace
}  // namespace scalebreak::tests

#include <gmock/gmock.h>

#include <apps/program.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;

struct StabilityCommand : ProgramTest {
  std::string file = scene("box.toml",
                           "[material]\nyoung = 1e7\n[contact]\nnormal = \"hertz\"\n[particles]\ncount = 60\nvolume_fraction = 0.3\n"
                           "speed = 0.02\n[cell]\nkind = \"cooling\"\n[study]\nlaws = [\"sup\"]\nfactors = [2]\n");
};

TEST_F(StabilityCommand, GivesEveryKeyAndEveryFile) {
  const ProgramRun result = run({"stability", file, "--out", out, "--json", "--quiet"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json j = result.json();
  EXPECT_EQ(j["particles"], 60);
  EXPECT_EQ(j["criteria"][0]["name"], "energy_growth");
  EXPECT_EQ(j["criteria"][0]["limit"], 1e-3);
  ASSERT_EQ(j["records"].size(), 2u);
  const std::set<std::string> expected = {"law",        "factor",        "integrator",       "criterion",    "step",
                                          "step_error", "rayleigh_step", "oscillation_step", "contact_time", "steps_per_contact",
                                          "step_ratio", "value_below",   "value_above",      "failure",      "trials"};
  for (const json& record : j["records"]) EXPECT_THAT(keys_of(record), testing::IsSupersetOf(expected));
  const json &original = j["records"][0], &scaled = j["records"][1];
  EXPECT_EQ(original["step_ratio"], 1);
  EXPECT_NEAR(scaled["step_ratio"].get<double>(), 2, 0.2);
  EXPECT_TRUE(original["oscillation_step"].is_null());  // of linear contacts alone
  EXPECT_EQ(j, json_file(std::filesystem::path(out) / "result.json"));
  for (const char* name : {"input.toml", "stability.csv", "trials.csv", "largest_step.gp", "energy_growth.gp", "index.html"})
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / name)) << name;
  if (gnuplot_is_there()) {
    EXPECT_TRUE(std::filesystem::exists(out + "/largest_step.svg"));
    EXPECT_TRUE(std::filesystem::exists(out + "/energy_growth.svg"));
  }
  EXPECT_EQ(run({"stability", out + "/input.toml", "--json", "--quiet"}).json(), j);
}

TEST_F(StabilityCommand, PutsLinearContactsBesideTheirOscillation) {
  const json j = run({"stability", file, "--set", "contact.normal=linear", "--json", "--quiet"}).json();
  EXPECT_GT(j["records"][0]["oscillation_step"].get<double>(), 0);
}

TEST_F(StabilityCommand, ChecksWithoutWorking) {
  const ProgramRun checked = run({"stability", file, "--check"});
  EXPECT_EQ(checked.status, 0);
  EXPECT_THAT(checked.out, testing::HasSubstr("2 bisections"));
}

TEST_F(StabilityCommand, FindsTheStepAtWhichACollisionIsOff) {
  const std::string pair = scene("pair.toml",
                                 "[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\n[impact]\nnormal_speed = 0.3\n"
                                 "[study]\nlaws = [\"sup\"]\nfactors = [4]\nintegrators = [\"verlet\", \"synchronized\"]\n");
  const ProgramRun result = run({"stability", pair, "--json", "--quiet", "--out", out});
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  EXPECT_EQ(j["criteria"][0]["name"], "motion_error");
  ASSERT_EQ(j["records"].size(), 4u);
  for (const json& record : j["records"]) {
    EXPECT_LE(record["value_below"].get<double>(), 1e-2);
    EXPECT_GT(record["value_above"].get<double>(), 1e-2);
    EXPECT_GT(record["steps_per_contact"].get<double>(), 2);
  }
  // SUP by 4 is the same motion in units four times as long.
  EXPECT_NEAR(j["records"][1]["step_ratio"].get<double>(), 4, 1e-9);
  EXPECT_TRUE(std::filesystem::exists(out + "/motion_error.gp"));
}

TEST_F(StabilityCommand, FindsTheStepThatLeavesRollingBehind) {
  const ProgramRun result = run({"stability", SCALEBREAK_SOURCE "/data/failures/rolling_chatter.toml", "--json", "--quiet", "--set",
                                 "study.phases=2", "--set", "study.laws=[\"rps\"]", "--set", "study.factors=[0.01]", "--set",
                                 "study.motion_error=4e-3", "--set", "study.integrators=[\"synchronized\"]"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  EXPECT_EQ(j["criteria"][1]["name"], "rolling_left");
  ASSERT_EQ(j["records"].size(), 4u);
  for (const json& record : j["records"]) {
    EXPECT_LE(record["value_below"].get<double>(), 4e-3) << record["criterion"];
    EXPECT_GT(record["value_above"].get<double>(), 4e-3) << record["criterion"];
  }
}

TEST_F(StabilityCommand, AsksForRollingOnlyWhereItEnds) {
  const json j = run({"stability",
                      scene("pair.toml",
                            "[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\nrolling = \"cdt\"\n"
                            "[study]\nlaws = [\"sup\"]\nfactors = [4]\n"),
                      "--json", "--quiet"})
                     .json();
  EXPECT_EQ(j["criteria"].size(), 1u);
}

}  // namespace
}  // namespace scalebreak::tests

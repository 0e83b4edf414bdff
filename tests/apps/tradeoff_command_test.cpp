#include <gmock/gmock.h>

#include <apps/program.hpp>
#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsSupersetOf;

struct TradeoffCommand : ProgramTest {};

const std::vector<std::string> quick = {"--set", "study.step_fractions=[0.2, 0.15, 0.1, 0.07, 0.05]",
                                        "--set", "study.tolerances=[1e-4, 1e-6, 1e-8]",
                                        "--set", "study.phases=4"};

std::vector<std::string> words(std::vector<std::string> first, const std::vector<std::string>& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

TEST_F(TradeoffCommand, OfACollisionGivesPointsOrdersAndFiles) {
  const ProgramRun result = run(words({"tradeoff", "--json", "--quiet", "--out", out}, quick));
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json j = result.json();
  ASSERT_EQ(j["points"].size(), 5u + 5u + 5u * 3u + 2u);
  EXPECT_EQ(j["points"][13]["method"], "cash_karp54");
  EXPECT_EQ(j["points"][25]["method"], "table");
  EXPECT_THAT(j["refusals"][0], HasSubstr("table at 1e-08: "));
  const json &coarse = j["points"][0], &fine = j["points"][4], &exact = j["points"][12];
  EXPECT_EQ(coarse["method"], "verlet");
  EXPECT_EQ(exact["method"], "exact");
  EXPECT_EQ(exact["step"], nullptr);
  EXPECT_NEAR(coarse["step"].get<double>(), 0.2 * j["rayleigh_step"].get<double>(), 1e-18);
  EXPECT_GT(coarse["motion_error_rms"].get<double>(), fine["motion_error_rms"].get<double>());
  EXPECT_LT(exact["motion_error_rms"].get<double>(), 1e-7);
  EXPECT_GT(exact["force_evaluations"].get<double>(), 50);
  const json& order = j["convergence"][1];
  EXPECT_EQ(order["method"], "synchronized");
  EXPECT_GT(order["order"].get<double>(), 0.5);
  EXPECT_GT(order["order_error"].get<double>(), 0);
  EXPECT_EQ(j, json_file(std::filesystem::path(out) / "result.json"));
  EXPECT_THAT(names_of(files_of(out)), IsSupersetOf({"input.toml", "result.json", "tradeoff.csv", "front.csv", "convergence.gp", "front.gp",
                                                     "front_wall_time.gp", "index.html"}));
  EXPECT_THAT(run(words({"tradeoff", "--quiet"}, quick)).out, HasSubstr("error ∝ step_fraction^("));
}

TEST_F(TradeoffCommand, ComparesWhatStudyMethodsNames) {
  const ProgramRun result = run(words({"tradeoff", "--json", "--quiet", "--set", "study.methods=[\"table\", \"closed_form\"]"}, quick));
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  ASSERT_EQ(j["points"].size(), 2u);
  for (const json& point : j["points"]) EXPECT_EQ(point["method"], "table");
  EXPECT_THAT(j["refusals"].back(), HasSubstr("closed_form: "));
}

TEST_F(TradeoffCommand, OfBodiesHasNoContactTimes) {
  const std::string row = scene("row.toml",
                                "[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\n"
                                "[[body]]\nposition = [0, 0, 0]\nradius = 1e-3\nvelocity = [0, 0, 0.1]\n"
                                "[[body]]\nposition = [0, 0, 2.1e-3]\nradius = 1e-3\n[[body]]\nposition = [0, 0, 4.2e-3]\nradius = 1e-3\n");
  const ProgramRun result = run(words({"tradeoff", row, "--json", "--quiet"}, quick));
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  EXPECT_TRUE(j["contact_time"].is_null());
  for (const json& order : j["convergence"]) EXPECT_TRUE(order["contact_time_order"].is_null());
  EXPECT_TRUE(j["convergence"][0]["order"].is_number());
}

TEST_F(TradeoffCommand, OfAFlowComparesSteps) {
  const std::string file = scene("shear.toml", small_shear);
  const ProgramRun result = run({"tradeoff", file, "--json", "--quiet", "--out", out, "--threads", "1", "--set",
                                 "study.step_fractions=[0.3, 0.15]", "--set", "study.methods=[\"verlet\", \"synchronized\"]"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  ASSERT_EQ(j["points"].size(), 4u);
  EXPECT_EQ(j["reference"], 3);
  EXPECT_EQ(j["points"][3]["deviations"]["temperature"]["relative"], 0);
  EXPECT_NE(j["points"][0]["deviations"]["temperature"]["relative"], 0);
  EXPECT_THAT(names_of(files_of(out)), IsSupersetOf({"tradeoff.csv", "deviations.gp", "front.gp", "index.html"}));
}

/// Killed and asked again, it goes on with what it had; the counted work is the same.
TEST_F(TradeoffCommand, OfAFlowComparesAllMethods) {
  const std::string file = scene("shear.toml", small_shear);
  const std::vector<std::string> command = {"tradeoff",  file,
                                            "--json",    "--quiet",
                                            "--out",     out,
                                            "--set",     "study.laws=[\"rps\"]",
                                            "--set",     "study.factors=[0.1]",
                                            "--set",     "study.step_fractions=[0.3]",
                                            "--set",     "run.strain=0.6",
                                            "--set",     "contact.normal=hertz",
                                            "--set",     "contact.tangential=none",
                                            "--threads", "1"};
  const ProgramRun result = run(command);
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  ASSERT_EQ(j["points"].size(), 5u);
  EXPECT_EQ(j["points"][0]["step_fraction"], 0.3);
  EXPECT_EQ(j["points"][2]["law"], "rps");
  EXPECT_EQ(j["points"][3]["engine"], "hybrid");
  EXPECT_GT(j["points"][0]["run_evaluations"].get<double>(), 0);
  EXPECT_GT(j["points"][3]["run_lookups"].get<double>(), 0);
  EXPECT_TRUE(j["complete"].get<bool>());
  EXPECT_THAT(names_of(files_of(out)), IsSupersetOf({"input.toml", "result.json", "tradeoff.csv", "front_work.csv", "front_time.csv",
                                                     "front_work.gp", "front_time.gp", "index.html"}));
  EXPECT_EQ(run(command).json(), j);
}

TEST_F(TradeoffCommand, RefusesInOneSentence) {
  const ProgramRun sticks = run({"tradeoff", "--set", "impact.normal_speed=1e-4"});
  EXPECT_EQ(sticks.status, 2);
  EXPECT_EQ(sticks.err,
            "scalebreak: the bodies stick, so that there is no end to compare; allowed: bodies that part, or [[body]] with run.duration\n");
  const ProgramRun fine = run({"tradeoff", "--set", "study.step_fractions=[1e-6]"});
  EXPECT_EQ(fine.status, 2);
  EXPECT_THAT(fine.err,
              HasSubstr("study.step_fractions: found [1e-06]; allowed: an array of 1 to 100 numbers of at least 0.0001 and at most 1"));
  EXPECT_THAT(
      run({"tradeoff", "--set", "study.methods=[\"euler\"]"}).err,
      HasSubstr("\"verlet\", \"synchronized\", \"exact\", \"cash_karp54\", \"dopri5\", \"dopri5_dense\", \"bulirsch_stoer\", \"table\", "
                "\"closed_form\""));
}

TEST_F(TradeoffCommand, CheckEstimates) {
  EXPECT_THAT(run({"tradeoff", "--check"}).out, HasSubstr("5.8e+04 steps of soft spheres, about "));
  const std::string file = scene("shear.toml", small_shear);
  EXPECT_THAT(run({"tradeoff", file, "--check", "--set", "study.methods=[\"verlet\", \"synchronized\"]"}).out,
              HasSubstr("# estimate: 18 flows, about "));
  EXPECT_THAT(run({"tradeoff", file, "--check", "--set", "study.laws=[\"rps\"]", "--set", "study.factors=[0.1]"}).out,
              HasSubstr("# estimate: 12 ways, 12 runs, about "));
}

}  // namespace
}  // namespace scalebreak::tests

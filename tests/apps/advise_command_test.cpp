#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include <scalebreak/ensembles/breakdown/verdicts.hpp>
#include <scalebreak/ensembles/prediction/prediction_file.hpp>
#include <scalebreak/output/atomic_file.hpp>

#include <apps/program.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;

/// A model as a fit would make it, with coefficients of the right sign.
DeviationModel some_model() {
  DeviationModel model;
  for (const std::string& name : judged_quantities()) {
    QuantityModel q{.quantity = name, .coefficients = {-0.5, 0.4, -0.1, -3}, .scatter = 0.2};
    q.fitted.fill(true);
    for (std::size_t i = 0; i < term_count; ++i) q.covariance[i][i] = 1e-4;
    model.quantities.push_back(q);
    model.validation[name] = {};
  }
  model.ranges["contact_time_x_collision_rate"] = {1e-4, 1};
  return model;
}

struct AdviseCommand : ProgramTest {
  std::string model = scene("model.json", model_json(some_model()).dump());
  std::string file = scene("shear.toml",
                           "[contact]\nnormal = \"jkr\"\ntangential = \"mindlin\"\n[particles]\ncount = 500\nvolume_fraction = 0.4\n"
                           "[cell]\nkind = \"shear\"\nshear_rate = 100\n");

  [[nodiscard]] json advice(const std::vector<std::string>& settings) const {
    std::vector<std::string> words = {"advise", file, "--model", model, "--json", "--quiet", "--threads", "1"};
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    const ProgramRun result = run(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.json();
  }

  [[nodiscard]] static double factor_of(const json& advice, const std::string& law, bool softer) {
    for (const json& entry : advice["laws"]) {
      const double factor = entry["factor"];
      if (entry["law"] == law && (softer ? factor < 1 : factor > 1)) return factor;
    }
    return 1;
  }
};

TEST_F(AdviseCommand, GivesEveryKey) {
  const json j = advice({});
  const std::set<std::string> expected = {"law", "factor", "engine", "expected_error", "speedup", "limiting_mechanism", "warnings"};
  EXPECT_THAT(keys_of(j), testing::IsSupersetOf(expected));
  ASSERT_FALSE(j["laws"].empty());
  for (const json& law : j["laws"]) {
    EXPECT_THAT(keys_of(law), testing::IsSupersetOf(expected));
    EXPECT_LE(law["expected_error"].get<double>() + law["expected_error_uncertainty"].get<double>(), 0.05 * (1 + 1e-9));
    EXPECT_LE(law["speedup"], j["speedup"].get<double>() * 1.011);
  }
  EXPECT_EQ(j["law"], "rps");
  EXPECT_LT(j["factor"], 1);
  EXPECT_EQ(j["limiting_mechanism"], "contact time");
  EXPECT_THAT(j["engine"].get<std::string>(), testing::AnyOf("dem", "hybrid"));
}

TEST_F(AdviseCommand, SofteningWithoutCorrectionIsLimitedByAdhesion) {
  const json j = advice({"study.laws=[\"none\"]", "advise.speed=0.1"});
  const json& softer = j["laws"][0];
  EXPECT_EQ(softer["limiting_mechanism"], "adhesion");
  EXPECT_GT(softer["factor"], factor_of(advice({"study.laws=[\"rps\"]", "advise.speed=0.1"}), "rps", true));
}

TEST_F(AdviseCommand, TighterToleranceIsMilder) {
  double last_soft = 0, last_large = 1e9;
  for (const char* tolerance : {"0.2", "0.1", "0.05", "0.01"}) {
    const json j = advice({std::string("advise.tolerance=") + tolerance});
    const double soft = factor_of(j, "rps", true), large = factor_of(j, "sup", false);
    EXPECT_GT(soft, last_soft);
    EXPECT_LE(large, last_large);
    last_soft = soft, last_large = large;
  }
}

TEST_F(AdviseCommand, SpeedupIsThatOfTheStep) {
  const json j = advice({"study.laws=[\"rps\"]"});
  EXPECT_NEAR(j["speedup"].get<double>() * std::sqrt(j["factor"].get<double>()), 1, 0.05);  // steps grow as factor^{−1/2}
}

TEST_F(AdviseCommand, TakesTheSceneFromItsKeys) {
  const json dense = advice({"advise.volume_fraction=0.5"}), dilute = advice({"advise.volume_fraction=0.1"});
  EXPECT_GT(factor_of(dense, "rps", true), factor_of(dilute, "rps", true));
  EXPECT_EQ(advice({"advise.volume_fraction=0.5"}), advice({"particles.volume_fraction=0.5", "advise.volume_fraction=0.5"}));
  const json slow = advice({"advise.shear_rate=10"}), fast = advice({"advise.shear_rate=1000"});
  EXPECT_LT(slow["original"]["impact_speed"], fast["original"]["impact_speed"]);
  EXPECT_NEAR(advice({"advise.speed=0.3"})["original"]["impact_speed"].get<double>(), std::sqrt(std::numbers::pi * 0.03), 1e-9);
}

TEST_F(AdviseCommand, ForecastsAStudy) {
  const ProgramRun result = run({"advise", file, "--model", model, "--forecast", "--set", "study.laws=[\"rps\"]", "--set",
                                 "study.factors=[1e-2, 1e-3]", "--out", folder / "forecast"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, testing::HasSubstr("rps at 0.01: granular temperature "));
  EXPECT_THAT(read_file(folder / "forecast/prediction.csv").value_or(""), testing::HasSubstr(",not_run,stress_xz,,,"));
}

TEST_F(AdviseCommand, TestsTheModelOnStudiesThatItHasNotSeen) {
  const std::string reference = SCALEBREAK_SOURCE "/data/reference/";
  const ProgramRun result =
      run({"advise", "--test", reference + "blind", reference + "blind_cohesive", "--json", "--out", folder / "test"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json all = result.json()["together"];  // docs/prediction.md
  EXPECT_EQ(all["rows"], 140);
  EXPECT_EQ(all["off"], 60);
  EXPECT_GE(all["within_factor_1_5"], 54);
  EXPECT_THAT(read_file(folder / "test/prediction.csv").value_or(""), testing::HasSubstr(",unseen,collision_rate,"));
  const ProgramRun other =
      run({"advise", "--test", reference + "blind", "--model", model, "--json"});  // one that was not fitted to anything
  EXPECT_LT(other.json()["together"]["softened_within_factor_1_5"], 15);
}

TEST_F(AdviseCommand, KnowsGasesThatCoolByTheory) {
  const std::string reference = SCALEBREAK_SOURCE "/data/reference/";
  const ProgramRun result = run({"advise", "--test", reference + "blind_cooling", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json all = result.json()["together"];  // docs/prediction.md
  EXPECT_EQ(all["rows"], 148);
  EXPECT_EQ(all["off"], 112);
  EXPECT_GE(all["within_factor_1_5"], 95);
  EXPECT_LT(all["rms_over_error"], 1);
}

TEST_F(AdviseCommand, UnderPressureSupGoesFarthestAndGasCools) {
  const std::vector<std::string> confined = {"cell.kind=confined_shear", "cell.shear_rate=6.32", "cell.pressure=1000",
                                             "material.surface_energy=0.1", "material.young=1e8"};
  const json j = advice(confined);
  EXPECT_GT(factor_of(j, "sup", false), 1.5 * factor_of(j, "bond", false));  // whose pull-off force grows as l³ where the load grows as l²
  EXPECT_GT(factor_of(j, "sup", false), 1.5 * factor_of(j, "chen_elliott", false));
  for (const json& law : j["laws"]) {
    if (law["law"] != "sup") continue;
    EXPECT_EQ(law["expected_error_of"], "stress_xz");
    EXPECT_THAT(law["keeps"].get<std::string>(), testing::StartsWith("keeps pull-off force over pressure"));
    EXPECT_EQ(law["limiting_mechanism"], "size");
  }
  EXPECT_THAT(j["warnings"].dump(), testing::HasSubstr("lasting contacts carry the pressure"));

  const json cooling = advice({"cell.kind=cooling", "cell.shear_rate=0", "run.duration=0.1", "material.surface_energy=0"});
  EXPECT_LT(factor_of(cooling, "none", false), 1.1);  // larger spheres cool later
  EXPECT_LT(factor_of(cooling, "rps", true), 0.1);
}

TEST_F(AdviseCommand, WarnsOutsideTheFit) {
  EXPECT_THAT(advice({"cell.kind=cooling", "cell.shear_rate=0", "run.duration=0.1"})["warnings"].dump(),
              testing::HasSubstr("nothing is sheared"));
}

TEST_F(AdviseCommand, RefusesWhatIsWrong) {
  const auto fails = [&](const std::vector<std::string>& words, const std::string& text) {
    const ProgramRun result = run(words);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err, testing::HasSubstr(text));
    EXPECT_EQ(result.out, "");
  };
  fails({"advise", file, "--model", model, "--set", "advise.tolerance=0"}, "advise.tolerance: found 0; allowed: ");
  fails({"advise", file, "--model", model, "--set", "advise.volume_fraction=0.9"}, "advise.volume_fraction: found 0.9");
  fails({"advise", file, "--model", folder / "missing.json"}, "missing.json cannot be read");
  fails({"advise", "--fit", folder / "nothing"}, "holds no finished study");
  fails({"advise", file, "--model", model, "--set", "cell.kind=cooling", "--set", "cell.shear_rate=0", "--set", "run.duration=0.1", "--set",
         "advise.shear_rate=3"},
        "advise.shear_rate: found 3, and cell.kind = \"cooling\" is not sheared");
}

}  // namespace
}  // namespace scalebreak::tests

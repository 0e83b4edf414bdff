#include <array>
#include <cmath>
#include <random>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <scalebreak/ensembles/breakdown/engine_agreement.hpp>
#include <scalebreak/ensembles/breakdown/run_study.hpp>
#include <scalebreak/ensembles/breakdown/study_files.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>
#include <scalebreak/statistics/pooled_mean.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Soft, small and short: a cell is milliseconds of work.
const std::string small_study = soft_glass + R"([particles]
count = 60
[cell]
kind = "shear"
shear_rate = 100
[run]
warmup_strain = 0.2
strain = 2
[study]
laws = ["rps", "sup"]
factors = [0.1, 2]
volume_fractions = [0.2, 0.4]
engines = ["dem"]
)";

StudyOptions options_of(const TemporaryFolder& folder, int threads) {
  return {.out = folder / "out", .threads = threads, .tables = {.folder = folder / "tables"}};
}

StudyResult study_of(const Input& input, const TemporaryFolder& folder, int threads = 1) {
  return run_study(input, study_grid(input), options_of(folder, threads));
}

/// What must not depend on how a study was run.
std::string numbers_of(StudyResult study) {
  for (CellResult& cell : study.cells) cell.wall_seconds = 0;
  return study_csv(study, "").text();
}

TEST(StudyGrid, HasTheOriginalAndEachLawAtItsFactorsAtEachPoint) {
  const StudyGrid grid = study_grid(resolved(small_study));
  std::vector<std::string> names;
  for (const StudyCell& cell : grid.cells) names.push_back(fmt::format("{} {:g} {:g}", cell.law, cell.factor, *cell.point.volume_fraction));
  EXPECT_THAT(names, ElementsAre("none 1 0.2", "rps 0.1 0.2", "sup 2 0.2", "none 1 0.4", "rps 0.1 0.4", "sup 2 0.4"));
  EXPECT_EQ(grid.skipped, 4);
  EXPECT_EQ(grid.original_of(2), 0u);
  EXPECT_EQ(grid.original_of(4), 3u);
  EXPECT_EQ(grid.cells[4].input.scaling_factor, 0.1);
  EXPECT_EQ(grid.cells[4].input.particles.volume_fraction, 0.4);
}

TEST(StudyGrid, KeepsACellsKeyInAnotherGrid) {
  const StudyGrid small = study_grid(resolved(small_study + "target_error = 0.1\n")),
                  large = study_grid(resolved(small_study, {"study.factors=[0.5, 0.1, 4, 2]"}));
  std::set<std::uint64_t> keys;
  for (const StudyCell& cell : large.cells) keys.insert(cell.key);
  EXPECT_EQ(keys.size(), large.cells.size());
  for (const StudyCell& cell : small.cells) EXPECT_EQ(keys.count(cell.key), 1u) << cell.folder();
}

TEST(StudyGrid, PutsAMaterialsValueWhereItHeldByDefault) {
  const std::string scene = small_study + "parameter = \"material.sliding_friction\"\nvalues = [0.5]\n";
  EXPECT_EQ(study_grid(resolved(scene)).cells[0].input.wall.material.sliding_friction, 0.5);
  const StudyGrid apart = study_grid(resolved(scene, {"wall.sliding_friction=10"}));
  EXPECT_EQ(apart.cells[0].input.material.sliding_friction, 0.5);
  EXPECT_EQ(apart.cells[0].input.wall.material.sliding_friction, 10);
}

TEST(StudyGrid, RefusesWhatIsNoStudy) {
  const auto refusal_of = [](const std::vector<std::string>& settings) {
    return message_of<InputError>([&] { (void)study_grid(resolved(small_study, settings)); });
  };
  EXPECT_THAT(refusal_of({"study.values=[1, 2]"}), HasSubstr("study.values is given without study.parameter"));
  EXPECT_THAT(refusal_of({"study.values=[1]", "study.parameter=\"material.weight\""}),
              HasSubstr("study.parameter: found \"material.weight\"; allowed"));
  EXPECT_THAT(refusal_of({"study.values=[1]", "study.parameter=\"scaling.factor\""}), HasSubstr("no part of the original scene"));
  EXPECT_THAT(refusal_of({"study.values=[-1]", "study.parameter=\"material.restitution\""}), HasSubstr("material.restitution"));
}

TEST(StudyQuantities, OfALawThatEnlargesAreClaimedWithTheirPowers) {
  EXPECT_EQ(study_quantity("rotational_energy").size_power, 3);  // I ω² / 2 with I ∝ l⁵, ω ∝ 1/l
  EXPECT_EQ(study_quantity("collision_rate").size_power, -1);    // a speed over a length
  EXPECT_EQ(study_quantity("pressure").size_power, 0);
}

TEST(Study, GivesTheSameNumbersOnAnyNumberOfThreadsAndAfterAnInterruption) {
  const TemporaryFolder one, two, cut;
  const Input input = resolved(small_study, {"run.replicas=2"});
  const std::string numbers = numbers_of(study_of(input, one, 1));
  EXPECT_TRUE(numbers_of(study_of(input, two, 2)) == numbers);
  StudyOptions options = options_of(cut, 1);
  options.stop = stop_after(1000);
  const StudyResult part = run_study(input, study_grid(input), options);
  EXPECT_FALSE(part.complete);
  std::size_t kept = 0;
  for (const auto& [name, content] : files_of(cut / "out")) kept += name.find("replica") != std::string::npos;
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, 12u);
  EXPECT_TRUE(numbers_of(study_of(input, cut, 1)) == numbers);
}

TEST(Study, RunsNoFinishedCellAgain) {
  const TemporaryFolder folder;
  const Input input = resolved(small_study);
  (void)study_of(input, folder);
  StudyOptions options = options_of(folder, 1);
  options.stop = [] { return true; };  // asked in every run
  EXPECT_TRUE(run_study(input, study_grid(input), options).complete);
}

TEST(Study, AddsRunsUntilTheErrorIsReached) {
  const TemporaryFolder few, more;
  const StudyResult start = study_of(resolved(small_study), few);
  double largest = 0;
  for (const CellResult& cell : start.cells) EXPECT_EQ(cell.replicas, 1u), largest = std::max(largest, relative_error(cell));
  const StudyResult end = study_of(resolved(small_study + "target_error = 0.1\nmost_replicas = 40\n"), more);
  for (const CellResult& cell : end.cells) {
    EXPECT_TRUE(relative_error(cell) <= 0.1 || cell.replicas == 40) << end.grid.cells[cell.cell].folder();
    EXPECT_TRUE(cell.replicas > 1 || relative_error(start.cells[cell.cell]) <= 0.1);
  }
}

TEST(Study, KeepsTheReasonOfARunThatFails) {
  const TemporaryFolder folder;
  // A step of half the Rayleigh time and no bounds: the flow explodes.
  const StudyResult study = study_of(
      resolved(small_study, {"run.step_fraction=1", "run.step_bounds=false", "particles.speed=3", "study.laws=[\"rps\"]"}), folder);
  for (const CellResult& cell : study.cells) {
    EXPECT_TRUE(cell.failed());
    EXPECT_THAT(cell.failure, HasSubstr("unstable"));
    EXPECT_EQ(cell_verdict(cell).standing, Standing::failed);
  }
}

TEST(Study, ComparesShearStressWhereThereIsShear) {
  for (const bool sheared : {true, false}) {
    Input input = resolved(small_study, {"study.volume_fractions=[0.2]"});
    if (!sheared)
      input.cell.kind = CellKind::cooling, input.cell.shear_rate = 0, input.run.strain = input.run.warmup_strain = 0,
      input.run.duration = 0.1;
    StudyResult study{.grid = study_grid(input), .cells = {}};
    for (std::size_t i = 0; i < study.grid.cells.size(); ++i) {
      study.cells.push_back({.cell = i, .replicas = 1});
      study.cells[i].quantities = {{"pressure", "Pa", {10, 0.1}}, {"stress_xz", "Pa", {0.001, 0.01}}};
    }
    compare_with_originals(study);
    EXPECT_NE(study.cells[1].deviation("pressure"), nullptr);
    EXPECT_EQ(study.cells[1].deviation("stress_xz") != nullptr, sheared);
  }
}

TEST(Study, ComparesWithWhatALawClaimsOfTheOriginal) {
  StudyResult study{.grid = study_grid(resolved(small_study, {"study.volume_fractions=[0.2]"})), .cells = {}};
  ASSERT_EQ(study.grid.cells[2].law, "sup");  // at 2
  for (std::size_t i = 0; i < study.grid.cells.size(); ++i) {
    study.cells.push_back({.cell = i, .replicas = 1});
    study.cells[i].quantities = {
        {"rotational_energy", "J", {10, 0.1}}, {"collision_rate", "1/s", {10, 0.1}}, {"pressure", "Pa", {10, 0.1}}};
  }
  compare_with_originals(study);
  EXPECT_TRUE(study.cells[0].deviations.empty());
  const auto deviation = [&](const char* name) { return study.cells[2].deviation(name)->relative; };
  EXPECT_NEAR(deviation("rotational_energy").value, 10.0 / (8 * 10) - 1, 1e-12);
  EXPECT_NEAR(deviation("collision_rate").value, 10.0 / (0.5 * 10) - 1, 1e-12);
  EXPECT_NEAR(deviation("pressure").value, 0, 1e-12);
  EXPECT_NEAR(deviation("pressure").error, std::hypot(0.01, 0.01), 1e-12);
  for (const Comparison& c : study.cells[1].deviations) EXPECT_NEAR(c.relative.value, 0, 1e-12);  // rps keeps all
}

/// A study whose two engines measured these temperatures in runs of each of its flows.
StudyResult study_of_engines(const std::vector<std::array<Measured, 2>>& flows, std::size_t runs) {
  StudyResult study{.grid = {}, .cells = {}};
  for (std::size_t i = 0; i < flows.size(); ++i) {
    for (const std::size_t engine : {0, 1}) {
      const char* name = engine == 0 ? "hybrid" : "dem";
      study.grid.cells.push_back({.law = "rps",
                                  .factor = 1 / (1.0 + static_cast<double>(i)),
                                  .asked = name,
                                  .choice = {.engine = name, .reason = ""},
                                  .input = {}});
      study.cells.push_back({.cell = 2 * i + engine, .replicas = runs});
      study.cells.back().quantities = {{"temperature", "m2/s2", flows[i][engine]}};
    }
  }
  return study;
}

TEST(EngineAgreement, AddsUpSquaredDifferencesOfTheSameFlows) {
  // One run each, whose errors are known: 2 and 1 standard errors apart.
  const auto agreements = engine_agreements(study_of_engines({{{{1, 0.03}, {1.1, 0.04}}}, {{{2, 0.3}, {1.5, 0.4}}}}, 1));
  ASSERT_EQ(agreements.size(), 1u);
  const EngineAgreement& hybrid_dem = agreements.front();
  EXPECT_EQ(hybrid_dem.first, "hybrid");
  EXPECT_EQ(hybrid_dem.second, "dem");
  ASSERT_EQ(hybrid_dem.quantities.size(), 1u);
  EXPECT_EQ(hybrid_dem.all.flows, 2);
  EXPECT_NEAR(hybrid_dem.all.squares, 5, 1e-12);
  EXPECT_NEAR(hybrid_dem.all.chance, std::exp(-5 / 2.0), 1e-12);  // χ² of two degrees of freedom
  EXPECT_NEAR(hybrid_dem.farthest->relative.value, 0.1, 1e-12);
  EXPECT_THAT(sentence(hybrid_dem), HasSubstr("hybrid and dem on 2 flows"));
  EXPECT_THAT(sentence(hybrid_dem), HasSubstr("least likely is granular temperature by +10.0 % ± 5.2 %"));
}

TEST(EngineAgreement, IsAChiSquareHoweverFewTheRuns) {
  // Two engines that do the same, four runs a flow: how often is noise rarer than one in ten, and one in a hundred?
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  int tenth = 0, hundredth = 0;
  constexpr int studies = 2000;
  for (int s = 0; s < studies; ++s) {
    std::vector<std::array<Measured, 2>> flows(12);
    for (auto& flow : flows) {
      for (Measured& mean : flow) {
        std::vector<Measured> runs(4);
        for (Measured& run : runs) run = {10 + noise(random), 0.5};
        mean = pooled_mean(runs);
      }
    }
    const double chance = engine_agreements(study_of_engines(flows, 4)).front().all.chance;
    tenth += chance < 0.1, hundredth += chance < 0.01;
  }
  EXPECT_NEAR(tenth, 0.1 * studies, 3 * std::sqrt(0.09 * studies));
  EXPECT_NEAR(hundredth, 0.01 * studies, 3 * std::sqrt(0.01 * studies));
}

TEST(EngineAgreement, IsOfNothingWhereOneEngineRunsAll) {
  const TemporaryFolder folder;
  EXPECT_TRUE(engine_agreements(study_of(resolved(small_study), folder)).empty());
}

Comparison off_by(const std::string& name, double relative, double error) {
  return {.name = name,
          .unit = "-",
          .first = {1, 0},
          .second = {1 + relative, error},
          .difference = {relative, error},
          .relative = {relative, error},
          .verdict = Verdict::unknown};
}

TEST(Verdicts, TellBrokenFromUncertain) {
  const auto standing = [](std::vector<Comparison> deviations) {
    CellResult cell{.replicas = 1};
    cell.deviations = std::move(deviations);
    return cell_verdict(cell);
  };
  EXPECT_EQ(standing({off_by("temperature", 0.03, 0.01), off_by("pressure", -0.02, 0.01)}).standing, Standing::holds);
  EXPECT_EQ(standing({off_by("temperature", 0.04, 0.01)}).standing, Standing::undecided);
  const CellVerdict broken = standing({off_by("temperature", 0.2, 0.2), off_by("collision_rate", -0.08, 0.01)});
  EXPECT_EQ(broken.standing, Standing::broken);
  EXPECT_EQ(broken.worst->name, "collision_rate");                                   // beyond, unlike the larger one
  EXPECT_EQ(standing({off_by("coordination", 5, 0.01)}).standing, Standing::holds);  // no claim
  EXPECT_EQ(standing({off_by("temperature", 0.001, std::nan(""))}).standing, Standing::undecided);
}

TEST(Verdicts, SayHowFarALawGoes) {
  const TemporaryFolder folder;
  Input input = resolved(small_study, {"study.laws=[\"rps\"]", "study.factors=[0.1, 0.5, 0.01]", "study.volume_fractions=[0.2]"});
  StudyResult study{.grid = study_grid(input), .cells = {}};
  for (std::size_t i = 0; i < study.grid.cells.size(); ++i) study.cells.push_back({.cell = i, .replicas = 1});
  study.cells[1].deviations = {off_by("temperature", 0.01, 0.001)};   // 0.1
  study.cells[2].deviations = {off_by("temperature", 0.0, 0.001)};    // 0.5
  study.cells[3].deviations = {off_by("temperature", 0.123, 0.004)};  // 0.01
  const auto reaches = law_reaches(study);
  ASSERT_EQ(reaches.size(), 1u);
  EXPECT_EQ(reaches[0].holds_to, 0.1);
  EXPECT_EQ(reaches[0].next, 0.01);
  EXPECT_EQ(sentence(reaches[0], ""),
            "rps (dem), volume fraction 0.2: holds to 0.1; at 0.01 granular temperature is off by +12.3 % ± 0.4 %");
}

}  // namespace
}  // namespace scalebreak::tests

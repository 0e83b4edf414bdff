#include <gmock/gmock.h>

#include <algorithm>

#include <scalebreak/collisions/papers/paper_case.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/toml_reader.hpp>

// What the papers say of their own cases, with the numbers that data/papers gives.

namespace scalebreak::tests {
namespace {

Input input_of(const std::string& name) { return resolve_input(read_toml_file(paper_case_file(find_paper_case(name)))); }
CaseResult run(const std::string& name, const Input& input) { return find_paper_case(name).run(input, {}); }

void expect_bars(const CaseResult& result, std::size_t count) {
  EXPECT_EQ(result.bars.size(), count);
  for (const CaseBar& bar : result.bars) EXPECT_TRUE(bar.holds()) << bar.statement << ": " << bar.value << " against " << bar.bar;
}

double number(const CaseResult& result, const std::string& curve, const std::string& name) {
  for (const CaseCurve& c : result.curves) {
    if (c.name != curve) continue;
    for (const CaseNumber& n : c.numbers) {
      if (n.name == name) return n.value.value();
    }
  }
  throw std::runtime_error("no number " + name + " of " + curve);
}

/// Washino et al. 2024, section 4. One motion takes a second, so that all is asked of the same ones.
struct ThreeSpheres : testing::TestWithParam<const char*> {};

TEST_P(ThreeSpheres, RpsGivesTheSameCurvesAndNoScalingOthers) {
  Input input = input_of(GetParam());
  input.study_factors = {1e-2, 1e-3};
  const CaseResult result = run(GetParam(), input);
  // Three curves under RPS, three without scaling, three statements on rolling resistance.
  expect_bars(result, 9);
  // What RPS still changes is the turning of the line of centres, and in proportion to it.
  const double own = number(result, "original", "line_of_centres_turned");
  for (const char* quantity : {"velocity_x_distance", "spin_z_distance"}) {
    const auto slope = [&](const char* curve) {
      return number(result, curve, quantity) / (number(result, curve, "line_of_centres_turned") - own);
    };
    EXPECT_NEAR(slope("rps, 0.001") / slope("rps, 0.01"), 1, 0.1) << quantity;
  }
  const double growth = std::pow(100, input.contact.normal == NormalModel::linear ? 0.5 : 0.4);
  EXPECT_NEAR(number(result, "rps, 0.01", "overlap_over_radius") / number(result, "original", "overlap_over_radius"), growth,
              1e-3 * growth);
}

/// What is softened until spheres are none any more is said to be lost, and the rest of the chart is there.
TEST_P(ThreeSpheres, AreChartedDownToWhereSpheresEnd) {
  Input input = input_of(GetParam());
  input.study_factors = {1e-1, 1e-6};
  const CaseResult result = run(GetParam(), input);
  EXPECT_GT(number(result, "rps, 1e-06", "overlap_over_radius"), 10 * number(result, "rps, 0.1", "overlap_over_radius"));
}

INSTANTIATE_TEST_SUITE_P(Washino, ThreeSpheres, testing::Values("w-case1", "w-case2", "w-case3"));

TEST(ChenElliott, UnlikeSpheresKeepTheirCollisionUnderThatLawAlone) {
  const CaseResult result = run("c-case-a", input_of("c-case-a"));
  expect_bars(result, 10);
  for (const char* law : {"bond, 2", "cohesion, 2"}) EXPECT_GT(number(result, law, "overlap_distance"), 0.5) << law;
}

TEST(ChenElliott, AnObliqueImpactIsKept) { expect_bars(run("c-case-b", input_of("c-case-b")), 10); }

TEST(ChenElliott, SpinFallsAsTheSizeGrows) {
  const CaseResult result = run("c-case-b", input_of("c-case-b"));
  EXPECT_NEAR(number(result, "chen_elliott, 4", "spin_after") * 4 / number(result, "original", "spin_after"), 1, 1e-9);
  EXPECT_GT(std::abs(number(result, "original", "spin_after")), 1e5);
}

TEST(ChenElliott, RestitutionAndContactTimeAreKeptAtAllSpeeds) {
  const CaseResult result = run("c-case-c", input_of("c-case-c"));
  expect_bars(result, 6);
  const double sticking = number(result, "original", "sticking_speed");
  EXPECT_TRUE(sticking > 1 && sticking < 2) << "at 1 m/s the latex sticks, at 2 m/s it does not";
}

TEST(GapRow, RpsWidensTheGapThatCountsAsOverlapsWiden) {
  Input input = input_of("gap-row");
  input.study_factors = {1e-2};
  const CaseResult result = run("gap-row", input);
  expect_bars(result, 2);  // Hertz and JKR
  EXPECT_NEAR(number(result, "hertz: rps, 0.01", "speed3_touching") / number(result, "hertz: original", "speed3_touching"), 1, 1e-6)
      << "touching spheres have no gap to map";
  EXPECT_GT(number(result, "hertz: original", "speed3_touching") - number(result, "hertz: instantaneous sequence", "speed3_touching"),
            0.01 * 0.01)
      << "three at once are no sequence of pairs";
}

TEST(GapRow, TheSequenceOfPairsIsThatOfTheRestitution) {
  // e = 0.81: B leaves at (1 + e)/2 and gives C the same share; A keeps (1 − e)/2, and catches B up.
  const CaseResult result = [] {
    Input input = input_of("gap-row");
    input.study_factors = {1e-1};
    input.material.surface_energy = input.second.surface_energy = 0;
    return run("gap-row", input);
  }();
  const double v = 0.01, gives = 0.905, keeps = 0.095;
  EXPECT_NEAR(number(result, "hertz: instantaneous sequence", "speed3_touching"), v * gives * gives, 1e-8);
  const double a = v * keeps, b = v * gives * keeps;
  EXPECT_NEAR(number(result, "hertz: instantaneous sequence", "speed1_touching"), keeps * a + gives * b, 1e-8);
  EXPECT_NEAR(number(result, "hertz: instantaneous sequence", "speed2_touching"), gives * a + keeps * b, 1e-8);
}

}  // namespace
}  // namespace scalebreak::tests

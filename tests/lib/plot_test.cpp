#include <scalebreak/output/plot.hpp>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>

#include <lib/surroundings.hpp>

namespace scalebreak {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using tests::content_of;
using tests::EnvironmentVariable;
using tests::TemporaryFolder;

namespace fs = std::filesystem;

Plot example() {
  return {.name = "restitution",
          .title = "Restitution",
          .x_label = "impact speed [m/s]",
          .y_label = "restitution [-]",
          .log_x = true,
          .curves = {{.file = "data.csv", .x = "1", .y = "2", .title = "original"},
                     {.file = "data.csv", .x = "1", .y = "3", .title = "overlap_kept, 2", .points = true, .style = 3, .only = "$1 > 0.2"}}};
}

/// The script that is kept, drawn with no gnuplot at hand.
std::string script_of(const Plot& plot) {
  const TemporaryFolder folder;
  const EnvironmentVariable nowhere("PATH", folder.path().c_str());
  (void)draw(plot, folder.path());
  return content_of(folder / (plot.name + ".gp"));
}

/// A folder to put on PATH, whose gnuplot is this shell script.
void put_gnuplot(const TemporaryFolder& folder, const std::string& script) {
  tests::put_file(folder / "gnuplot", "#!/bin/sh\n" + script);
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
}

void put_data(const TemporaryFolder& folder) {
  tests::put_file(folder / "data.csv", "speed [m/s],a [-],b [-]\n0.1,0.5,0.4\n0.5,0.7,0.6\n1,0.8,0.7\n");
}

bool gnuplot_is_there() { return std::system("gnuplot --version >/dev/null 2>&1") == 0; }

TEST(Plot, ScriptHasTitleAxesAndLegend) {
  const std::string script = script_of(example());
  EXPECT_THAT(script, ContainsRegex("set title [\"']Restitution[\"']"));
  EXPECT_THAT(script, HasSubstr("set xlabel 'impact speed [m/s]'\n"));
  EXPECT_THAT(script, HasSubstr("set ylabel 'restitution [-]'\n"));
  EXPECT_THAT(script, HasSubstr("set datafile separator ','\n"));
  EXPECT_THAT(script, HasSubstr("'data.csv' using 1:2 with lines"));
  EXPECT_THAT(script, ContainsRegex("title [\"']original[\"']"));
  EXPECT_THAT(script, HasSubstr("set output 'restitution.svg'\n"));
  EXPECT_THAT(script, HasSubstr("set output 'restitution.png'\n"));
}

TEST(Plot, ScriptHasLogarithmicAxesOnlyWhereAsked) {
  EXPECT_THAT(script_of(example()), testing::AllOf(HasSubstr("set logscale x\n"), Not(HasSubstr("set logscale y\n"))));
  Plot other = example();
  other.log_x = false, other.log_y = true;
  EXPECT_THAT(script_of(other), testing::AllOf(HasSubstr("set logscale y\n"), Not(HasSubstr("set logscale x\n"))));
}

TEST(Plot, ScriptDrawsErrorBars) {
  Plot plot = example();
  plot.curves[1].error = "4";
  EXPECT_THAT(script_of(plot), HasSubstr("'data.csv' using 1:($1 > 0.2 ? ($3) : NaN):4 with yerrorbars pt "));
}

TEST(Plot, ScriptDrawsMarksAndOnlyTheRowsAskedFor) {
  EXPECT_THAT(script_of(example()), HasSubstr("'data.csv' using 1:($1 > 0.2 ? ($3) : NaN) with points"));
  Plot plot = example();
  plot.curves[1].y = "($3/$2)";
  EXPECT_THAT(script_of(plot), HasSubstr("'data.csv' using 1:($1 > 0.2 ? (($3/$2)) : NaN) with points"));
}

TEST(Plot, UnderscoresInTheLegendAreNoIndices) { EXPECT_THAT(script_of(example()), HasSubstr(R"('overlap\_kept, 2')")); }

TEST(Plot, WithoutGnuplotTheScriptIsKept) {
  const TemporaryFolder folder, empty;
  {
    const EnvironmentVariable nowhere("PATH", empty.path().c_str());
    EXPECT_FALSE(draw(example(), folder.path()));
  }
  EXPECT_TRUE(fs::exists(folder / "restitution.gp"));
  EXPECT_FALSE(fs::exists(folder / "restitution.svg"));
}

TEST(Plot, AGnuplotThatFailsIsSaidAndItsWordsAreKept) {
  const TemporaryFolder folder, tools;
  put_gnuplot(tools, "echo 'no such terminal' >&2\nexit 1\n");
  const EnvironmentVariable path("PATH", tools.path().c_str());
  EXPECT_FALSE(draw(example(), folder.path()));
  EXPECT_EQ(content_of(folder / "restitution.log"), "no such terminal\n");
}

TEST(Plot, AFailureLeavesNoOlderDrawingOfTheSameName) {
  const TemporaryFolder folder, tools;
  put_gnuplot(tools, "exit 1\n");
  const EnvironmentVariable path("PATH", tools.path().c_str());
  for (const char* old : {"restitution.svg", "restitution.png"}) tests::put_file(folder / old, "of other data");
  EXPECT_FALSE(draw(example(), folder.path()));
  EXPECT_FALSE(fs::exists(folder / "restitution.svg") || fs::exists(folder / "restitution.png"));
}

TEST(Plot, GnuplotIsGivenTheScriptInItsFolderWhateverThatIsCalled) {
  const TemporaryFolder folder, tools;
  put_gnuplot(tools, "echo \"$PWD $*\" > called\nexit 0\n");
  const EnvironmentVariable path("PATH", tools.path().c_str());
  const fs::path odd = folder / "it's a $(folder) \"with\" spaces";
  EXPECT_TRUE(draw(example(), odd));
  EXPECT_EQ(content_of(odd / "called"), odd.string() + " restitution.gp\n");
  EXPECT_FALSE(fs::exists(odd / "restitution.log"));
}

TEST(Plot, GnuplotDrawsSvgAndPng) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not on PATH";
  const TemporaryFolder folder;
  put_data(folder);
  ASSERT_TRUE(draw(example(), folder.path()));
  const std::string svg = content_of(folder / "restitution.svg");
  EXPECT_THAT(svg, HasSubstr("<svg"));
  for (const char* text : {"Restitution", "impact speed [m/s]", "restitution [-]", "original", "overlap_kept, 2"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_THAT(content_of(folder / "restitution.png"), testing::StartsWith("\x89PNG"));
  EXPECT_FALSE(fs::exists(folder / "restitution.log"));
}

/// The range of the x axis as gnuplot draws it.
std::pair<double, double> drawn_range(const Plot& plot) {
  const TemporaryFolder folder;
  put_data(folder);
  EXPECT_TRUE(draw(plot, folder.path())) << content_of(folder / (plot.name + ".log"));
  tests::put_file(folder / "range.gp", content_of(folder / (plot.name + ".gp")) +
                                           "set print 'range.txt'\nprint sprintf('%.9g %.9g', GPVAL_X_MIN, GPVAL_X_MAX)\n");
  EXPECT_EQ(std::system(("cd " + folder.path().string() + " && gnuplot range.gp 2>/dev/null").c_str()), 0);
  std::istringstream text(content_of(folder / "range.txt"));
  std::pair<double, double> range;
  text >> range.first >> range.second;
  return range;
}

TEST(Plot, MarksStayOffTheFrameAndLinesFillIt) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not on PATH";
  Plot plot = example();
  plot.curves[1].only = "";
  const auto [low, high] = drawn_range(plot);  // from 0.1 to 1
  EXPECT_NEAR(low, 0.1 / std::pow(10, 0.04), 1e-6);
  EXPECT_NEAR(high, std::pow(10, 0.04), 1e-6);
  plot.log_x = false;
  EXPECT_NEAR(drawn_range(plot).first, 0.1 - 0.04 * 0.9, 1e-6);
  plot.curves.pop_back();
  EXPECT_NEAR(drawn_range(plot).first, 0.1, 1e-9);
}

TEST(Plot, GnuplotTakesTextsAsTheyStand) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not on PATH";
  const TemporaryFolder folder;
  put_data(folder);
  Plot plot = example();
  plot.title = "Force (contact_radius)";
  plot.curves[0].title = "the \"real\" one's";
  plot.curves[1].title = "a\\nb";
  EXPECT_TRUE(draw(plot, folder.path())) << content_of(folder / "restitution.log");
  const std::string svg = content_of(folder / "restitution.svg");
  for (const char* text : {"Force (contact_radius)", "the \"real\" one's", "a\\nb"}) EXPECT_THAT(svg, HasSubstr(text));
}

TEST(Plot, GnuplotRunsNoCommandsOutOfTexts) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not on PATH";
  for (const bool legend : {false, true}) {
    const TemporaryFolder folder;
    put_data(folder);
    Plot plot = example();
    (legend ? plot.curves[0].title : plot.title) = "`touch ran`";
    EXPECT_TRUE(draw(plot, folder.path()));
    EXPECT_FALSE(fs::exists(folder / "ran")) << (legend ? "from the legend" : "from the title");
  }
}

TEST(Plot, GnuplotThatReadsNoDataFails) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not on PATH";
  const TemporaryFolder folder;
  EXPECT_FALSE(draw(example(), folder.path()));
  EXPECT_TRUE(fs::exists(folder / "restitution.log"));
}

}  // namespace
}  // namespace scalebreak

#include <gmock/gmock.h>

#include <apps/collide.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

TEST_F(Collide, FilesOfAnObliquePair) {
  const ProgramRun result = run({"collide", std::string(SCALEBREAK_SOURCE) + "/data/scenes/oblique_glass.toml", "--out", out, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_file(out + "/result.json"), result.json());
  const std::string csv = content_of(out + "/trajectory.csv");
  EXPECT_THAT(csv, testing::StartsWith("time [s],overlap [m],normal_force [N],liquid_force [N],tangential_force [N],surface_speed [m/s],"
                                       "slides [-],rolls [-],velocity1_x [m/s],"));
  EXPECT_THAT(content_of(out + "/events.csv"), testing::StartsWith("time [s],first [-],second [-],change\n0,1,2,touch\n"));
  EXPECT_THAT(content_of(out + "/events.csv"), HasSubstr(",1,2,stick\n"));
  for (const char* plot : {"force_overlap", "tangential_force", "surface_speed", "energy"}) {
    EXPECT_THAT(content_of(out + "/" + plot + ".gp"), HasSubstr("trajectory.csv")) << plot;
    if (gnuplot_is_there()) {
      EXPECT_THAT(content_of(out + "/" + plot + ".png"), testing::StartsWith("\x89PNG")) << plot;
    }
  }
}

TEST_F(Collide, FilesOfAFewBodies) {
  const ProgramRun result = run({"collide", scene("bodies.toml", three_bodies), "--out", out, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(content_of(out + "/trajectory.csv"), testing::StartsWith("time [s],body [-],position_x [m],"));
  EXPECT_THAT(content_of(out + "/contacts.csv"), testing::StartsWith("time [s],first [-],second [-],overlap [m],normal_force [N],"));
  EXPECT_THAT(content_of(out + "/energy.csv"), testing::StartsWith("time [s],contacts [-],largest_overlap [m],kinetic_energy [J],"));
  EXPECT_THAT(content_of(out + "/events.csv"), HasSubstr(",2,3,touch\n"));
  for (const char* plot : {"speeds", "paths", "energy"}) {
    EXPECT_TRUE(fs::exists(out + "/" + plot + ".gp")) << plot;
    if (gnuplot_is_there()) {
      EXPECT_THAT(content_of(out + "/" + plot + ".png"), testing::StartsWith("\x89PNG")) << plot;
    }
  }
}

TEST_F(Collide, CheckEstimatesAFewBodies) {
  const ProgramRun result = run({"collide", scene("bodies.toml", three_bodies), "--check"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, HasSubstr("estimate: 3 bodies in space"));
}

TEST_F(Collide, FilesOfARun) {
  const ProgramRun result = run({"collide", "--out", out, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_file(out + "/result.json"), result.json());
  const std::string csv = content_of(out + "/trajectory.csv");
  const std::size_t line = csv.find('\n');
  EXPECT_EQ(csv.substr(0, line),
            "time [s],overlap [m],contact_radius [m],approach_speed [m/s],elastic_force [N],damping_force [N],force [N]");
  EXPECT_EQ(csv.substr(line + 1, 2), "0,") << "it starts at first touch";
  EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), 100);
  EXPECT_THAT(content_of(out + "/force_overlap.gp"), HasSubstr("trajectory.csv"));
  if (gnuplot_is_there()) {
    EXPECT_THAT(content_of(out + "/force_overlap.svg"), HasSubstr("<svg"));
    EXPECT_THAT(content_of(out + "/force_overlap.png"), testing::StartsWith("\x89PNG"));
  }
  for (const auto& entry : fs::directory_iterator(out)) EXPECT_NE(entry.path().extension(), ".part");
}

TEST_F(Collide, WithoutGnuplotItSaysSoAndKeepsTheRest) {
  const EnvironmentVariable nowhere("PATH", folder.path().c_str());
  const ProgramRun result = run({"collide", "--out", out});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "scalebreak: force_overlap was not drawn: gnuplot is missing or failed; its script is kept in " + out + "\n");
  EXPECT_TRUE(fs::exists(out + "/force_overlap.gp") && fs::exists(out + "/trajectory.csv") && fs::exists(out + "/result.json"));
  EXPECT_THAT(run({"collide", "--out", out, "--quiet"}).err, IsEmpty());
}

TEST_F(Collide, TheWrittenInputRunsAgainToTheSameBytes) {
  const std::string latex = "[material]\nname = \"latex\"\nrestitution = 0.7\n[scaling]\nlaw = \"rps\"\nfactor = 0.3\n";
  for (const std::string& file : {scene("bodies.toml", two_bodies), scene("pair.toml", latex)}) {
    ASSERT_EQ(run({"collide", file, "--out", out, "--set", "numerics.tolerance=1e-9"}).status, 0);
    const ProgramRun again = run({"collide", out + "/input.toml", "--out", out + "/again"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(content_of(out + "/result.json"), content_of(out + "/again/result.json"));
    EXPECT_EQ(content_of(out + "/input.toml"), content_of(out + "/again/input.toml"));
    EXPECT_EQ(content_of(out + "/trajectory.csv"), content_of(out + "/again/trajectory.csv"));
    const std::string head = "# scalebreak [0-9.]+ \\(commit [^\n]*run it again with: scalebreak collide input.toml\n";
    EXPECT_THAT(content_of(out + "/input.toml"), testing::MatchesRegex(head + "(.|\n)*"));
  }
}

TEST_F(Collide, NamedMaterialsOfTheSceneFilesWork) {
  for (const char* name : {"glass_pair", "latex_on_quartz", "oblique_glass", "wet_pair"}) {
    const ProgramRun result = run({"collide", std::string(SCALEBREAK_SOURCE) + "/data/scenes/" + name + ".toml", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_GT(result.json()["restitution_normal"].get<double>(), 0.5) << name;
  }
}

}  // namespace
}  // namespace scalebreak::tests

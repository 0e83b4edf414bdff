#include <csignal>

#include <gmock/gmock.h>

#include <apps/program.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;

struct BreakdownCommand : ProgramTest {
  std::string file = scene("study.toml",
                           "[material]\nyoung = 1e7\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\n"
                           "[particles]\ncount = 60\n[cell]\nkind = \"shear\"\nshear_rate = 100\n[run]\nwarmup_strain = 0.2\nstrain = 2\n"
                           "[study]\nlaws = [\"rps\"]\nfactors = [0.1]\nvolume_fractions = [0.2, 0.4]\nengines = [\"dem\"]\n");

  /// Without what a machine's speed has a part in.
  static json without_times(json j) {
    for (json& cell : j["cells"]) cell.erase("wall_seconds");
    return j;
  }
};

TEST_F(BreakdownCommand, GivesEveryKeyAndEveryFile) {
  const ProgramRun result = run({"breakdown", file, "--out", out, "--tables", tables, "--json", "--quiet"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json j = result.json();
  ASSERT_EQ(j["cells"].size(), 4u);
  const json& cell = j["cells"][1];
  EXPECT_EQ(cell["law"], "rps");
  EXPECT_EQ(cell["factor"], 0.1);
  EXPECT_EQ(cell["engine"], "dem");
  EXPECT_EQ(cell["volume_fraction"], 0.2);
  for (const char* name : {"temperature", "rotational_energy", "collision_rate", "pressure", "stress_xz"}) {
    const json& quantity = cell["quantities"][name];
    EXPECT_NEAR(quantity["deviation"].get<double>(), quantity["value"].get<double>() / quantity["claim"].get<double>() - 1, 1e-12) << name;
    EXPECT_EQ(quantity["claim"], j["cells"][0]["quantities"][name]["value"]) << name;
  }
  ASSERT_EQ(j["reaches"].size(), 2u);
  EXPECT_THAT(j["reaches"][0]["sentence"].get<std::string>(), HasSubstr("rps (dem), volume fraction 0.2"));
  EXPECT_EQ(j, json_file(std::filesystem::path(out) / "result.json"));
  for (const char* name :
       {"input.toml", "study.csv", "map_temperature.gp", "map_temperature.csv", "pressure_over_contacts.gp", "index.html"})
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / name)) << name;
  if (gnuplot_is_there()) {
    EXPECT_TRUE(std::filesystem::exists(out + "/map_temperature.svg"));
    EXPECT_THAT(content_of(out + "/index.html"), HasSubstr("<svg"));
  }
  EXPECT_EQ(without_times(run({"breakdown", out + "/input.toml", "--tables", tables, "--json", "--quiet"}).json()), without_times(j));
}

TEST_F(BreakdownCommand, GoesOnAfterItWasKilled) {
  const std::vector<std::string> command = {"breakdown", file,       "--set", "run.strain=10", "--set", "run.replicas=3", "--out",
                                            out,         "--tables", tables,  "--threads",     "1",     "--json",         "--quiet"};
  const ProgramRun killed = run(command, [&](pid_t process) {
    const auto finished = [&] {
      std::size_t count = 0;
      std::error_code failed;
      for (const auto& entry : std::filesystem::recursive_directory_iterator(out + "/cells", failed)) count += entry.is_regular_file();
      return count;
    };
    for (int wait = 0; wait < 2000 && finished() < 3; ++wait) usleep(2000);
    kill(process, SIGKILL);
  });
  EXPECT_EQ(killed.status, -1);
  EXPECT_FALSE(std::filesystem::exists(out + "/result.json"));
  const json whole = run(command).json();
  EXPECT_EQ(whole["complete"], true);
  const TemporaryFolder other;
  std::vector<std::string> anew = command;
  anew[7] = other / "out";
  EXPECT_EQ(without_times(run(anew).json()), without_times(whole));
}

TEST_F(BreakdownCommand, ChecksWithoutWorkingAndRefusesWhatIsNoStudy) {
  const ProgramRun checked = run({"breakdown", file, "--check", "--out", out});
  EXPECT_EQ(checked.status, 0);
  EXPECT_THAT(checked.out, HasSubstr("4 cells, 4 runs"));
  EXPECT_FALSE(std::filesystem::exists(out));
  const ProgramRun refused = run({"breakdown", file, "--set", "study.values=[1]", "--out", out});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("study.values is given without study.parameter"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(run({"breakdown", scene("pair.toml", "[impact]\nnormal_speed = 0.3\n")}).status, 2);
}

}  // namespace
}  // namespace scalebreak::tests

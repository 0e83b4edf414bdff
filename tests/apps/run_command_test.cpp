#include <signal.h>

#include <algorithm>

#include <gmock/gmock.h>

#include <apps/program.hpp>
#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsSupersetOf;

struct RunCommand : ProgramTest {
  std::string file = scene("shear.toml", small_shear);
};

const std::set<std::string> measured_keys = {
    "temperature",    "rotational_energy", "collision_rate", "coordination", "stress", "multi_contact_fraction",
    "stress_contact", "volume_fraction",   "dissipation",    "energy_drift"};

TEST_F(RunCommand, GivesEveryKeyAndEveryFile) {
  const ProgramRun result = run({"run", file, "--out", out, "--json", "--threads", "1", "--quiet"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json j = result.json();
  std::set<std::string> expected = {
      "engine",         "particles",         "time", "steps",      "events",    "wall_seconds", "particle_steps_per_second", "modelled",
      "patch_fraction", "events_per_second", "step", "step_bound", "step_limit"};
  for (const std::string& key : measured_keys) expected.insert({key, key + "_error"});
  EXPECT_THAT(keys_of(j), IsSupersetOf(expected));
  EXPECT_EQ(j["engine"], "dem");
  EXPECT_EQ(j["particles"], 200);
  EXPECT_NEAR(j["time"].get<double>(), 0.01, 1e-9);
  EXPECT_NEAR(j["measured_time"].get<double>(), 0.0075, 2e-4);
  EXPECT_NEAR(j["volume_fraction"].get<double>(), 0.3, 1e-12);
  EXPECT_NEAR(j["step"].get<double>() * j["steps"].get<double>(), 0.01, 1e-9);
  EXPECT_GT(j["temperature"].get<double>(), 0);
  EXPECT_GT(j["collision_rate"].get<double>(), 0);
  EXPECT_GT(j["dissipation"].get<double>(), 0);
  EXPECT_EQ(j, json_file(std::filesystem::path(out) / "result.json"));
  EXPECT_THAT(names_of(files_of(out)),
              IsSupersetOf({"input.toml", "result.json", "series.csv", "profiles.csv", "particles.xyz", "particles.dump", "particles.pvd",
                            "particles_000010.vtp", "particles_000010.csv", "temperature.gp", "stress.gp", "index.html"}));
  EXPECT_FALSE(std::filesystem::exists(out + "/checkpoint.bin"));
  EXPECT_TRUE(resolved(content_of(out + "/input.toml")) == resolved(small_shear));
  const std::string series = content_of(out + "/series.csv");
  EXPECT_EQ(std::count(series.begin(), series.end(), '\n'), 1 + 11);
}

TEST_F(RunCommand, GoesOnAfterASignalAsIfNothingHadHappened) {
  const std::vector<std::string> longer = {"--set", "run.strain=6", "--set", "output.formats=[\"xyz\"]", "--set", "output.interval=2e-3"};
  const auto arguments = [&](const std::string& folder_out) {
    std::vector<std::string> words = {"run", file, "--out", folder_out, "--threads", "1", "--quiet"};
    words.insert(words.end(), longer.begin(), longer.end());
    return words;
  };
  ASSERT_EQ(run(arguments(out)).status, 0);
  const std::string stopped = folder / "stopped";
  const ProgramRun killed = run(arguments(stopped), [&](pid_t process) {
    const auto rows = [&] {
      const std::string series = content_of(stopped + "/series.csv");
      return std::count(series.begin(), series.end(), '\n');
    };
    for (int wait = 0; wait < 20000 && rows() < 5; ++wait) usleep(1000);
    kill(process, SIGTERM);
  });
  EXPECT_EQ(killed.status, 1);
  EXPECT_THAT(killed.err,
              testing::MatchesRegex("scalebreak: the run was interrupted at [0-9.e-]+ s of 0.1525 s; its checkpoint is " + stopped +
                                    "/checkpoint.bin, and scalebreak run --resume --out " + stopped + " goes on from there\n"));
  EXPECT_EQ(killed.out, "");
  EXPECT_THAT(run({"compare", stopped, out}).err, HasSubstr("holds no finished run: it was interrupted, and run --resume goes on with it"));
  const ProgramRun resumed = run({"run", "--resume", "--out", stopped, "--quiet"});
  ASSERT_EQ(resumed.status, 0) << resumed.err;

  auto whole = files_of(out), parts = files_of(stopped);
  EXPECT_EQ(names_of(whole), names_of(parts));
  const auto without_wall_time = [](const std::string& text) {
    json j = json::parse(text);
    for (const char* key : {"wall_seconds", "particle_steps_per_second"}) j.erase(key);
    return j;
  };
  EXPECT_EQ(without_wall_time(whole.at("result.json")), without_wall_time(parts.at("result.json")));
  for (const char* file_with_wall_time : {"result.json", "index.html"}) whole.erase(file_with_wall_time);
  for (const auto& [name, content] : whole) {
    if (name.ends_with(".png") || name.ends_with(".svg")) continue;  // gnuplot's, of the same CSV
    EXPECT_TRUE(content == parts.at(name)) << name;
  }
}

TEST_F(RunCommand, SaysWhereTheContactTimeCameFromAndWhyThereIsNoDrift) {
  const json j = run({"run", file, "--tables", tables, "--json", "--quiet"}).json();
  EXPECT_EQ(j["contact_time_from"], "table");
  EXPECT_EQ(j["contact_time_of"], "[material] with [material]");
  EXPECT_EQ(j["collision_speed_of"], "speed at the start");
  EXPECT_TRUE(j["energy_drift"].is_null());
  EXPECT_THAT(j["energy_drift_missing"].get<std::string>(), HasSubstr("friction"));
  const json mapped =
      run({"run", file, "--set", "scaling.law=sup", "--set", "scaling.factor=2", "--tables", tables, "--json", "--quiet"}).json();
  EXPECT_EQ(mapped["contact_time_from"], "exact collision, as the direct-force law sup has no table");
  const json elastic = run({"run",      file,
                            "--set",    "contact.tangential=none",
                            "--set",    "contact.normal=hertz",
                            "--set",    "material.restitution=1",
                            "--set",    "cell.kind=cooling",
                            "--set",    "run.strain=0",
                            "--set",    "run.warmup_strain=0",
                            "--set",    "run.duration=0.01",
                            "--tables", tables,
                            "--json",   "--quiet"})
                           .json();
  EXPECT_TRUE(elastic["energy_drift_missing"].is_null()) << elastic["energy_drift_missing"];
  EXPECT_TRUE(elastic["energy_drift"].is_number());
}

TEST_F(RunCommand, RefusesInOneSentence) {
  const auto refused = [](const std::vector<std::string>& words) {
    const ProgramRun result = run(words);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_EQ(refused({"run", "--engine", "lammps"}),
            "scalebreak: --engine: lammps is not there yet; allowed: dem, event, hybrid, or auto\n");
  const std::string confined = scene("confined.toml", "[cell]\nkind = \"confined_shear\"\nshear_rate = 40\npressure = 100\n");
  for (const char* engine : {"event", "hybrid"})
    EXPECT_EQ(
        refused({"run", confined, "--engine", engine}),
        "scalebreak: cell.kind: found \"confined_shear\", whose height follows the stress of every step, which collisions as instants do "
        "not have; allowed in an event-driven or hybrid run: \"shear\", \"couette\", \"cooling\" or \"box\", or --engine dem, which "
        "integrates every contact\n");
  EXPECT_EQ(refused({"run", "--resume"}), "scalebreak: --resume: --out is missing; allowed: --out with the folder of an unfinished run\n");
  EXPECT_EQ(refused({"run", "--resume", "--out", out}),
            "scalebreak: --resume: " + out + " holds no checkpoint.bin; allowed: --out with the folder of an unfinished run\n");
  const std::string pair = scene("pair.toml", "[impact]\nnormal_speed = 0.3\n");
  EXPECT_EQ(refused({"run", pair}),
            "scalebreak: " + pair +
                ": [particles] and [cell] are missing, and this command runs flows; allowed: one of the two, or the "
                "command collide for a pair or bodies\n");
  EXPECT_THAT(refused({"run", "--engine", "magic"}), HasSubstr("magic"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(refused({"compare", out, out}), "scalebreak: " + out +
                                                " holds no finished run: there is no result.json; allowed: the --out folder of "
                                                "scalebreak run\n");
  EXPECT_EQ(refused({"compare", out}), "scalebreak: compare: found 1 folder; allowed: at least 2, each of a finished run\n");
  const std::string other = folder / "other";
  put_file(other + "/result.json", "{\"restitution_normal\": 0.8}");
  EXPECT_EQ(refused({"compare", other, other}),
            "scalebreak: " + other + "/result.json is not the result of a flow; allowed: the --out folder of scalebreak run\n");
}

TEST_F(RunCommand, CheckEstimatesAndWritesNothing) {
  const ProgramRun result = run({"run", file, "--check", "--out", out, "--threads", "1"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("# estimate: engine dem, 200 spheres, "));
  EXPECT_TRUE(resolved(result.out) == resolved(small_shear));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_THAT(run({"run", "--check"}).out, HasSubstr("kind = \"shear\""));
  const std::string confined = scene("confined.toml", "[cell]\nkind = \"confined_shear\"\nshear_rate = 40\npressure = 100\n");
  EXPECT_THAT(run({"run", confined, "--check"}).out, HasSubstr("# estimate: engine dem, 2000 spheres, "));
}

/// Soft spheres without adhesion, sheared long enough for errors.
constexpr const char* long_shear = R"(
[material]
young = 1e6
[contact]
normal = "hertz"
tangential = "mindlin"
[particles]
count = 200
speed = 0.04
[cell]
kind = "shear"
[run]
warmup_strain = 6
strain = 160
[output]
formats = []
)";

TEST_F(RunCommand, CompareSeesFrictionAndNoSeed) {
  const std::string shear = scene("long.toml", long_shear);
  const auto run_into = [&](const std::string& name, const std::string& setting) {
    const ProgramRun result = run({"run", shear, "--set", setting, "--out", folder / name, "--threads", "1", "--quiet"});
    EXPECT_EQ(result.status, 0) << result.err;
    return (folder / name).string();
  };
  const std::string first = run_into("first", "run.seed=1"), seed = run_into("seed", "run.seed=2"),
                    smooth = run_into("smooth", "material.sliding_friction=0.01");
  // In the steady state all the work of the shear is dissipated.
  const json steady = json_file(std::filesystem::path(first) / "result.json");
  EXPECT_NEAR(steady["dissipation"].get<double>(), -40 * steady["stress"][0][2].get<double>(), 0.03 * steady["dissipation"].get<double>());
  const ProgramRun result = run({"compare", first, seed, smooth, "--json", "--out", out, "--quiet"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json comparisons = result.json()["comparisons"];
  ASSERT_EQ(comparisons.size(), 2u);
  const auto verdict = [&](std::size_t pair, const std::string& quantity) {
    for (const json& q : comparisons[pair]["quantities"]) {
      if (q["quantity"] == quantity) return q["verdict"].get<std::string>();
    }
    return std::string("not there");
  };
  EXPECT_EQ(comparisons[0]["input_differences"], json::array({"run.seed: 1, 2"}));
  EXPECT_EQ(comparisons[1]["input_differences"], json::array({"material.sliding_friction: 0.3, 0.01", "wall.sliding_friction: 0.3, 0.01"}));
  // Two seeds differ by what chance allows: not by four standard errors, on any machine's bits.
  for (const json& q : comparisons[0]["quantities"]) {
    const std::string name = q["quantity"].get<std::string>();
    if (name != "temperature" && name != "collision_rate" && name != "stress_xz") continue;
    if (q["verdict"] == "unknown") continue;
    EXPECT_LT(std::abs(q["difference"].get<double>()), 4 * q["difference_error"].get<double>()) << name;
  }
  EXPECT_NE(verdict(0, "collision_rate"), "unknown");
  for (const char* quantity : {"collision_rate", "coordination"}) EXPECT_EQ(verdict(1, quantity), "difference") << quantity;
  EXPECT_THAT(names_of(files_of(out)),
              IsSupersetOf({"comparison.csv", "index.html", "profiles_1.csv", "profiles_3.csv", "profile_temperature.gp", "result.json"}));
  EXPECT_THAT(run({"compare", first, smooth}).out, HasSubstr("temperature differs by "));
}

}  // namespace
}  // namespace scalebreak::tests

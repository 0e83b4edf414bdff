#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <apps/program.hpp>

namespace scalebreak::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

struct Collide : ProgramTest {};

const std::set<std::string> result_keys = {"stuck",
                                           "restitution_normal",
                                           "restitution_tangential",
                                           "restitution_surface",
                                           "contact_time",
                                           "max_overlap",
                                           "max_force",
                                           "velocity1",
                                           "velocity2",
                                           "spin1",
                                           "spin2",
                                           "energy_before",
                                           "energy_after",
                                           "sticking_speed",
                                           "steps",
                                           "modelled"};

/// A collision with these settings, in JSON.
json collide(std::vector<std::string> settings) {
  std::vector<std::string> words = {"collide", "--json"};
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  const ProgramRun result = run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  return result.json();
}

double mass(double radius, double density = 2500) { return 4.0 / 3 * M_PI * radius * radius * radius * density; }

TEST_F(Collide, RunsAsItStands) {
  const ProgramRun result = run({"collide"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, HasSubstr("modelled: jkr, full, contact_radius"));
  EXPECT_THAT(result.out, HasSubstr("restitution"));
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(Collide, JsonIsOneObjectWithTheDocumentedKeys) {
  const ProgramRun result = run({"collide", "--json"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  const json j = result.json();
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["stuck"], false);
  EXPECT_TRUE(j["restitution_tangential"].is_null() && j["restitution_surface"].is_null()) << "there is no tangential speed to divide by";
  for (const char* key : {"velocity1", "velocity2", "spin1", "spin2"}) EXPECT_EQ(j[key].size(), 3u) << key;
  EXPECT_GT(j["steps"].get<int>(), 0);
  EXPECT_EQ(j["modelled"], "jkr, full, contact_radius");
}

TEST_F(Collide, TwoSpheresKeepMomentumAndLoseEnergyByTheRestitution) {
  const json j = collide({});
  const double e = j["restitution_normal"], v1 = j["velocity1"][2], v2 = j["velocity2"][2], m = mass(0.5e-3);
  EXPECT_GT(e, 0.7);
  EXPECT_LT(e, 0.81) << "adhesion takes its part";
  EXPECT_NEAR(v1 + v2, -0.1, 1e-15);
  EXPECT_NEAR(v1 - v2, 0.1 * e, 1e-15);
  EXPECT_NEAR(j["energy_before"].get<double>() / (m * 0.01 / 2), 1, 1e-12);
  EXPECT_NEAR(j["energy_after"].get<double>() / (m * (v1 * v1 + v2 * v2) / 2), 1, 1e-12);
}

TEST_F(Collide, APairBelowItsStickingSpeedSticks) {
  const json j = collide({"impact.normal_speed=1e-4"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["stuck"], true);
  EXPECT_EQ(j["restitution_normal"], 0);
  EXPECT_TRUE(j["contact_time"].is_null());
  EXPECT_GT(j["sticking_speed"].get<double>(), 1e-4);
  EXPECT_NEAR(j["velocity1"][2].get<double>(), -0.5e-4, 1e-18);
  EXPECT_EQ(j["velocity1"], j["velocity2"]) << "the common motion";
  EXPECT_NEAR(j["energy_after"].get<double>() / j["energy_before"].get<double>(), 0.5, 1e-12);
}

TEST_F(Collide, TheStickingSpeedDividesWhatSticksFromWhatDoesNot) {
  const double speed = collide({})["sticking_speed"];
  EXPECT_EQ(collide({fmt::format("impact.normal_speed={}", speed * (1 - 1e-6))})["stuck"], true);
  EXPECT_EQ(collide({fmt::format("impact.normal_speed={}", speed * (1 + 1e-6))})["stuck"], false);
}

TEST_F(Collide, WithoutAdhesionThereIsNoStickingSpeed) {
  const json hertz = collide({"contact.normal=hertz"});
  EXPECT_TRUE(hertz["sticking_speed"].is_null());
  EXPECT_EQ(hertz["modelled"], "hertz, touch, overlap");
  EXPECT_NEAR(hertz["restitution_normal"].get<double>(), 0.81, 1e-7);
  EXPECT_EQ(collide({"material.surface_energy=0"})["modelled"], "hertz, touch, overlap") << "JKR without surface energy is Hertz";
  EXPECT_NEAR(collide({"contact.normal=linear"})["restitution_normal"].get<double>(), 0.81, 1e-7);
}

TEST_F(Collide, WhereNothingCanStickTheStickingSpeedIsZero) {
  const json j = collide({"contact.adhesion_range=touch", "material.restitution=1"});
  EXPECT_EQ(j["sticking_speed"], 0);
  EXPECT_NEAR(j["restitution_normal"].get<double>(), 1, 1e-7);
}

TEST_F(Collide, ASphereComesBackFromAWallThatDoesNotMove) {
  const json j = collide({"pair.partner=wall", "pair.radius=[1e-3]", "wall.restitution=0.5", "contact.normal=hertz"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_NEAR(j["restitution_normal"].get<double>(), 0.5, 1e-7);
  EXPECT_NEAR(j["velocity1"][2].get<double>(), 0.05, 1e-8);
  EXPECT_EQ(j["velocity2"], (json{0.0, 0.0, 0.0}));
  EXPECT_NEAR(j["energy_before"].get<double>() / (mass(1e-3) * 0.01 / 2), 1, 1e-12);
}

TEST_F(Collide, AScalingLawIsApplied) {
  const json original = collide({});
  const json softer = collide({"scaling.law=rps", "scaling.factor=0.01"});
  const json larger = collide({"scaling.law=sup", "scaling.factor=4"});
  EXPECT_NEAR(softer["restitution_normal"].get<double>(), original["restitution_normal"].get<double>(), 1e-7);
  EXPECT_NEAR(larger["restitution_normal"].get<double>(), original["restitution_normal"].get<double>(), 1e-7);
  EXPECT_NEAR(larger["contact_time"].get<double>() / original["contact_time"].get<double>(), 4, 1e-6);
  EXPECT_NEAR(larger["energy_before"].get<double>() / original["energy_before"].get<double>(), 64, 1e-9);
}

constexpr const char* two_bodies = R"([contact]
normal = "hertz"
[material]
restitution = 0.5
[[body]]
position = [0, 0, 0.01]
velocity = [0, 0, -0.5]
radius = 1e-3
[[body]]
position = [0, 0, 0]
velocity = [0, 0, 0.25]
radius = 2e-3
)";

TEST_F(Collide, TwoBodiesFlyMeetAndPart) {
  const ProgramRun result = run({"collide", scene("bodies.toml", two_bodies), "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  for (const char* key : {"bodies", "contacts", "energy_before", "energy_after"}) EXPECT_TRUE(j.contains(key)) << key;
  for (const char* key : {"velocity1", "spin2"}) EXPECT_FALSE(j.contains(key)) << key;
  EXPECT_EQ(j["contacts"], 1);
  ASSERT_EQ(j["bodies"].size(), 2u);
  for (const json& body : j["bodies"]) EXPECT_EQ(keys_of(body), (std::set<std::string>{"position", "velocity", "spin"}));
  const double v1 = j["bodies"][0]["velocity"][2], v2 = j["bodies"][1]["velocity"][2];
  EXPECT_NEAR(v1 - v2, 0.5 * 0.75, 1e-7);
  EXPECT_NEAR(v1 + 8 * v2, -0.5 + 8 * 0.25, 1e-12);
  const double z1 = j["bodies"][0]["position"][2], z2 = j["bodies"][1]["position"][2];
  EXPECT_NEAR(z1 - z2, 3e-3, 1e-12) << "left at the end of the contact";
  const double flight = (0.01 - 0.003) / 0.75, time = flight + j["contact_time"].get<double>();
  EXPECT_NEAR((z1 + 8 * z2) / 9, 0.01 / 9 + time * 1.5 / 9, 1e-12) << "the centre of mass goes on";
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
  for (const char* name : {"glass_pair", "latex_on_quartz"}) {
    const ProgramRun result = run({"collide", std::string(SCALEBREAK_SOURCE) + "/data/scenes/" + name + ".toml", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_GT(result.json()["restitution_normal"].get<double>(), 0.5) << name;
  }
}

}  // namespace
}  // namespace scalebreak::tests

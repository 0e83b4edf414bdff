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
                                           "modelled",
                                           "energy_account",
                                           "momentum_before",
                                           "momentum_after",
                                           "angular_momentum_before",
                                           "angular_momentum_after",
                                           "contacts",
                                           "open_contacts",
                                           "ruptures",
                                           "slides",
                                           "rolls",
                                           "resting",
                                           "time",
                                           "first_touch",
                                           "last_separation",
                                           "turned"};

/// The sum of an account's terms.
double total(const json& account) {
  double sum = 0;
  for (const auto& [name, value] : account.items()) sum += value.get<double>();
  return sum;
}

void expect_balanced(const json& j, double tolerance) {
  const json& account = j["energy_account"];
  EXPECT_NEAR(total(account["after"]) / total(account["before"]), 1, tolerance);
  EXPECT_EQ(account["before"]["kinetic"], j["energy_before"]);
  EXPECT_NEAR(account["after"]["kinetic"].get<double>(), j["energy_after"].get<double>(), 1e-12 * j["energy_before"].get<double>());
}

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

TEST_F(Collide, AnObliquePairGivesAllThreeRestitutions) {
  const json j = collide({"impact.tangential_speed=0.15", "impact.spin1=[0,20,0]", "contact.tangential=mindlin", "contact.rolling=ar"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["modelled"], "jkr, full, contact_radius; mindlin on contact_radius, rolling ar, torque arm radius");
  const json v1 = j["velocity1"], v2 = j["velocity2"];
  const double along = v1[0].get<double>() - v2[0].get<double>(), turning = j["spin1"][1].get<double>() + j["spin2"][1].get<double>();
  EXPECT_NEAR(j["restitution_tangential"].get<double>(), along / 0.15, 1e-13);
  EXPECT_NEAR(j["restitution_surface"].get<double>(), -(along - 0.5e-3 * turning) / (0.15 - 0.5e-3 * 20), 1e-12);
  EXPECT_GT(j["contact_time"].get<double>(), 1e-6);
  EXPECT_EQ(j["contacts"], 1);
  EXPECT_GT(j["energy_account"]["after"]["friction"].get<double>(), 0);
  expect_balanced(j, 1e-7);
  for (const std::size_t k : {0, 1, 2}) EXPECT_NEAR(j["momentum_after"][k].get<double>(), j["momentum_before"][k].get<double>(), 1e-20);
}

TEST_F(Collide, ADivisorOfZeroGivesNull) {
  const json spun = collide({"impact.spin1=[0,20,0]", "contact.tangential=mindlin"});
  EXPECT_TRUE(spun["restitution_tangential"].is_null());
  EXPECT_TRUE(spun["restitution_surface"].is_number());
  const json matched =
      collide({"impact.spin1=[0,100,0]", "impact.spin2=[0,100,0]", "impact.tangential_speed=0.1", "contact.tangential=mindlin"});
  EXPECT_TRUE(matched["restitution_surface"].is_null()) << "the surfaces move together";
  EXPECT_TRUE(matched["restitution_tangential"].is_number());
}

TEST_F(Collide, AnObliquePairThatSticksTurnsAsOne) {
  const json j = collide({"impact.normal_speed=1e-4", "impact.tangential_speed=2e-4", "contact.tangential=mindlin"});
  EXPECT_EQ(j["stuck"], true);
  for (const char* key : {"restitution_normal", "restitution_tangential", "restitution_surface"}) EXPECT_EQ(j[key], 0) << key;
  EXPECT_TRUE(j["contact_time"].is_null());
  EXPECT_EQ(j["spin1"], j["spin2"]);
  EXPECT_GT(j["spin1"][1].get<double>(), 0);
  EXPECT_EQ(j["resting"], true);
  expect_balanced(j, 1e-6);
}

TEST_F(Collide, ASphereOnAWallWithFrictionTakesSpinFromIt) {
  const json j = collide({"pair.partner=wall", "pair.radius=[1e-3]", "impact.tangential_speed=0.3", "contact.tangential=mindlin",
                          "contact.normal=hertz", "wall.sliding_friction=0.05"});
  EXPECT_EQ(keys_of(j), result_keys);
  EXPECT_EQ(j["velocity2"], (json{0.0, 0.0, 0.0}));
  const double lost = 0.3 - j["velocity1"][0].get<double>();
  EXPECT_NEAR(j["spin1"][1].get<double>() / (2.5 * lost / 1e-3), 1, 1e-9) << "one impulse gives both";
  EXPECT_GT(lost / (0.05 * 0.1 * 1.81), 0.99);
  expect_balanced(j, 1e-7);
}

TEST_F(Collide, ALiquidHasNoStickingSpeedOfTheSolids) {
  const json j = collide({"contact.attraction=capillary+viscous", "impact.normal_speed=0.5"});
  EXPECT_TRUE(j["sticking_speed"].is_null());
  EXPECT_EQ(j["ruptures"], 1);
  EXPECT_GT(j["energy_account"]["after"]["liquid"].get<double>(), 0);
  EXPECT_GT(j["time"].get<double>(), 10 * j["contact_time"].get<double>()) << "the bridge outlives the contact";
  expect_balanced(j, 1e-7);
}

TEST_F(Collide, RemarksSayWhatHasNoEffectAndWhatIsTooDeep) {
  const ProgramRun idle = run({"collide", "--json", "--set", "impact.spin1=[0,0,5]"});
  EXPECT_EQ(idle.status, 0);
  EXPECT_EQ(idle.err, "scalebreak: spins are given, but no law acts on them: they stay as they are\n");
  EXPECT_EQ(idle.json()["spin1"], (json{0.0, 0.0, 5.0}));
  const ProgramRun deep = run({"collide", "--json", "--set", "material.young=1e6", "--set", "impact.normal_speed=1", "--set",
                               "impact.tangential_speed=1", "--set", "contact.tangential=mindlin"});
  EXPECT_EQ(deep.status, 0);
  EXPECT_EQ(deep.err, "scalebreak: the largest overlap exceeds a tenth of R*, more than the contact laws are meant for\n");
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

constexpr const char* three_bodies = R"([contact]
normal = "hertz"
tangential = "mindlin"
[[body]]
position = [-3e-3, 0, 0.3e-3]
velocity = [0.5, 0, 0]
spin = [0, 50, 0]
radius = 1e-3
[[body]]
position = [0, 0, 0]
radius = 1e-3
[[body]]
position = [2.1e-3, 0.5e-3, 0]
radius = 1e-3
)";

TEST_F(Collide, ThreeBodiesAreFollowedThroughAllTheirContacts) {
  const ProgramRun result = run({"collide", scene("bodies.toml", three_bodies), "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = result.json();
  for (const char* key : {"stuck", "restitution_normal", "sticking_speed", "contact_time", "velocity1"})
    EXPECT_FALSE(j.contains(key)) << key;
  ASSERT_EQ(j["bodies"].size(), 3u);
  EXPECT_EQ(j["contacts"], 2);
  EXPECT_EQ(j["open_contacts"], 0);
  EXPECT_GT(j["bodies"][2]["velocity"][0].get<double>(), 0.2) << "the last takes the blow";
  expect_balanced(j, 1e-7);
  for (const std::size_t k : {0, 1, 2})
    EXPECT_NEAR(j["momentum_after"][k].get<double>(), j["momentum_before"][k].get<double>(), 1e-12 * mass(1e-3) * 0.5);
}

TEST_F(Collide, ALawThatIsExactScalesAWholeSceneOfBodies) {
  const std::string file = scene("bodies.toml", three_bodies);
  const json original = run({"collide", file, "--json"}).json();
  const json larger = run({"collide", file, "--json", "--set", "scaling.law=torque_cubed", "--set", "scaling.factor=3"}).json();
  ASSERT_EQ(larger["bodies"].size(), 3u);
  EXPECT_NEAR(larger["time"].get<double>() / original["time"].get<double>(), 3, 1e-6);
  EXPECT_NEAR(larger["energy_before"].get<double>() / original["energy_before"].get<double>(), 27, 1e-9);
  // Equal masses: the centre of mass is the mean of the positions.
  const std::vector<double> centre = {-0.3e-3, 0.5e-3 / 3, 0.1e-3}, drift = {0.5 / 3, 0, 0};
  const double time = original["time"];
  for (const std::size_t b : {0, 1, 2}) {
    for (const std::size_t k : {0, 1, 2}) {
      const double at = original["bodies"][b]["position"][k].get<double>() - centre[k] - time * drift[k];
      const double scaled = larger["bodies"][b]["position"][k].get<double>() - centre[k] - 3 * time * drift[k];
      EXPECT_NEAR(scaled, 3 * at, 1e-9) << b << ' ' << k;
    }
    for (const std::size_t k : {0, 1, 2}) {
      EXPECT_NEAR(larger["bodies"][b]["velocity"][k].get<double>(), original["bodies"][b]["velocity"][k].get<double>(), 1e-7);
      EXPECT_NEAR(3 * larger["bodies"][b]["spin"][k].get<double>(), original["bodies"][b]["spin"][k].get<double>(), 1e-4);
    }
  }
  // A torque that grows with the square of the size alone does not.
  const json sup = run({"collide", file, "--json", "--set", "scaling.law=sup", "--set", "scaling.factor=3"}).json();
  EXPECT_GT(std::abs(3 * sup["bodies"][1]["spin"][1].get<double>() - original["bodies"][1]["spin"][1].get<double>()), 1);
}

TEST_F(Collide, BodiesThatNeverComeToAnEndNeedADuration) {
  // Undamped and without friction: it slides round and round the other, and swings in its adhesion for ever.
  const std::string file = scene("bound.toml", R"([material]
restitution = 1
[[body]]
position = [0, 0, 1e-3]
velocity = [1e-2, 0, -1e-4]
radius = 0.5e-3
[[body]]
position = [0, 0, 0]
radius = 0.5e-3
fixed = true
)");
  const ProgramRun endless = run({"collide", file, "--json", "--out", out});
  EXPECT_EQ(endless.status, 1);
  EXPECT_THAT(endless.out, IsEmpty());
  EXPECT_EQ(
      endless.err,
      "scalebreak: the motion has not ended after 50000 events of its contacts; give its [[body]] scene a run.duration (a [pair] can be written as one)\n");
  EXPECT_FALSE(fs::exists(out));
  const ProgramRun ended = run({"collide", file, "--json", "--set", "run.duration=1e-3"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.json()["open_contacts"], 1);
  EXPECT_EQ(ended.json()["resting"], false);
  EXPECT_NEAR(ended.json()["time"].get<double>(), 1e-3, 1e-12);
}

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

#include <scalebreak/scene/input_file.hpp>

#include <cmath>

#include <gmock/gmock.h>

#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>
#include <scalebreak/scene/keys.hpp>

namespace scalebreak {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::resolved;
using tests::sentence_for;

std::string body(const std::string& position, const std::string& velocity) {
  return "[[body]]\nposition = " + position + "\nvelocity = " + velocity + "\nradius = 1e-3\n";
}

TEST(InputFile, NothingGivenIsTheDefaults) { EXPECT_TRUE(resolved("") == Input{}); }

TEST(InputFile, ValuesReachTheInput) {
  const Input input = resolved(R"(
[material]
young = 2e9
restitution = 0.5
[contact]
normal = "jkr"
adhesion_range = "pull_off"
damping_on = "overlap"
[pair]
radius = [1e-3, 2e-3]
[impact]
normal_speed = 0.25
[scaling]
law = "rps"
factor = 0.01
[study]
laws = ["rps", "none"]
factors = [0.5]
speeds = [0.1, 0.2]
[numerics]
tolerance = 1e-10
table_tolerance = 1e-4
)");
  EXPECT_EQ(input.material.young, 2e9);
  EXPECT_EQ(input.material.restitution, 0.5);
  EXPECT_EQ(input.contact, (ContactKind{NormalModel::jkr, AdhesionRange::pull_off, DampingOn::overlap}));
  EXPECT_THAT(input.radius, ElementsAre(1e-3, 2e-3));
  EXPECT_EQ(input.normal_speed, 0.25);
  EXPECT_EQ(input.scaling_law, "rps");
  EXPECT_EQ(input.scaling_factor, 0.01);
  EXPECT_THAT(input.study_laws, ElementsAre("rps", "none"));
  EXPECT_THAT(input.study_factors, ElementsAre(0.5));
  EXPECT_THAT(input.study_speeds, ElementsAre(0.1, 0.2));
  EXPECT_EQ(input.tolerance, 1e-10);
  EXPECT_EQ(input.table_tolerance, 1e-4);
}

TEST(InputFile, BodiesReachTheInput) {
  const Input input = resolved(
      "[[body]]\nposition = [0, 0, 0.01]\nvelocity = [0, 0, -0.5]\nradius = 1e-3\n[[body]]\nposition = [0, 0, 0]\nradius = 2e-3\n");
  ASSERT_EQ(input.bodies.size(), 2u);
  EXPECT_EQ(input.bodies[0], (Body{.position = {0, 0, 0.01}, .velocity = {0, 0, -0.5}, .radius = 1e-3}));
  EXPECT_EQ(input.bodies[1], (Body{.position = {0, 0, 0}, .velocity = {0, 0, 0}, .radius = 2e-3, .second = true}));
}

TEST(InputFile, SurfacesSpinsAndBodiesReachTheInput) {
  const Input pair = resolved(R"(
[contact]
tangential = "mindlin"
tangential_radius = "overlap"
torque_arm = "contact"
rolling = "epsd2"
attraction = "capillary+viscous"
attraction_range = "contact"
[impact]
tangential_speed = 0.2
spin1 = [1, 2, 3]
spin2 = [-4, 5, -6]
)");
  EXPECT_EQ(pair.surface, (SurfaceKind{TangentialModel::mindlin, DampingOn::overlap, TorqueArm::contact, RollingModel::epsd2,
                                       Attraction::capillary_viscous, AttractionRange::contact}));
  EXPECT_EQ(pair.tangential_speed, 0.2);
  EXPECT_EQ(pair.spin1, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(pair.spin2, Eigen::Vector3d(-4, 5, -6));
  const Input few = resolved(R"(
[run]
duration = 0.5
[[body]]
position = [0, 0, 0]
radius = 1e-3
fixed = true
material = "second"
[[body]]
position = [0, 0, 0.01]
velocity = [0, 0, -1]
spin = [0, 7, 0]
radius = 1e-3
material = "material"
)");
  EXPECT_EQ(few.run.duration, 0.5);
  EXPECT_EQ(few.bodies[0], (Body{.radius = 1e-3, .fixed = true, .second = true}));
  EXPECT_EQ(few.bodies[1], (Body{.position = {0, 0, 0.01}, .velocity = {0, 0, -1}, .spin = {0, 7, 0}, .radius = 1e-3}));
}

TEST(InputFile, OnlyTheSecondOfTwoBodiesIsOfTheSecondMaterialByDefault) {
  const Input two = resolved(body("[0, 0, 0]", "[0, 0, 1]") + body("[0, 0, 0.01]", "[0, 0, 0]"), {"second.density=1000"});
  EXPECT_FALSE(two.bodies[0].second);
  EXPECT_TRUE(two.bodies[1].second);
  EXPECT_EQ(two.colliding().first.density, 2500);
  EXPECT_EQ(two.colliding().second.density, 1000);
  const Input three = resolved(body("[0, 0, 0]", "[0, 0, 1]") + body("[0, 0, 0.01]", "[0, 0, 0]") + body("[0, 0, 0.02]", "[0, 0, 0]"));
  for (const Body& item : three.bodies) EXPECT_FALSE(item.second);
  EXPECT_EQ(three.colliding().radius.size(), 2u);
}

TEST(InputFile, SecondAndWallDefaultToTheMaterial) {
  const Input input = resolved("[second]\nyoung = 3e9\n[wall]\nrestitution = 0.4\n[material]\nyoung = 2e9\ndensity = 1000\n");
  EXPECT_EQ(input.second, (Material{.young = 3e9, .density = 1000}));
  EXPECT_EQ(input.wall.material, (Material{.young = 2e9, .density = 1000, .restitution = 0.4}));
}

TEST(InputFile, SettingsOverrideTheFileAndLaterSettingsEarlierOnes) {
  const std::string file = "[material]\nyoung = 2e9\n[impact]\nnormal_speed = 0.5\n";
  const Input input = resolved(file, {"material.young=3e9", "material.young=4e9", "pair.radius=[1e-3,1e-3]"});
  EXPECT_EQ(input.material.young, 4e9);
  EXPECT_EQ(input.normal_speed, 0.5);
  EXPECT_THAT(input.radius, ElementsAre(1e-3, 1e-3));
}

TEST(InputFile, AWrongValueThatIsOverriddenDoesNoHarm) {
  EXPECT_EQ(resolved("[material]\nyoung = -1\n", {"material.young=3e9"}).material.young, 3e9);
  EXPECT_EQ(sentence_for("[material]\nyoung = 3e9\n", {"material.young=-1"}),
            "--set material.young=-1: material.young: found -1; allowed: a number of at least 100 and at most 1e+14");
}

TEST(InputFile, WritesWhatReadsBackTheSame) {
  const char* texts[] = {
      "",
      "[contact]\nnormal = \"linear\"\n[scaling]\nlaw = \"thakur\"\nfactor = 3\n",
      "[contact]\nnormal = \"hertz\"\ndamping_on = \"contact_radius\"\n",
      "[pair]\npartner = \"wall\"\n[wall]\nrigid = true\nattraction = false\nyoung = 123456.789\n",
      "[study]\nlaws = [\"rps\"]\nspeeds = [0.1, 0.30000000000000004]\n",
      "[[body]]\nposition = [0, 0, 0.1]\nvelocity = [0, 0, -0.3]\nradius = 1e-3\n[[body]]\nposition = [0, 0, 0]\nradius = 2e-3\n",
      "[contact]\nnormal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"ar\"\n[impact]\ntangential_speed = 0.1\nspin1 = [0, 1e-3, 7]\n",
      "[contact]\nattraction = \"viscous\"\n[material]\nliquid_fraction = 0.03\nseparation_min = 1e-7\n[second]\nliquid_volume = 1e-13\n"
      "separation_min_ratio = 0.01\n[wall]\nseparation_min = 2e-7\n",
      "[cell]\nkind = \"shear\"\n",
      "[cell]\nkind = \"shear\"\nsize = [0.01, 0.02, 0.03]\n[particles]\ncount = 500\n[run]\nduration = 0.25\nwarmup_duration = 0\n",
      "[cell]\nkind = \"couette\"\nwall_no_slip = true\nwall_speed = 2\nsize = [0.1, 0.01, 0.1]\ngravity = [0, 0, -1.5]\n[particles]\n"
      "volume_fraction = 0.1\nsize = \"gaussian\"\nsize_spread = 0.05\n[scaling]\nlaw = \"sup\"\nfactor = 2\n[run]\nseed = 7\n"
      "replicas = 3\nstep_fraction = 0.2\nintegrator = \"synchronized\"\n",
      "[particles]\nsize = \"bidisperse\"\nlarge_radius = 1e-3\nlarge_mass_fraction = 0.25\n[second]\nyoung = 1e9\n[cell]\nkind = \"box\"\n"
      "boundary = [\"open\", \"periodic\", \"wall\"]\n[output]\nformats = []\nfields = [\"spin\"]\ninterval = 0.01\n",
      "[cell]\nkind = \"cooling\"\n[scaling]\nfactor = 3\nkeep = \"cell\"\n[contact]\nrolling = \"sds\"\n",
      "[run]\nduration = 0.3\n[[body]]\nposition = [0, 0, 0.1]\nspin = [1, 2, 3]\nradius = 1e-3\nmaterial = \"second\"\n[[body]]\n"
      "position = [0, 0, 0]\nvelocity = [0, 0, 0.1]\nradius = 2e-3\n[[body]]\nposition = [1, 0, 0]\nradius = 2e-3\nfixed = true\n",
  };
  for (const char* text : texts) {
    const Input input = resolved(text);
    EXPECT_TRUE(resolved(write_input(input)) == input) << write_input(input);
  }
  EXPECT_FALSE(resolved(texts[1]) == resolved(texts[2]));
}

TEST(InputFile, WritesTheLargestStudyOfTheMostBodiesSoThatItReadsBack) {
  Input input;
  input.bodies.assign(50, Body{.velocity = {0.1, 0.2, 0.3}, .spin = {0.1, 0.2, 0.3}, .radius = 0.0123});
  for (std::size_t i = 0; i < 50; ++i) input.bodies[i].position = {0.25 * static_cast<double>(i), 0.1, 0.2};
  input.bodies[0].velocity = {1.5, 0.2, 0.3};
  input.study_factors.assign(1000, 1.2345678901234567);
  input.study_speeds.assign(1000, 0.12345678901234567);
  EXPECT_TRUE(resolved(write_input(input)) == input);
}

TEST(InputFile, WritesTheSectionsOfItsSceneOnly) {
  const std::string pair = write_input(Input{}), flow = write_input(resolved("[cell]\nkind = \"shear\"\n"));
  for (const char* text : {"[particles]", "[cell]", "[output]", "[run]", "keep"}) {
    EXPECT_THAT(pair, testing::Not(HasSubstr(text)));
    EXPECT_THAT(flow, HasSubstr(text));
  }
  for (const char* text : {"[pair]", "[impact]", "[second]"}) {
    EXPECT_THAT(pair, HasSubstr(text));
    EXPECT_THAT(flow, testing::Not(HasSubstr(text)));
  }
}

TEST(InputFile, AFileOfParticlesReadsBackTheSame) {
  const tests::TemporaryFolder folder;
  tests::put_file(folder / "start.xyz", "0\n");
  const Input input = resolved("[particles]\nfile = \"" + (folder / "start.xyz").string() + "\"\n[second]\nyoung = 1e9\n");
  EXPECT_TRUE(resolved(write_input(input)) == input) << write_input(input);
}

TEST(InputFile, DescribesEveryKeyAsTomlOfTheDefaults) {
  const std::string text = describe_keys();
  EXPECT_TRUE(resolved(text) == Input{});
  for (const Key& key : keys()) {
    EXPECT_THAT(text, HasSubstr(key.meaning + "; allowed: " + key.allowed)) << key.dotted();
    EXPECT_THAT(text, HasSubstr("[" + key.unit + "]")) << key.dotted();
  }
  for (const Key& key : body_keys(0)) EXPECT_THAT(text, HasSubstr(key.meaning + "; allowed: " + key.allowed)) << key.dotted();
}

TEST(InputFile, DescribesTheKeysOfAFlowAsItsDefaultsInComments) {
  std::string text = describe_keys(), flow;
  text.erase(0, text.find("# [particles]\n"));
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) flow += text.substr(at + 2, text.find('\n', at) - at - 1);
  EXPECT_TRUE(resolved(flow) == resolved("[cell]\nkind = \"shear\"\n")) << flow;
}

}  // namespace
}  // namespace scalebreak

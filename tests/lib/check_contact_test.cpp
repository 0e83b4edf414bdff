#include <scalebreak/scene/check_contact.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <lib/resolving.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using tests::resolved;
using tests::sentence_for;

TEST(CheckContact, AdhesionRangeNeedsAdhesion) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"hertz\"\nadhesion_range = \"full\"\n"),
            "scene.toml, line 3: contact.adhesion_range = \"full\" needs adhesion, and contact.normal = \"hertz\" has none; allowed: "
            "\"touch\", or normal = \"jkr\"");
  EXPECT_EQ(sentence_for("[contact]\nadhesion_range = \"pull_off\"\n", {"contact.normal=hertz"}),
            "scene.toml, line 2: contact.adhesion_range = \"pull_off\" needs adhesion, and contact.normal = \"hertz\" has none; allowed: "
            "\"touch\", or normal = \"jkr\"");
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"linear\"\n", {"contact.adhesion_range=pull_off"}),
            "--set contact.adhesion_range=pull_off: contact.adhesion_range = \"pull_off\" needs adhesion, and contact.normal = \"linear\" "
            "has none; allowed: \"touch\", or normal = \"jkr\"");
}

TEST(CheckContact, ALinearContactHasNoContactRadius) {
  EXPECT_EQ(sentence_for("[contact]\nnormal = \"linear\"\ndamping_on = \"contact_radius\"\n"),
            "scene.toml, line 3: contact.damping_on = \"contact_radius\" needs a contact radius, and contact.normal = \"linear\" has none; "
            "allowed: \"overlap\", or normal = \"hertz\" or \"jkr\"");
}

TEST(CheckContact, RangeAndDashpotFollowTheNormalLaw) {
  const ContactKind hertz{NormalModel::hertz, AdhesionRange::touch, DampingOn::overlap};
  EXPECT_EQ(resolved("[contact]\nnormal = \"hertz\"\n").contact, hertz);
  EXPECT_EQ(resolved("[contact]\nnormal = \"hertz\"\nadhesion_range = \"touch\"\ndamping_on = \"contact_radius\"\n").contact, hertz);
  EXPECT_EQ(resolved("[contact]\nnormal = \"linear\"\ndamping_on = \"overlap\"\n").contact,
            (ContactKind{NormalModel::linear, AdhesionRange::touch, DampingOn::overlap}));
  EXPECT_EQ(resolved("[contact]\nadhesion_range = \"touch\"\n").contact,
            (ContactKind{NormalModel::jkr, AdhesionRange::touch, DampingOn::contact_radius}));
}

TEST(CheckContact, MindlinsSpringOfALinearContactHasNoContactRadius) {
  const std::string sentence =
      "scene.toml, line 4: contact.tangential_radius = \"contact_radius\" needs a contact radius, and contact.normal = \"linear\" has "
      "none; allowed: \"overlap\", or normal = \"hertz\" or \"jkr\"";
  const std::string linear = "[contact]\nnormal = \"linear\"\ntangential = \"mindlin\"\n";
  EXPECT_EQ(sentence_for(linear + "tangential_radius = \"contact_radius\"\n"), sentence);
  EXPECT_EQ(resolved(linear).surface.tangential_radius, DampingOn::overlap);
  EXPECT_EQ(resolved(linear + "tangential_radius = \"overlap\"\n").surface.tangential_radius, DampingOn::overlap);
}

TEST(CheckContact, TangentialRadiusIsAChoiceOfJkrAlone) {
  const auto radius = [](const char* normal) {
    return resolved(fmt::format("[contact]\nnormal = \"{}\"\ntangential_radius = \"contact_radius\"\n", normal)).surface.tangential_radius;
  };
  EXPECT_EQ(radius("jkr"), DampingOn::contact_radius);
  EXPECT_EQ(radius("hertz"), DampingOn::overlap);
  EXPECT_EQ(radius("linear"), DampingOn::overlap) << "nothing works on it";
}

TEST(CheckContact, AdhesiveRollingNeedsAContactRadiusAndAdhesion) {
  EXPECT_EQ(
      sentence_for("[contact]\nnormal = \"linear\"\nrolling = \"ar\"\n"),
      "scene.toml, line 3: contact.rolling = \"ar\" needs a contact radius, and contact.normal = \"linear\" has none; allowed: rolling "
      "= \"none\", \"cdt\", \"epsd\", \"epsd2\" or \"sds\", or normal = \"hertz\" or \"jkr\"");
  EXPECT_EQ(
      sentence_for("[contact]\nrolling = \"ar\"\n[material]\nsurface_energy = 0\n"),
      "scene.toml, line 2: contact.rolling = \"ar\" needs adhesion, and the surface_energy between the two spheres is 0; allowed: above "
      "0, or rolling = \"none\", \"cdt\", \"epsd\", \"epsd2\" or \"sds\"");
  EXPECT_EQ(sentence_for("[pair]\npartner = \"wall\"\n[wall]\nattraction = false\n", {"contact.rolling=ar"}),
            "--set contact.rolling=ar: contact.rolling = \"ar\" needs adhesion, and the surface_energy between the sphere and a wall with "
            "attraction = false is 0; allowed: above 0, or rolling = \"none\", \"cdt\", \"epsd\", \"epsd2\" or \"sds\"");
  EXPECT_EQ(resolved("[contact]\nnormal = \"hertz\"\nrolling = \"ar\"\n").surface.rolling, RollingModel::ar);
  EXPECT_EQ(resolved("[contact]\nrolling = \"ar\"\n[second]\nsurface_energy = 0\n").surface.rolling, RollingModel::ar);
}

TEST(CheckLiquid, CapillaryForceNeedsSurfaceTensionAndViscousForceViscosity) {
  EXPECT_EQ(
      sentence_for("[contact]\nattraction = \"capillary\"\n[material]\nsurface_tension = 0\n"),
      "scene.toml, line 2: contact.attraction = \"capillary\" needs surface tension, and the surface_tension between the two spheres is "
      "0; allowed: above 0, or attraction = \"none\"");
  EXPECT_EQ(
      sentence_for("[contact]\nattraction = \"capillary+viscous\"\n[material]\nviscosity = 0\n"),
      "scene.toml, line 2: contact.attraction = \"capillary+viscous\" needs viscosity, and the viscosity between the two spheres is 0; "
      "allowed: above 0, or attraction = \"none\"");
  EXPECT_EQ(resolved("[contact]\nattraction = \"capillary\"\n[material]\nviscosity = 0\n").surface.attraction, Attraction::capillary);
  EXPECT_EQ(resolved("[contact]\nattraction = \"viscous\"\n[material]\nsurface_tension = 0\n").surface.attraction, Attraction::viscous);
  EXPECT_EQ(resolved("[material]\nsurface_tension = 0\nviscosity = 0\nliquid_volume = 0\n").surface.attraction, Attraction::none);
}

TEST(CheckLiquid, CapillaryForceAndBridgesNeedLiquid) {
  const std::string dry = "[material]\nliquid_volume = 0\n";
  EXPECT_EQ(sentence_for(dry + "[contact]\nattraction = \"capillary\"\nattraction_range = \"contact\"\n"),
            "scene.toml, line 4: contact.attraction = \"capillary\" needs liquid, and its volume between the two spheres is 0; allowed: a "
            "liquid_volume or liquid_fraction above 0, or attraction = \"none\"");
  EXPECT_EQ(
      sentence_for(dry + "[contact]\nattraction = \"viscous\"\n"),
      "scene.toml, line 4: contact.attraction_range = \"bridge\" needs liquid, and its volume between the two spheres is 0; allowed: a "
      "liquid_volume or liquid_fraction above 0, or attraction_range = \"contact\"");
  EXPECT_EQ(resolved(dry + "[contact]\nattraction = \"viscous\"\nattraction_range = \"contact\"\n").surface.attraction,
            Attraction::viscous);
  EXPECT_EQ(resolved("[material]\nliquid_fraction = 0.01\n[contact]\nattraction = \"capillary\"\n").surface.attraction,
            Attraction::capillary);
}

TEST(CheckLiquid, ABridgeRupturesBelowTheSmallestRadius) {
  const std::string wet = "[contact]\nattraction = \"capillary\"\n[material]\nliquid_volume = 1e-12\ncontact_angle = 0.5\n";
  EXPECT_EQ(sentence_for(wet + "[pair]\nradius = [1e-3, 1.25e-4]\n"),
            "scene.toml, line 2: contact.attraction_range = \"bridge\" needs small bridges, and that of 1e-12 m3 between the two spheres "
            "ruptures at 0.000125 m, which is not below the radius of 0.000125 m; allowed: less liquid, or attraction_range = \"contact\"");
  EXPECT_EQ(resolved(wet + "[pair]\nradius = [1e-3, 1.26e-4]\n").radius[1], 1.26e-4);
  EXPECT_EQ(resolved(wet + "[pair]\nradius = [1e-3, 1e-4]\n", {"contact.attraction_range=contact"}).radius[1], 1e-4);
  EXPECT_EQ(resolved(wet + "[pair]\nradius = [1e-3, 1e-4]\n", {"contact.attraction=none"}).radius[1], 1e-4);
  EXPECT_THAT(sentence_for(wet + "[pair]\npartner = \"wall\"\nradius = [1e-4]\n"), HasSubstr("between the sphere and the wall ruptures"));
}

TEST(CheckLiquid, EveryPairOfBodiesThatCanMeetIsLookedAt) {
  const auto body = [](int place, const char* more) {
    return fmt::format("[[body]]\nposition = [{}, 0, 0]\nvelocity = [{}, 0, 0]\nradius = 1e-3\n{}", place, -place, more);
  };
  const std::string wet = "[contact]\nattraction = \"viscous\"\n[second]\nliquid_volume = 0\n";
  EXPECT_THAT(sentence_for(wet + body(0, "") + body(1, "material = \"second\"\n") + body(2, "material = \"second\"\n")),
              HasSubstr("its volume between body.2 and body.3 is 0"));
  EXPECT_EQ(
      resolved(wet + body(0, "") + body(1, "material = \"second\"\nfixed = true\n") + body(2, "material = \"second\"\nfixed = true\n"))
          .bodies.size(),
      3u);
}

}  // namespace
}  // namespace scalebreak

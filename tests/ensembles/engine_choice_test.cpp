#include <gtest/gtest.h>

#include <lib/resolving.hpp>
#include <scalebreak/ensembles/run/engine_choice.hpp>

namespace scalebreak::tests {
namespace {

/// Washino's spheres in homogeneous shear: JKR, adhesive rolling, a spread of sizes.
EngineChoice choice(const std::vector<std::string>& settings) {
  std::vector<std::string> all = {"contact.normal=jkr",
                                  "contact.tangential=mindlin",
                                  "contact.rolling=ar",
                                  "particles.size=gaussian",
                                  "particles.size_spread=0.05",
                                  "particles.count=1000",
                                  "particles.volume_fraction=0.1",
                                  "particles.speed=0.04",
                                  "cell.kind=shear",
                                  "cell.shear_rate=40",
                                  "run.strain=40"};
  all.insert(all.end(), settings.begin(), settings.end());
  return choose_engine("auto", resolved("", all), 1, 0);
}

TEST(EngineChoice, OfStiffSpheresOfAnySizesIsTheHybrid) {
  EXPECT_EQ(choice({}).engine, "hybrid");
  EXPECT_EQ(choice({"particles.size=lognormal", "particles.size_spread=0.3"}).engine, "hybrid");
  EXPECT_EQ(choice({"material.young=1e5"}).engine, "dem");
}

TEST(EngineChoice, IsSoftSpheresWhereNoTableServes) {
  const auto reason = [](const std::vector<std::string>& settings) {
    const EngineChoice chosen = choice(settings);
    EXPECT_EQ(chosen.engine, "dem");
    return chosen.reason;
  };
  EXPECT_EQ(reason({"contact.torque_arm=contact"}),
            "no collision table serves: torque arms that end at the contact are other ones for every two radii");
  EXPECT_EQ(reason({"contact.tangential=linear"}),
            "no collision table serves: a linear tangential spring beside adhesion is another one at every size");
  EXPECT_EQ(reason({"contact.rolling=sds"}),
            "no collision table serves: the rolling spring of \"sds\" is another one at every size and speed");
  EXPECT_EQ(choice({"contact.torque_arm=contact", "particles.size=mono", "particles.size_spread=0"}).engine, "hybrid");
}

}  // namespace
}  // namespace scalebreak::tests

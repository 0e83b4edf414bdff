#include <cmath>
#include <list>

#include <gmock/gmock.h>

#include <scalebreak/ensembles/engine/energy_account.hpp>
#include <scalebreak/ensembles/run/flow_run.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

using testing::HasSubstr;
using testing::Optional;

/// A dense gas that keeps its energy, but for the step.
const std::string elastic = R"(
[material]
young = 1e7
restitution = 1
[contact]
normal = "hertz"
[particles]
count = 200
volume_fraction = 0.3
speed = 0.3
[cell]
kind = "cooling"
[run]
duration = 0.02
step_fraction = 0.3
[output]
interval = 1e-3
)";

double energy_of(const FlowInstant& instant) {
  double energy = instant.elastic_energy;
  for (std::size_t i = 0; i < instant.system.count(); ++i) energy += instant.system.mass[i] / 2 * instant.system.velocity[i].squaredNorm();
  return energy;
}

TEST(EnergyDrift, OfAnElasticGasIsItsChangeOfEnergyPerCollision) {
  const Input input = resolved(elastic);
  ASSERT_FALSE(why_account_is_open(input));
  FlowRun run(input, 0, 1, nullptr, "dem");
  const FlowInstant first = run.instant();
  double kinetic = 0, samples = 0;
  while (!run.done()) {
    run.advance();
    kinetic += energy_of(run.instant()) - run.instant().elastic_energy, samples += 1;
  }
  const double collisions = run.instant().totals.contact_starts - first.totals.contact_starts;
  const double expected = (energy_of(run.instant()) - energy_of(first)) / (kinetic / samples * collisions);
  EXPECT_GT(collisions, 1000);
  const double drift = value_of(run.measurement().result(), "energy_drift");
  EXPECT_NEAR(drift / expected, 1, 0.02);  // the mean of the kinetic energy is trapezoidal there
  EXPECT_LT(std::abs(drift), 1e-6);
  EXPECT_NE(drift, 0);
}

TEST(EnergyDrift, IsMissingWithAReasonWhereTheAccountIsOpen) {
  EXPECT_THAT(why_account_is_open(resolved(elastic, {"material.restitution=0.9"})),
              Optional(std::string("material.restitution = 0.9 dissipates, and the engine does not add up how much")));
  EXPECT_THAT(why_account_is_open(resolved(elastic, {"contact.tangential=mindlin"})), Optional(HasSubstr("friction")));
  EXPECT_THAT(why_account_is_open(resolved(elastic, {"contact.normal=jkr"})), Optional(HasSubstr("tear")));
  EXPECT_FALSE(why_account_is_open(resolved(elastic, {"contact.normal=jkr", "contact.adhesion_range=touch"})));
  EXPECT_THAT(why_account_is_open(resolved(elastic, {"cell.kind=shear", "run.duration=0", "run.strain=1"})), Optional(HasSubstr("shear")));
  // A wall counts where there is one.
  EXPECT_FALSE(why_account_is_open(resolved(elastic, {"wall.restitution=0.5"})));
  EXPECT_THAT(why_account_is_open(resolved(elastic, {"wall.restitution=0.5", "cell.kind=box"})), Optional(HasSubstr("wall.restitution")));
  FlowRun run(resolved(elastic, {"material.restitution=0.9", "run.duration=0.002"}), 0, 1, nullptr, "dem");
  while (!run.done()) run.advance();
  EXPECT_TRUE(std::isnan(value_of(run.measurement().result(), "energy_drift")));
}

/// To its end by the hybrid.
FlowRun hybrid_run(const std::vector<std::string>& settings) {
  static const TemporaryFolder folder;
  const TableStore tables{.folder = folder.path()};
  static std::list<Input> inputs;  // an engine keeps a reference
  FlowRun run(inputs.emplace_back(resolved(elastic, settings)), 0, 1, &tables, "hybrid");
  while (!run.done()) run.advance();
  return run;
}

TEST(EnergyDrift, OfTheHybridIsKnownWhileNoSoftSpheresRunTheWholeFlow) {
  const std::vector<std::string> rough = {"material.restitution=0.9", "contact.tangential=mindlin", "material.young=1e9"};
  const FlowRun stiff = hybrid_run(rough);
  EXPECT_GT(stiff.record().patches.value().contact_starts, 10);
  EXPECT_LT(std::abs(value_of(stiff.measurement().result(), "energy_drift")), 1e-10);
  EXPECT_GT(value_of(stiff.measurement().result(), "dissipation"), 0);

  const FlowRun soft = hybrid_run({"material.young=1e5", "particles.volume_fraction=0.55"});
  EXPECT_GE(soft.record().handovers, 1);
  EXPECT_TRUE(std::isnan(value_of(soft.measurement().result(), "energy_drift")));
}

}  // namespace
}  // namespace scalebreak::tests

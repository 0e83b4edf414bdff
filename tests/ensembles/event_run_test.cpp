#include <gmock/gmock.h>

#include <scalebreak/ensembles/report/run_json.hpp>
#include <scalebreak/ensembles/run/checkpoint.hpp>
#include <scalebreak/measure/flow_json.hpp>

#include <ensembles/flows.hpp>

// Flows by the event-driven engine: the same scene, files and checkpoints as those by the soft-sphere engine.

namespace scalebreak::tests {
namespace {

struct EventRun : testing::Test {
  TemporaryFolder folder;
  Input input = resolved(small_shear, {"contact.normal=hertz", "contact.tangential=none", "material.young=1e9"});

  [[nodiscard]] RunOptions options(const std::string& name) const {
    return {.out = folder / name, .engine = "event", .tables = TableStore{.folder = folder / "tables"}};
  }
};

TEST_F(EventRun, GivesTheSameNumbersAndFilesWhereverItIsInterrupted) {
  const RunOutcome whole = run_flow(input, options("whole"));
  EXPECT_GT(whole.events(), 500);
  const auto expected = files_of(folder / "whole");
  EXPECT_THAT(names_of(expected), testing::IsSupersetOf({"series.csv", "profiles.csv", "particles.xyz", "particles.dump", "particles.pvd",
                                                         "particles_000000.csv", "particles_000010.vtp"}));
  for (const int samples : {0, 3}) {
    const std::string name = "stopped_" + std::to_string(samples);
    RunOptions first = options(name), second = options(name);
    first.stop = stop_after(samples);
    second.resume = true;
    EXPECT_THROW((void)run_flow(input, first), RunInterrupted);
    const RunOutcome resumed = run_flow(input, second);
    remove_checkpoint(folder / name);
    EXPECT_EQ(flow_json(resumed.measured), flow_json(whole.measured)) << samples;
    EXPECT_EQ(resumed.events(), whole.events());
    const auto files = files_of(folder / name);
    for (const auto& [file, content] : expected) EXPECT_TRUE(files.at(file) == content) << file << " after " << samples;
  }
}

struct HybridRun : EventRun, testing::WithParamInterface<bool> {};

TEST_P(HybridRun, GivesTheSameNumbersAndFilesWhereverItIsInterrupted) {
  input = resolved(small_shear, {"contact.normal=hertz"});  // so soft that patches are all over it, and with friction
  if (GetParam())
    input = resolved(small_shear, {"contact.normal=hertz", "contact.rolling=cdt", "particles.size=gaussian", "particles.size_spread=0.1"});
  const auto by_hybrid = [&](const std::string& name) {
    RunOptions of = options(name);
    of.engine = "hybrid";
    return of;
  };
  const RunOutcome whole = run_flow(input, by_hybrid("whole"));
  EXPECT_GT(whole.replicas.front().patches.value().begun, 50);
  const auto expected = files_of(folder / "whole");
  for (const int samples : {0, 3, 7}) {
    const std::string name = "stopped_" + std::to_string(samples);
    RunOptions first = by_hybrid(name), second = by_hybrid(name);
    first.stop = stop_after(samples);
    second.resume = true;
    EXPECT_THROW((void)run_flow(input, first), RunInterrupted);
    const RunOutcome resumed = run_flow(input, second);
    remove_checkpoint(folder / name);
    EXPECT_EQ(flow_json(resumed.measured), flow_json(whole.measured)) << samples;
    const auto files = files_of(folder / name);
    for (const auto& [file, content] : expected) EXPECT_TRUE(files.at(file) == content) << file << " after " << samples;
  }
  const nlohmann::json j = run_json(input, whole);
  EXPECT_EQ(j["engine"], "hybrid");
  EXPECT_GT(j["patch_fraction"], 0.1);
  EXPECT_LE(j["patch_fraction"], 1);
}

INSTANTIATE_TEST_SUITE_P(Sizes, HybridRun, testing::Bool(), [](const auto& test) { return test.param ? "many" : "one"; });

TEST_F(EventRun, ThatJamsIsHandedOverToSoftSpheres) {
  input = resolved(small_shear, {"contact.normal=hertz", "material.young=1e5", "particles.volume_fraction=0.58"});
  RunOptions of = options("jammed");
  of.engine = "hybrid";
  const RunRecord run = run_flow(input, of).replicas.front();
  EXPECT_GE(run.handovers, 1);
  EXPECT_GT(run.steps, 100);
}

TEST_F(EventRun, SaysWhatItDid) {
  const RunOutcome outcome = run_flow(input, options("out"));
  const nlohmann::json j = run_json(input, outcome);
  EXPECT_EQ(j["engine"], "event");
  EXPECT_EQ(j["events"], outcome.events());
  EXPECT_GT(j["events_per_second"], 0);
  EXPECT_LT(j["integrated_collisions"], outcome.events() / 10);
  EXPECT_LT(j["delayed_collisions"], outcome.events() / 20);
  EXPECT_EQ(j["steps"], 0);
  EXPECT_FALSE(j.contains("step"));
  EXPECT_GT(j["coordination"], 0);  // from contact times
  EXPECT_TRUE(j["multi_contact_fraction"].is_null());
}

TEST_F(EventRun, GoesOnWithItsOwnEngineOnly) {
  RunOptions stopped = options("out"), other = options("out");
  stopped.stop = stop_after(2);
  other.resume = true, other.engine = "dem";
  EXPECT_THROW((void)run_flow(input, stopped), RunInterrupted);
  EXPECT_EQ(message_of<InputError>([&] { (void)run_flow(input, other); }),
            "--engine: found dem, and " + (folder / "out" / "checkpoint.bin").string() +
                " is of a run by event, which goes on bit for bit by the same only; allowed: event");
}

TEST_F(EventRun, ThatSticksSaysSo) {
  input = resolved(small_shear, {"contact.tangential=none", "material.surface_energy=10"});
  EXPECT_THAT(
      message_of<WorkError>([&] { (void)run_flow(input, options("out")); }),
      testing::HasSubstr(" stick together, which an event cannot say; allowed: a flow that is faster or adheres less, or --engine dem"));
}

}  // namespace
}  // namespace scalebreak::tests

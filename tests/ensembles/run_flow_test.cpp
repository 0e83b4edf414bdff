#include <gmock/gmock.h>

#include <scalebreak/ensembles/report/run_json.hpp>
#include <scalebreak/ensembles/run/checkpoint.hpp>
#include <scalebreak/measure/flow_json.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

struct RunFlow : testing::Test {
  TemporaryFolder folder;
  Input input = resolved(small_shear);

  [[nodiscard]] RunOutcome run_into(const std::string& name, const Input& of) const { return run_flow(of, {.out = folder / name}); }
};

TEST_F(RunFlow, GivesTheSameNumbersAndFilesWhereverItIsInterrupted) {
  const RunOutcome whole = run_into("whole", input);
  const auto expected = files_of(folder / "whole");
  EXPECT_THAT(names_of(expected), testing::IsSupersetOf({"series.csv", "profiles.csv", "particles.xyz", "particles.dump", "particles.pvd",
                                                         "particles_000000.csv", "particles_000010.vtp"}));
  for (const int samples : {0, 1, 7, 15}) {
    const std::string name = "stopped_" + std::to_string(samples);
    EXPECT_THROW((void)run_flow(input, {.out = folder / name, .stop = stop_after(samples)}), RunInterrupted);
    // A crash after the checkpoint leaves more than it holds.
    std::ofstream(folder / name / "series.csv", std::ios::app) << "1,2,3\n";
    std::ofstream(folder / name / "particles.xyz", std::ios::app) << "half a frame";
    const RunOutcome resumed = run_flow(input, {.out = folder / name, .resume = true});
    remove_checkpoint(folder / name);
    EXPECT_EQ(flow_json(resumed.measured), flow_json(whole.measured)) << samples;
    const auto files = files_of(folder / name);
    EXPECT_EQ(names_of(files), names_of(expected)) << samples;
    for (const auto& [file, content] : expected) EXPECT_TRUE(files.at(file) == content) << file << " after " << samples;
  }
}

TEST_F(RunFlow, AHeightThatFollowsThePressureGoesOnBitForBit) {
  input = resolved(small_shear, {"cell.kind=confined_shear", "cell.pressure=100", "cell.shear_rate=40"});
  const RunOutcome whole = run_into("whole", input);
  EXPECT_GT(std::abs(value_of(whole.measured, "volume_fraction") - 0.3), 1e-3);
  for (const int samples : {1, 7}) {
    const std::string name = "stopped_" + std::to_string(samples);
    EXPECT_THROW((void)run_flow(input, {.out = folder / name, .stop = stop_after(samples)}), RunInterrupted);
    const RunOutcome resumed = run_flow(input, {.out = folder / name, .resume = true});
    remove_checkpoint(folder / name);
    EXPECT_EQ(flow_json(resumed.measured), flow_json(whole.measured)) << samples;
    EXPECT_EQ(files_of(folder / name), files_of(folder / "whole")) << samples;
  }
}

TEST_F(RunFlow, CheckpointsChangeNothing) {
  const RunOutcome whole = run_into("whole", input);
  input.output.checkpoint_interval = 1e-6;
  const RunOutcome kept = run_into("kept", input);
  EXPECT_TRUE(std::filesystem::exists(checkpoint_path(folder / "kept")));
  EXPECT_EQ(flow_json(kept.measured), flow_json(whole.measured));
  EXPECT_EQ(content_of(folder / "kept" / "series.csv"), content_of(folder / "whole" / "series.csv"));
}

TEST_F(RunFlow, SaysWhatIsKeptWhenItIsInterrupted) {
  const std::string out = folder / "out";
  EXPECT_THAT(message_of<RunInterrupted>([&] { (void)run_flow(input, {.out = out, .stop = stop_after(0)}); }),
              "the run was interrupted at 0 s of 0.01 s; its checkpoint is " + out + "/checkpoint.bin, and scalebreak run --resume --out " +
                  out + " goes on from there");
  EXPECT_EQ(message_of<RunInterrupted>([&] { (void)run_flow(input, {.stop = stop_after(0)}); }),
            "the run was interrupted at 0 s of 0.01 s and nothing is kept, as there is no --out");
}

TEST_F(RunFlow, GoesOnWithTheSameInputAndThreadsOnly) {
  const std::string out = folder / "out", path = out + "/checkpoint.bin";
  EXPECT_THROW((void)run_flow(input, {.out = out, .stop = stop_after(3)}), RunInterrupted);
  EXPECT_EQ(message_of<InputError>([&] { (void)run_flow(input, {.out = out}); }),
            "--out: " + out + " holds the checkpoint of an unfinished run; allowed: --resume to go on with it, or another folder");
  EXPECT_EQ(message_of<InputError>([&] { (void)run_flow(input, {.out = out, .threads = 2, .resume = true}); }),
            "--threads: found 2, and " + path + " is of a run on 1, which goes on bit for bit on as many only; allowed: 1");
  Input other = input;
  other.run.seed = 2;
  EXPECT_EQ(message_of<InputError>([&] { (void)run_flow(other, {.out = out, .resume = true}); }),
            "--resume: " + path + " is of another input; allowed: the same one, or none, then its own is taken");
  Checkpoint checkpoint = read_checkpoint(out);
  checkpoint.version = "0.0.1";
  write_checkpoint(out, checkpoint);
  EXPECT_THAT(message_of<InputError>([&] { (void)run_flow(input, {.out = out, .resume = true}); }),
              testing::StartsWith("--resume: " + path + " is of scalebreak 0.0.1, and this is "));
  put_file(path, "something else");
  EXPECT_EQ(message_of<InputError>([&] { (void)run_flow(input, {.out = out, .resume = true}); }),
            "--resume: " + path + " is no checkpoint; allowed: one that run wrote");
}

TEST_F(RunFlow, AFileThatLostItsEndIsNotGoneOnWith) {
  const std::string out = folder / "out";
  EXPECT_THROW((void)run_flow(input, {.out = out, .stop = stop_after(10)}), RunInterrupted);
  const auto length = std::filesystem::file_size(out + "/series.csv");
  std::filesystem::resize_file(out + "/series.csv", 10);
  EXPECT_EQ(message_of<WorkError>([&] { (void)run_flow(input, {.out = out, .resume = true}); }),
            out + "/series.csv is 10 bytes long, and had " + std::to_string(length) +
                " bytes at the checkpoint, so the run cannot go on with it");
}

TEST_F(RunFlow, AnUnstableRunSaysWhichCheckpointIsLeft) {
  input.particles.speed = 5000;
  EXPECT_THAT(message_of<WorkError>([&] { (void)run_flow(input, {}); }), testing::EndsWith("; there is no checkpoint yet"));
}

TEST_F(RunFlow, ParticleFilesHoldTheFieldsThatAreAskedFor) {
  input.output.fields = {ParticleField::velocity, ParticleField::radius};
  input.output.formats = {ParticleFormat::csv, ParticleFormat::vtp, ParticleFormat::xyz, ParticleFormat::dump};
  (void)run_into("few", input);
  const auto file = [&](const char* name) { return content_of(folder / "few" / name); };
  EXPECT_THAT(file("particles_000000.csv"),
              testing::StartsWith("x [m],y [m],z [m],radius [m],velocity_x [m/s],velocity_y [m/s],velocity_z [m/s]\n"));
  EXPECT_THAT(file("particles.xyz"), testing::HasSubstr("Properties=pos:R:3:radius:R:1:velo:R:3:id:I:1\n"));
  EXPECT_THAT(file("particles.dump"), testing::HasSubstr("ITEM: ATOMS id x y z diameter vx vy vz\n"));
  EXPECT_THAT(file("particles_000000.vtp"),
              testing::AllOf(testing::HasSubstr("\"velocity\""), testing::Not(testing::HasSubstr("\"spin\""))));
}

TEST_F(RunFlow, ReplicasDifferAndTheirMeanHasAnErrorFromThat) {
  input.run.replicas = 3;
  const RunOutcome all = run_into("all", input);
  ASSERT_EQ(all.replicas.size(), 3u);
  const auto first = content_of(folder / "all" / "replica_1" / "series.csv");
  EXPECT_NE(first, content_of(folder / "all" / "replica_2" / "series.csv"));
  input.run.replicas = 1;
  const RunOutcome alone = run_into("alone", input);
  EXPECT_EQ(first, content_of(folder / "alone" / "series.csv"));
  const Quantity& temperature = all.measured.quantities.front();
  EXPECT_EQ(temperature.name, "temperature");
  EXPECT_GT(temperature.measured.error, 0);
  EXPECT_LT(temperature.measured.error, 0.2 * temperature.measured.value);
}

TEST_F(RunFlow, ReplicasGoOnAcrossAnInterruption) {
  input.run.replicas = 2;
  input.output.formats = {};
  const RunOutcome whole = run_into("whole", input);
  const long samples = whole.replicas.front().schedule.samples;
  EXPECT_THROW((void)run_flow(input, {.out = folder / "stopped", .stop = stop_after(static_cast<int>(samples) + 5)}), RunInterrupted);
  const RunOutcome resumed = run_flow(input, {.out = folder / "stopped", .resume = true});
  remove_checkpoint(folder / "stopped");
  EXPECT_EQ(flow_json(resumed.measured), flow_json(whole.measured));
  EXPECT_EQ(files_of(folder / "stopped"), files_of(folder / "whole"));
}

TEST_F(RunFlow, SaysWhichLawsActAndWhySpinsAreFollowedOrNot) {
  EXPECT_THAT(modelled(input), testing::EndsWith("; spins, since these laws turn the spheres"));
  EXPECT_THAT(modelled(resolved("[cell]\nkind = \"shear\"\n")),
              "contact law jkr, full, contact_radius; nothing tangential; no spins, since nothing turns the spheres");
}

}  // namespace
}  // namespace scalebreak::tests

#include <scalebreak/ensembles/run/run_flow.hpp>

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/version.hpp>
#include <scalebreak/ensembles/run/checkpoint.hpp>
#include <scalebreak/ensembles/run/flow_run.hpp>
#include <scalebreak/ensembles/run/replica_mean.hpp>
#include <scalebreak/ensembles/run/run_files.hpp>
#include <scalebreak/measure/flow_csv.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/scene/input_file.hpp>

namespace scalebreak {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// What a replica came to: its record, and its measurement as it is saved.
std::string finished_replica(const FlowRun& run) {
  std::string bytes;
  run.record().save(bytes);
  put_text(bytes, run.measurement().save());
  return bytes;
}

void refuse_another_run(const Checkpoint& checkpoint, const Input& input, const RunOptions& options) {
  const std::string path = checkpoint_path(options.out).string();
  if (checkpoint.input != write_input(input))
    throw InputError(fmt::format("--resume: {} is of another input; allowed: the same one, or none, then its own is taken", path));
  if (checkpoint.engine != options.engine)
    throw InputError(fmt::format("--engine: found {}, and {} is of a run by {}, which goes on bit for bit by the same only; allowed: {}",
                                 options.engine, path, checkpoint.engine, checkpoint.engine));
  if (checkpoint.threads != options.threads)
    throw InputError(fmt::format("--threads: found {}, and {} is of a run on {}, which goes on bit for bit on as many only; allowed: {}",
                                 options.threads, path, checkpoint.threads, checkpoint.threads));
}

void refuse_to_overwrite(const std::filesystem::path& out) {
  if (std::filesystem::exists(checkpoint_path(out)))
    throw InputError(fmt::format(
        "--out: {} holds the checkpoint of an unfinished run; allowed: --resume to go on with it, or another folder", out.string()));
}

/// All replicas of a run, one after the other.
class Runner {
 public:
  Runner(const Input& input, const RunOptions& options) : input_(input), options_(options) {}

  RunOutcome run() {
    std::optional<Checkpoint> left;
    if (options_.resume) {
      left = read_checkpoint(options_.out);
      refuse_another_run(*left, input_, options_);
      finished_ = left->finished, wall_before_ = left->wall_seconds, kept_time_ = left->time;
    } else if (keeps_files()) {
      refuse_to_overwrite(options_.out);
    }
    while (finished_.size() < input_.run.replicas) {
      run_replica(left);
      left.reset();
    }
    return outcome();
  }

 private:
  [[nodiscard]] const TableStore* tables() const { return options_.tables ? &*options_.tables : nullptr; }
  [[nodiscard]] bool keeps_files() const { return !options_.out.empty(); }
  [[nodiscard]] std::filesystem::path folder() const { return replica_folder(options_.out, finished_.size(), input_.run.replicas); }

  void begin(const std::optional<Checkpoint>& left) {
    if (left) {
      run_.emplace(input_, left->run, options_.threads, tables());
      files_.emplace(folder(), input_.output, left->files);
      return;
    }
    run_.emplace(input_, finished_.size(), options_.threads, tables(), options_.engine);
    files_.reset();
    if (keeps_files()) files_.emplace(folder(), input_.output).add(run_->instant());
    if (!options_.say) return;
    for (const std::string& warning : run_->record().warnings) options_.say(warning);
  }

  void run_replica(const std::optional<Checkpoint>& left) {
    begin(left);
    start_ = last_checkpoint_ = Clock::now();
    steps_at_start_ = run_->record().steps, events_at_start_ = run_->record().events.value_or(0);
    show();
    while (!run_->done()) {
      if (options_.stop && options_.stop()) interrupt();
      advance();
      if (files_ && run_->row_is_due()) files_->add(run_->instant());
      if (files_ && input_.output.checkpoint_interval > 0 && seconds_since(last_checkpoint_) >= input_.output.checkpoint_interval) keep();
      show();
    }
    wall_before_ += seconds_since(start_);
    if (files_) write_file(folder() / "profiles.csv", profile_csv(run_->measurement().result().profile).text());
    finished_.push_back(finished_replica(*run_));
  }

  void advance() {
    try {
      run_->advance();
    } catch (const WorkError& error) {
      throw WorkError(fmt::format(
          "{}; {}", error.what(),
          kept_time_ ? fmt::format("the last checkpoint, of {:.6g} s, is kept in {}", *kept_time_, checkpoint_path(options_.out).string())
                     : "there is no checkpoint yet"));
    }
  }

  void keep() {
    write_checkpoint(options_.out, {.version = std::string(version()),
                                    .input = write_input(input_),
                                    .engine = options_.engine,
                                    .threads = options_.threads,
                                    .wall_seconds = wall_before_ + seconds_since(start_),
                                    .time = run_->record().time,
                                    .finished = finished_,
                                    .run = run_->save(),
                                    .files = files_->save()});
    kept_time_ = run_->record().time;
    last_checkpoint_ = Clock::now();
  }

  [[noreturn]] void interrupt() {
    const double end = run_->record().schedule.time_of(run_->record().schedule.samples);
    const std::string when = fmt::format("the run was interrupted at {:.6g} s of {:.6g} s", run_->record().time, end);
    if (!files_) throw RunInterrupted(when + " and nothing is kept, as there is no --out");
    keep();
    throw RunInterrupted(fmt::format("{}; its checkpoint is {}, and scalebreak run --resume --out {} goes on from there", when,
                                     checkpoint_path(options_.out).string(), options_.out.string()));
  }

  void show() const {
    if (!options_.progress) return;
    const double spent = seconds_since(start_);
    const RunRecord& record = run_->record();
    const double done = record.events ? static_cast<double>(*record.events - events_at_start_)
                                      : static_cast<double>(record.particles) * static_cast<double>(record.steps - steps_at_start_);
    options_.progress({.share = (static_cast<double>(finished_.size()) + run_->share()) / static_cast<double>(input_.run.replicas),
                       .rate = spent > 0 ? done / spent : 0,
                       .of = record.events ? "events/s" : "particle steps/s"});
  }

  RunOutcome outcome() const {
    RunOutcome outcome{.replicas = {}, .measured = {}, .wall_seconds = wall_before_, .threads = options_.threads};
    std::vector<FlowResult> results;
    for (const std::string& replica : finished_) {
      std::string_view bytes = replica;
      outcome.replicas.emplace_back().load(bytes);
      FlowMeasurement measurement(FlowRun::slabs);
      measurement.load(take_text(bytes));
      results.push_back(measurement.result());
    }
    outcome.measured = replica_mean(results);
    if (!keeps_files()) return outcome;
    write_file(options_.out / "profiles.csv", profile_csv(outcome.measured.profile).text());
    return outcome;
  }

  const Input& input_;
  const RunOptions& options_;
  std::vector<std::string> finished_;
  std::optional<FlowRun> run_;
  std::optional<RunFiles> files_;
  double wall_before_ = 0;  ///< of what is finished, or was before a checkpoint [s]
  Clock::time_point start_, last_checkpoint_;
  long steps_at_start_ = 0, events_at_start_ = 0;
  std::optional<double> kept_time_;
};

}  // namespace

double RunOutcome::particle_steps() const {
  double sum = 0;
  for (const RunRecord& record : replicas) sum += static_cast<double>(record.particles) * static_cast<double>(record.steps);
  return sum;
}

long RunOutcome::events() const {
  long sum = 0;
  for (const RunRecord& record : replicas) sum += record.events.value_or(0);
  return sum;
}

std::filesystem::path replica_folder(const std::filesystem::path& out, std::uint64_t replica, std::uint64_t replicas) {
  return replicas == 1 ? out : out / fmt::format("replica_{}", replica + 1);
}

void begin_run_folder(const std::filesystem::path& out, const std::string& input_file) {
  refuse_to_overwrite(out);
  std::error_code failed;
  std::filesystem::remove(out / "result.json", failed);  // of a run that is now gone
  write_file(out / "input.toml", input_file);
}

RunOutcome run_flow(const Input& input, const RunOptions& options) { return Runner(input, options).run(); }

}  // namespace scalebreak

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/engine/engine_names.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>
#include <scalebreak/ensembles/report/run_json.hpp>
#include <scalebreak/ensembles/report/run_report.hpp>
#include <scalebreak/ensembles/run/checkpoint.hpp>
#include <scalebreak/ensembles/run/engine_choice.hpp>
#include <scalebreak/ensembles/run/run_estimate.hpp>
#include <scalebreak/ensembles/run/run_flow.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/toml_reader.hpp>

#include "command.hpp"
#include "stop.hpp"

namespace scalebreak::apps {
namespace {

using nlohmann::json;

void refuse_other_engines(const std::string& engine) {
  if (engine != "auto" && engine != "dem" && engine != "event" && engine != "hybrid")
    throw InputError(fmt::format("--engine: {} is not there yet; allowed: dem, event, hybrid, or auto", engine));
}

std::string estimate(const Options& options, const Input& input) {
  const EngineChoice choice = choose_engine(options.engine, input, options.cores());
  const RunEstimate e = estimate_run(input, options.cores());
  if (flies(choice.engine))
    return fmt::format("engine {}, {:.0f} spheres; how many collisions there will be is not known before, a guess is {:.2g} s",
                       choice.engine, e.particles, e.hybrid_seconds);
  return fmt::format(
      "engine dem, {:.0f} spheres, {:.3g} steps, about {:.2g} s on {} threads, {:.2g} MB of memory, {:.2g} MB of particle files with --out",
      e.particles, e.steps, e.seconds, options.cores(), e.bytes / 1e6, e.file_bytes / 1e6);
}

/// The engine of a run; of one that goes on without being told which, the one that it had.
EngineChoice engine_choice(const Options& options, const std::string& asked, const Input& input) {
  EngineChoice choice = choose_engine(asked, input, options.cores());
  if (options.engine != asked && choice.engine != options.engine) choice = {options.engine, "as the run began"};
  return choice;
}

/// A run that goes on has its input and threads in the checkpoint; what is given must be the same.
Input input_to_go_on_with(Options& options) {
  if (options.out.empty()) throw InputError("--resume: --out is missing; allowed: --out with the folder of an unfinished run");
  const Checkpoint checkpoint = read_checkpoint(options.out);
  if (options.threads == 0) options.threads = checkpoint.threads;
  if (options.engine == "auto") options.engine = checkpoint.engine;
  if (!options.files.empty() || !options.settings.empty()) return options.input();
  return resolve_input(read_toml(checkpoint.input, checkpoint_path(options.out).string()));
}

void print_steps(const RunOutcome& outcome) {
  const RunRecord& run = outcome.replicas.front();
  fmt::print("step              {:.4g} s, limited by {}; the smallest bound is that of the {}, {:.4g} s\n", run.schedule.step,
             run.step.limit, run.step.bound, run.step.bound_step);
  if (const ShortestContact& contact = run.step.contact; contact.time > 0)
    fmt::print("shortest contact  {:.4g} s, {:.1f} steps: {} at {:.4g} m/s ({}), by {}\n", contact.time, contact.time / run.schedule.step,
               contact.of, contact.meeting.speed, contact.meeting.of, contact_time_source(contact));
  fmt::print("time              {:.6g} s, of which {:.6g} s measured, {} steps, {:.3g} s of wall time, {:.3g} particle steps per second\n",
             run.time, outcome.measured.duration, run.steps, outcome.wall_seconds, outcome.particle_steps() / outcome.wall_seconds);
}

void print_run(const EngineChoice& choice, const Input& input, const RunOutcome& outcome) {
  const RunRecord& run = outcome.replicas.front();
  fmt::print("engine            {} ({}), {} threads\n", run.engine, choice.reason, run.engine == "event" ? 1 : outcome.threads);
  fmt::print("modelled          {}\n", modelled(input));
  if (input.scaling_law != "none" || input.scaling_factor != 1)
    fmt::print("scaled            {} at {:g}; what follows is the scaled system's\n", input.scaling_law, input.scaling_factor);
  fmt::print("spheres           {} in {:.4g} x {:.4g} x {:.4g} m, volume fraction {:.4g}{}\n", run.particles, run.cell.x(), run.cell.y(),
             run.cell.z(), run.volume_fraction,
             outcome.replicas.size() > 1 ? fmt::format(" (the first of {} replicas)", outcome.replicas.size()) : "");
  if (flies(run.engine))
    fmt::print(
        "time              {:.6g} s, of which {:.6g} s measured, {} events, {} of them integrated, {:.3g} s of wall time, {:.3g} events per second\n",
        run.time, outcome.measured.duration, run.events.value_or(0), run.integrated.value_or(0), outcome.wall_seconds,
        static_cast<double>(outcome.events()) / outcome.wall_seconds);
  else
    print_steps(outcome);
  if (run.patches)
    fmt::print(
        "patches           {} begun, with {:.4g} of all contacts and {:.4g} of the spheres' time; {} collisions taken back, {} that no table "
        "answered, {:.4g} sphere steps of {:.4g} s; {} handovers to or from soft spheres alone, {} steps\n",
        run.patches->begun, run.patches->contact_starts / run.contact_starts,
        run.patches->sphere_time / (static_cast<double>(run.particles) * run.time), run.patches->taken_back, run.patches->unresolved,
        static_cast<double>(run.patches->sphere_steps), run.step.step, run.handovers, run.steps);
  for (const Quantity& quantity : outcome.measured.quantities) fmt::print("{:<24}{}\n", quantity.name, in_words(quantity));
  const MeasuredTensor& stress = outcome.measured.stress;
  for (const Eigen::Index i : {0, 1, 2}) {
    fmt::print("{:<24}{:>12.5g} {:>12.5g} {:>12.5g}\n", i == 0 ? "stress, rows x y z, Pa" : "", stress.value(i, 0), stress.value(i, 1),
               stress.value(i, 2));
  }
}

std::function<void(const RunProgress&)> bar(const Options& options) {
  if (options.quiet) return {};
  struct State {
    std::function<void(double)> show;
    double rate = 0;
    const char* of = "";
  };
  const auto state = std::make_shared<State>();
  return [state, &options](const RunProgress& progress) {
    state->rate = progress.rate, state->of = progress.of;
    if (!state->show)
      state->show = options.progress("running the flow", progress.share,
                                     [state = state.get()] { return fmt::format("{:.2g} {}", state->rate, state->of); });
    state->show(progress.share);
  };
}

void run(Options& options) {
  refuse_other_engines(options.engine);
  if (answered_early(options, [&](const Input& input) { return estimate(options, input); })) return;
  const std::string asked = options.engine;
  const Input input = options.resume ? input_to_go_on_with(options) : options.input();
  const EngineChoice choice = engine_choice(options, asked, input);
  if (flies(choice.engine)) refuse_height_that_follows(input);
  if (choice.engine == "event") refuse_laws_without_tables(input);
  stop_on_signals();
  if (!options.out.empty() && !options.resume) begin_run_folder(options.out, input_file_text(input, "run"));
  const RunOutcome outcome = run_flow(input, {.out = options.out,
                                              .threads = options.cores(),
                                              .resume = options.resume,
                                              .engine = choice.engine,
                                              .tables = options.store(),
                                              .stop = told_to_stop,
                                              .progress = bar(options),
                                              .say = [&](const std::string& sentence) { options.say(sentence); }});
  if (!options.out.empty()) {
    for (const std::string& plot : write_run_report(input, outcome, options.out))
      options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
  }
  json result = run_json(input, outcome);
  result["engine_reason"] = choice.reason;
  deliver(options, input, "run", result);
  if (!options.out.empty()) remove_checkpoint(options.out);
  if (!options.json) print_run(choice, input, outcome);
}

}  // namespace

void add_run(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command =
      app.add_subcommand("run", "a flow of many spheres: what is measured with its errors, series, profiles, particle files");
  add_options(*command, options);
  command
      ->add_option("--engine", options.engine,
                   "what moves the spheres: soft spheres (dem), instantaneous collisions of two (event), both where each is right (hybrid)")
      ->check(CLI::IsMember({"auto", "event", "hybrid", "dem", "lammps"}))
      ->type_name("auto|event|hybrid|dem|lammps");
  command->add_flag("--resume", options.resume, "go on with the unfinished run in --out; without an input, with its own");
  command->callback([&] {
    job = [&options] {
      options.flows = true;
      run(options);
    };
  });
}

}  // namespace scalebreak::apps

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/run/run_estimate.hpp>
#include <scalebreak/ensembles/tradeoff/collision_choice.hpp>
#include <scalebreak/ensembles/tradeoff/method_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/tradeoff_files.hpp>
#include <scalebreak/ensembles/tradeoff/tradeoff_json.hpp>

#include <scalebreak/output/atomic_file.hpp>

#include "command.hpp"
#include "stop.hpp"

namespace scalebreak::apps {
namespace {

std::string estimate(const Options& options, Input input) {
  if (!input.flow) {
    const double steps = soft_sphere_steps(input);
    return fmt::format("{:.2g} steps of soft spheres, about {:.1g} s, below 20 MB; more where a bridge lasts, or tables are built", steps,
                       1e-6 * steps);
  }
  if (input.tradeoff.methods.empty()) {
    const MethodGrid methods = method_grid(input);
    return fmt::format("{} ways, {} runs{}, about {:.2g} s on {} threads, below 1 GB", methods.ways.size(),
                       methods.grid.cells.size() * input.run.replicas, input.study.target_error > 0 ? " at least" : "",
                       expected_seconds(methods.grid, input) / options.cores(), options.cores());
  }
  const auto methods = static_cast<double>(input.tradeoff.methods.size());
  double seconds = 0, bytes = 0;
  for (const double fraction : input.tradeoff.step_fractions) {
    input.run.step_fraction = fraction, input.run.step_bounds = false;
    const RunEstimate e = estimate_run(input, options.cores());
    seconds += methods * e.seconds, bytes = std::max(bytes, e.bytes);
  }
  return fmt::format("{:.0f} flows, about {:.2g} s on {} threads, {:.2g} MB",
                     methods * static_cast<double>(input.tradeoff.step_fractions.size()), seconds, options.cores(), bytes / 1e6);
}

void print(const CollisionTradeoff& study) {
  fmt::print("{:<20} {:>9} {:>10} {:>10} {:>10} {:>10} {:>12} {:>10}\n", "method", "setting", "error rms", "largest", "energy", "time rms",
             "evaluations", "wall [us]");
  for (const CollisionPoint& p : study.points) {
    fmt::print("{:<20} {:>9g} {:>10.2e} {:>10.2e} {:>+10.1e} {:>10} {:>12.1f} {:>10.1f}{}{}\n", p.method->name(), p.setting, p.motion_rms,
               p.motion_largest, p.energy_mean, p.time_rms ? fmt::format("{:.2e}", *p.time_rms) : "-", p.force_evaluations, 1e6 * p.seconds,
               p.on_front ? "  on the front" : "", p.unparted > 0 ? fmt::format("  {} of {} did not part", p.unparted, p.phases) : "");
  }
  for (const CollisionConvergence& c : study.convergence) {
    fmt::print("{:<20} {}; contact time: {}\n", c.method->name(), in_words(c.motion, c.method->setting),
               in_words(c.contact_time, c.method->setting));
  }
  for (const std::string& each : choices(study)) fmt::print("{}\n", each);
  for (const std::string& each : study.refusals) fmt::print("{}\n", each);
}

void print(const FlowTradeoff& study) {
  const FlowPoint& reference = study.points[study.reference];
  fmt::print("beside {} at a step fraction of {:g}\n", method_words[static_cast<std::size_t>(reference.method)], reference.step_fraction);
  for (const FlowPoint& p : study.points) {
    if (&p == &reference) continue;
    fmt::print("{} at {:g}, {:.3g} force evaluations, {:.3g} s{}\n", method_words[static_cast<std::size_t>(p.method)], p.step_fraction,
               p.force_evaluations, p.seconds, p.on_front ? ", on the front" : "");
    for (const Comparison& c : p.deviations) fmt::print("  {}\n", sentence(c));
  }
}

/// A flow by all engines and laws: kept run by run, as a study of breakdown is.
void run_all_methods(const Options& options, const Input& input) {
  const std::filesystem::path out = options.out;
  if (!out.empty()) write_file(out / "input.toml", input_file_text(input, "tradeoff"));
  stop_on_signals();
  const MethodTradeoff study = method_tradeoff(
      input,
      {.out = out, .threads = options.cores(), .tables = options.store(), .stop = told_to_stop, .progress = options.progress("measuring")});
  if (!out.empty()) {
    for (const std::string& plot : write_tradeoff(study, input.run.seed, options.title(), out))
      options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
  }
  if (!study.complete)
    throw WorkError(out.empty() ? std::string("the study was interrupted and nothing is kept, as there is no --out")
                                : fmt::format("the study was interrupted; its finished runs are kept in {}, and the same command goes on "
                                              "from there",
                                              options.out));
  deliver(options, input, "tradeoff", tradeoff_json(study));
  if (options.json) return;
  for (const std::string& each : sentences(study)) fmt::print("{}\n", each);
}

template <class Study>
void report(const Options& options, const Input& input, const Study& study) {
  if (!options.out.empty()) {
    for (const std::string& plot : write_tradeoff(study, options.title(), options.out))
      options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
  }
  deliver(options, input, "tradeoff", tradeoff_json(study));
  if (!options.json) print(study);
}

}  // namespace

void add_tradeoff(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand(
      "tradeoff", "accuracy against cost of the methods, measured, on the scene's collision or flow: order of convergence, front, plots");
  add_options(*command, options);
  command->callback([&] {
    job = [&options] {
      options.either = true;
      if (answered_early(options, [&](const Input& input) { return estimate(options, input); })) return;
      const Input input = options.input();
      if (input.flow && input.tradeoff.methods.empty()) return run_all_methods(options, input);
      const auto progress = options.progress("measuring");
      if (input.flow) {
        report(options, input, flow_tradeoff(input, options.cores(), progress));
      } else {
        report(options, input, collision_tradeoff(input, options.store(), progress));
      }
    };
  });
}

}  // namespace scalebreak::apps

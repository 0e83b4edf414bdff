#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/stability/stability_files.hpp>
#include <scalebreak/ensembles/stability/stability_study.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

std::string estimate(const Input& input) {
  // A bisection tries about ten steps.
  if (!input.flow)
    return fmt::format("{} bisections of about ten steps, {} collisions each, below 1 s each",
                       stability_inputs(input).size() * stability_criteria(input).size() * input.study_integrators.size(),
                       input.tradeoff.phases);
  const double bisections = static_cast<double>(stability_inputs(input).size() * stability_criteria(input).size() *
                                                input.study_integrators.size() * input.run.replicas);
  return fmt::format("{:.0f} bisections of about ten trials each, {:g} collisions of each sphere a trial", bisections,
                     collisions_of_a_trial);
}

void run(Options& options) {
  if (answered_early(options, estimate)) return;
  const Input input = options.input();
  const StabilityStudy study = run_stability(input, options.threads, options.progress("trying steps"));
  if (study.skipped > 0)
    options.say(fmt::format("{} pairs of law and factor were left out: each law takes the factors on its side of 1", study.skipped));
  for (const StabilityRecord& record : study.records) {
    if (record.without_bracket() > 0)
      options.say(
          fmt::format("{} at {:g}: {} of {} seeds found no largest stable step between 1/1000 and 4 of the Rayleigh time, and are left out",
                      record.law, record.factor, record.without_bracket(), record.seeds.size()));
  }
  if (!options.out.empty()) {
    for (const std::string& plot : write_stability_report(input, study, options.out))
      options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
  }
  deliver(options, input, "stability", stability_json(input, study));
  if (options.json) return;
  for (const StabilityRecord& record : study.records) fmt::print("{}\n", in_words(study, record));
}

}  // namespace

void add_stability(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand(
      "stability", "the largest stable step of each scaling law and factor, of a flow or of a collision, beside Rayleigh's");
  add_options(*command, options);
  command->callback([&] {
    job = [&options] {
      options.either = true;
      run(options);
    };
  });
}

}  // namespace scalebreak::apps

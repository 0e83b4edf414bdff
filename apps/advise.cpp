#include <fmt/format.h>

#include <scalebreak/ensembles/prediction/advice_words.hpp>
#include <scalebreak/ensembles/prediction/prediction_file.hpp>
#include <scalebreak/ensembles/prediction/prediction_report.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

/// Fits the prediction to finished studies.
void fit(const Options& options) {
  TrainingRows training;
  for (const std::string& folder : options.studies) add_study(training, folder);
  const DeviationModel model = fit_model(training, options.input().run.seed);
  if (training.without_error > 0)
    options.say(fmt::format("{} rows were left out, as their errors are not known: more replicas or a longer strain tell them",
                            training.without_error));
  if (!options.out.empty()) {
    for (const std::string& plot : write_prediction(model, training, options.out))
      options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
  }
  if (options.json) {
    fmt::print("{}\n", model_json(model).dump());
    return;
  }
  for (const std::string& each : sentences(model)) fmt::print("{}\n", each);
}

void run(const Options& options) {
  if (answered_early(options, [](const Input&) { return std::string("below a second"); })) return;
  if (!options.studies.empty()) return fit(options);
  const Input input = options.input();
  const DeviationModel model = read_model(options.model.empty() ? default_model_path() : std::filesystem::path(options.model));
  const Advice advice = advise(input, model, options.cores());
  const LawAdvice& best = advice.laws[advice.recommended];
  deliver(options, input, "advise", advice_json(advice, model, input.advise.tolerance));
  if (options.json) return;
  fmt::print("{}\n", sentence(best));
  for (const std::string& warning : best.warnings) fmt::print("  beware: {}\n", warning);
  fmt::print("all laws:\n");
  for (const LawAdvice& law : advice.laws) fmt::print("  {}\n", sentence(law));
}

}  // namespace

void add_advise(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand(
      "advise",
      "the softest or largest spheres that keep a flow within a tolerance, by which law and engine, how much faster, and why not further");
  add_options(*command, options);
  command->add_option("--fit", options.studies, "folders of finished studies (breakdown): fits the prediction to them, into --out")
      ->type_name("DIR");
  command->add_option("--model", options.model, "prediction.json to go by (default: that of data/reference)")->type_name("FILE");
  command->callback([&] {
    job = [&options] {
      options.flows = true;
      run(options);
    };
  });
}

}  // namespace scalebreak::apps

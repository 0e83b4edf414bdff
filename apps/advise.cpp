#include <fmt/format.h>

#include <scalebreak/ensembles/prediction/advice_words.hpp>
#include <scalebreak/ensembles/prediction/prediction_file.hpp>
#include <scalebreak/ensembles/prediction/prediction_report.hpp>
#include <scalebreak/output/atomic_file.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

DeviationModel model_of(const Options& options) {
  return read_model(options.model.empty() ? default_model_path() : std::filesystem::path(options.model));
}

TrainingRows rows_of(const std::vector<std::string>& folders, const Options& options) {
  TrainingRows rows;
  for (const std::string& folder : folders) add_study(rows, folder);
  if (rows.without_error > 0)
    options.say(fmt::format("{} rows were left out, as their errors are not known: more replicas or a longer strain tell them",
                            rows.without_error));
  return rows;
}

void keep(const DeviationModel& model, const TrainingRows& rows, RowsAre are, const Options& options) {
  if (options.out.empty()) return;
  for (const std::string& plot : write_rows(model, rows, are, options.out))
    options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
}

void print(const std::vector<std::string>& sentences) {
  for (const std::string& each : sentences) fmt::print("{}\n", each);
}

/// Fits the prediction to finished studies.
void fit(const Options& options) {
  const TrainingRows training = rows_of(options.studies, options);
  const DeviationModel model = fit_model(training, options.input().run.seed);
  keep(model, training, RowsAre::fitted_to, options);
  if (!options.out.empty()) write_file(std::filesystem::path(options.out) / "prediction.json", model_json(model).dump(1) + "\n");
  if (options.json) return fmt::print("{}\n", model_json(model).dump());
  print(sentences(model.validation));
  fmt::print("{} rows fitted, {} held back, {} cells of these deviate\n", model.rows_fitted, model.rows_held_back, model.cells_off);
}

/// Tests the prediction on finished studies that it was not fitted to.
void test(const Options& options) {
  const DeviationModel model = model_of(options);
  const TrainingRows unseen = rows_of(options.tested, options);
  const auto validation = test_on(model, unseen);
  keep(model, unseen, RowsAre::unseen, options);
  if (!options.json) return print(sentences(validation));
  nlohmann::json result = {{"together", validation_json(together(validation))}, {"quantities", nlohmann::json::object()}};
  for (const auto& [quantity, each] : validation) result["quantities"][quantity] = validation_json(each);
  fmt::print("{}\n", result.dump());
}

/// Predicts the cells of a study that has not run.
void forecast(const Options& options) {
  const DeviationModel model = model_of(options);
  const TrainingRows rows = forecast_rows(options.input(), options.title());
  keep(model, rows, RowsAre::not_run, options);
  print(forecast_sentences(model, rows));
}

void run(const Options& options) {
  if (answered_early(options, [](const Input&) { return std::string("below a second"); })) return;
  if (!options.studies.empty()) return fit(options);
  if (!options.tested.empty()) return test(options);
  if (options.forecast) return forecast(options);
  const Input input = options.input();
  const DeviationModel model = model_of(options);
  const Advice advice = advise(input, model, options.cores());
  const LawAdvice& best = advice.laws[advice.recommended];
  deliver(options, input, "advise", advice_json(advice, model, input.advise.tolerance));
  if (options.json) return;
  fmt::print("{}\n  it {}\n", sentence(best), best.keeps);
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
  command->add_option("--test", options.tested, "folders of finished studies that the prediction was not fitted to: how it does on them")
      ->type_name("DIR");
  command->add_flag("--forecast", options.forecast, "predicts each cell of the study of the input, before it runs");
  command->add_option("--model", options.model, "prediction.json to go by (default: that of data/reference)")->type_name("FILE");
  command->callback([&] {
    job = [&options] {
      options.flows = true;
      run(options);
    };
  });
}

}  // namespace scalebreak::apps

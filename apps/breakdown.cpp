#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/breakdown/engine_agreement.hpp>
#include <scalebreak/ensembles/breakdown/run_study.hpp>
#include <scalebreak/ensembles/breakdown/study_files.hpp>
#include <scalebreak/ensembles/breakdown/study_report.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>
#include <scalebreak/output/atomic_file.hpp>

#include "command.hpp"
#include "stop.hpp"

namespace scalebreak::apps {
namespace {

std::string estimate(const Options& options, const Input& input) {
  const StudyGrid grid = study_grid(input);
  return fmt::format("{} cells, {} runs{}, about {:.2g} s on {} threads, below 1 GB", grid.cells.size(),
                     grid.cells.size() * input.run.replicas, input.study.target_error > 0 ? " at least" : "",
                     expected_seconds(grid, input) / options.cores(), options.cores());
}

void print(const StudyResult& study, const std::string& parameter) {
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    if (!study.cells[i].failure.empty())
      fmt::print("{} at {:g}, {}: {}\n", study.grid.cells[i].law, study.grid.cells[i].factor, study.grid.cells[i].point.name(parameter),
                 study.cells[i].failure);
  }
  for (const std::string& each : law_digest(study, parameter)) fmt::print("{}\n", each);
  for (const EngineAgreement& each : engine_agreements(study)) fmt::print("{}\n", sentence(each));
  fmt::print("\nwhere each law breaks:\n");
  for (const LawReach& reach : law_reaches(study)) fmt::print("{}\n", sentence(reach, parameter));
}

void run(const Options& options) {
  if (answered_early(options, [&](const Input& input) { return estimate(options, input); })) return;
  const Input input = options.input();
  StudyGrid grid = study_grid(input);
  if (grid.skipped > 0)
    options.say(fmt::format("{} cells were left out: each law takes the factors on its side of 1, and not every engine runs every law",
                            grid.skipped));
  if (!options.out.empty()) write_file(std::filesystem::path(options.out) / "input.toml", input_file_text(input, "breakdown"));
  stop_on_signals();
  const StudyResult study = run_study(input, std::move(grid),
                                      {.out = options.out,
                                       .threads = options.cores(),
                                       .tables = options.store(),
                                       .stop = told_to_stop,
                                       .progress = options.progress("running the study")});
  if (!options.out.empty()) {
    for (const std::string& plot : write_study(input, study, options.title(), options.out))
      options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
  }
  if (!study.complete)
    throw WorkError(
        options.out.empty()
            ? std::string("the study was interrupted and nothing is kept, as there is no --out")
            : fmt::format("the study was interrupted; its finished runs are kept in {}, and the same command goes on from there",
                          options.out));
  deliver(options, input, "breakdown", study_json(study, input.study.parameter));
  if (!options.json) print(study, input.study.parameter);
}

}  // namespace

void add_breakdown(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand(
      "breakdown", "a study: original and scaled flows over laws, factors and the scene's parameters; where each law breaks; resumable");
  add_options(*command, options);
  command->callback([&] {
    job = [&options] {
      options.flows = true;
      run(options);
    };
  });
}

}  // namespace scalebreak::apps

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/compare/compare_runs.hpp>
#include <scalebreak/output/atomic_file.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

constexpr int most_runs = 100;

void print(const std::vector<FinishedRun>& runs, const std::vector<RunComparison>& comparisons) {
  for (const RunComparison& pair : comparisons) {
    fmt::print("{} beside {}\n", runs[pair.second].folder.string(), runs.front().folder.string());
    if (!pair.inputs.empty()) fmt::print("  the inputs differ in {}\n", fmt::join(pair.inputs, "; "));
    for (const Comparison& c : pair.quantities) fmt::print("  {}\n", sentence(c));
  }
}

void compare(const Options& options) {
  if (options.files.size() < 2)
    throw InputError(fmt::format("compare: found {} folder{}; allowed: at least 2, each of a finished run", options.files.size(),
                                 options.files.size() == 1 ? "" : "s"));
  std::vector<FinishedRun> runs;
  for (const std::string& folder : options.files) runs.push_back(read_finished_run(folder));
  const auto comparisons = compare_runs(runs);
  const nlohmann::json result = comparison_json(runs, comparisons);
  if (!options.out.empty()) {
    for (const std::string& plot : write_comparison(runs, comparisons, options.out))
      options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
    write_file(std::filesystem::path(options.out) / "result.json", result.dump(2) + "\n");
  }
  options.json ? fmt::print("{}\n", result.dump()) : print(runs, comparisons);
}

}  // namespace

void add_compare(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand("compare", "finished runs: which differences from the first exceed their errors");
  command->add_option("folder", options.files, "--out folders of finished runs, at least two")->expected(0, most_runs)->type_name("DIR");
  command->add_option("--out", options.out, "folder for the results")->type_name("DIR");
  command->add_flag("--json", options.json, "print one JSON object on standard output, and nothing else there");
  command->add_flag("--quiet", options.quiet, "no remarks on standard error");
  command->callback([&] { job = [&options] { compare(options); }; });
}

}  // namespace scalebreak::apps

#include <scalebreak/ensembles/compare/compare_runs.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/ensembles/report/profile_plots.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/html.hpp>
#include <scalebreak/output/known.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

constexpr const char* verdict_words[] = {"no difference", "difference", "unknown"};
const char* word_of(Verdict verdict) { return verdict_words[static_cast<std::size_t>(verdict)]; }

std::string name_of(const FinishedRun& run) { return run.folder.lexically_normal().string(); }

std::string comparison_csv(const std::vector<FinishedRun>& runs, const std::vector<RunComparison>& comparisons) {
  Csv csv({"first", "second", "quantity", "unit", "first_value", "first_error", "second_value", "second_error", "difference",
           "difference_error", "relative [-]", "relative_error [-]", "verdict"});
  for (const RunComparison& pair : comparisons) {
    for (const Comparison& c : pair.quantities)
      csv.add({name_of(runs.front()), name_of(runs[pair.second]), c.name, c.unit, known_cell(c.first.value), known_cell(c.first.error),
               known_cell(c.second.value), known_cell(c.second.error), known_cell(c.difference.value), known_cell(c.difference.error),
               known_cell(c.relative.value), known_cell(c.relative.error), word_of(c.verdict)});
  }
  return csv.text();
}

std::vector<Plot> write_profiles(const std::vector<FinishedRun>& runs, const std::filesystem::path& out) {
  const std::string header = runs.front().profiles.substr(0, runs.front().profiles.find('\n'));
  std::vector<ProfileFile> files;
  for (const FinishedRun& run : runs) {
    if (run.profiles.empty() || run.profiles.substr(0, run.profiles.find('\n')) != header) return {};
    files.push_back({fmt::format("profiles_{}.csv", files.size() + 1), name_of(run)});
  }
  for (std::size_t k = 0; k < runs.size(); ++k) write_file(out / files[k].file, runs[k].profiles);
  return profile_plots(header, files, fmt::format("{} runs", runs.size()));
}

}  // namespace

std::vector<RunComparison> compare_runs(const std::vector<FinishedRun>& runs) {
  std::vector<RunComparison> comparisons;
  for (std::size_t k = 1; k < runs.size(); ++k)
    comparisons.push_back({k, input_differences(runs.front(), runs[k]), compare(runs.front().quantities, runs[k].quantities)});
  return comparisons;
}

json comparison_json(const std::vector<FinishedRun>& runs, const std::vector<RunComparison>& comparisons) {
  json list = json::array(), names = json::array();
  for (const FinishedRun& run : runs) names.push_back(name_of(run));
  for (const RunComparison& pair : comparisons) {
    json quantities = json::array();
    for (const Comparison& c : pair.quantities)
      quantities.push_back({{"quantity", c.name},
                            {"unit", c.unit},
                            {"first", known_number(c.first.value)},
                            {"first_error", known_number(c.first.error)},
                            {"second", known_number(c.second.value)},
                            {"second_error", known_number(c.second.error)},
                            {"difference", known_number(c.difference.value)},
                            {"difference_error", known_number(c.difference.error)},
                            {"relative", known_number(c.relative.value)},
                            {"relative_error", known_number(c.relative.error)},
                            {"verdict", word_of(c.verdict)}});
    list.push_back({{"first", name_of(runs.front())},
                    {"second", name_of(runs[pair.second])},
                    {"input_differences", pair.inputs},
                    {"quantities", quantities}});
  }
  return {{"runs", names}, {"comparisons", list}};
}

std::vector<std::string> write_comparison(const std::vector<FinishedRun>& runs, const std::vector<RunComparison>& comparisons,
                                          const std::filesystem::path& out) {
  write_file(out / "comparison.csv", comparison_csv(runs, comparisons));
  const std::vector<Plot> plots = write_profiles(runs, out);
  std::vector<std::string> missing;
  for (const Plot& plot : plots) {
    if (!draw(plot, out)) missing.push_back(plot.name);
  }
  HtmlReport report("Runs compared", fmt::format("Each run is compared with the first, {}. A difference is called one where it exceeds "
                                                 "twice its standard error.",
                                                 name_of(runs.front())));
  for (const RunComparison& pair : comparisons) {
    report.heading(name_of(runs[pair.second]));
    if (!pair.inputs.empty()) report.paragraph(fmt::format("The inputs differ in {}.", fmt::join(pair.inputs, "; ")));
    std::vector<std::vector<std::string>> rows;
    for (const Comparison& c : pair.quantities)
      rows.push_back({sentence(c), c.unit, fmt::format("{:.6g}", c.first.value), fmt::format("{:.6g}", c.second.value)});
    report.table({"", "unit", "first", "second"}, rows);
  }
  if (!plots.empty()) report.heading("Profiles");
  for (const Plot& plot : plots) report.figure(out / (plot.name + ".svg"), "Mean in slabs of equal height.");
  write_file(out / "index.html", report.text());
  return missing;
}

}  // namespace scalebreak

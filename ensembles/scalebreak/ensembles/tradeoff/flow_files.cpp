#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/ensembles/tradeoff/tradeoff_files.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/html.hpp>
#include <scalebreak/output/known.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

const char* word(Method method) { return method_words[static_cast<std::size_t>(method)]; }

Csv csv_of(const FlowTradeoff& study) {
  std::vector<std::string> header = {"method",
                                     "step_fraction [-]",
                                     "step [s]",
                                     "force_evaluations",
                                     "particle_steps",
                                     "wall_time [s]",
                                     "largest_deviation [-]",
                                     "largest_deviation_error [-]",
                                     "on_front"};
  for (const std::string& name : tradeoff_quantities()) header.push_back(name + " [-]"), header.push_back(name + "_error [-]");
  Csv csv(header);
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const FlowPoint& p = study.points[i];
    std::vector<CsvCell> row = {std::string(word(p.method)),
                                p.step_fraction,
                                p.step,
                                known_cell(p.force_evaluations),
                                p.particle_steps,
                                p.seconds,
                                known_cell(p.largest),
                                known_cell(p.largest_error),
                                p.on_front ? 1.0 : 0.0};
    for (const Comparison& c : p.deviations) row.push_back(known_cell(c.relative.value)), row.push_back(known_cell(c.relative.error));
    csv.add(row);
  }
  return csv;
}

/// Columns of csv_of.
constexpr int first_deviation = 10;

std::string column_in_percent(int column) { return fmt::format("(100*${})", column); }

std::vector<Plot> plots_of(const FlowTradeoff& study, const std::string& title) {
  Plot deviations{"deviations",
                  "Deviation from the smallest step: " + title,
                  "step over the Rayleigh time [-]",
                  "deviation with its standard error [%]",
                  true,
                  false,
                  {}};
  Plot front{"front",
             "Deviation from the smallest step over work: " + title,
             "evaluations of contact forces [-]",
             "largest relative deviation of a measured quantity [-]",
             true,
             true,
             {}};
  int style = 1;
  const Method best = study.points[study.reference].method;
  int quantity = 0;
  for (const std::string& name : tradeoff_quantities()) {
    const int column = first_deviation + 2 * quantity++;
    deviations.curves.push_back({"tradeoff.csv", "2", column_in_percent(column), fmt::format("{}, {}", name, word(best)), true, style++,
                                 fmt::format("strcol(1) eq '{}'", word(best)), column_in_percent(column + 1)});
  }
  style = 1;
  for (const char* method : method_words) {
    const bool there = std::any_of(study.points.begin(), study.points.end(),
                                   [&](const FlowPoint& point) { return std::string(word(point.method)) == method; });
    if (!there) continue;
    const std::string only = fmt::format("strcol(1) eq '{}' && $7 > 0", method);
    front.curves.push_back({"tradeoff.csv", "4", "7", fmt::format("{}, deviation", method), true, style, only});
    front.curves.push_back({"tradeoff.csv", "4", "8", fmt::format("{}, standard error of it", method), false, style++, only});
  }
  return {deviations, front};
}

}  // namespace

std::vector<std::string> write_tradeoff(const FlowTradeoff& study, const std::string& title, const std::filesystem::path& out) {
  write_file(out / "tradeoff.csv", csv_of(study).text());
  std::vector<std::string> missing;
  const std::vector<Plot> plots = plots_of(study, title);
  for (const Plot& plot : plots) {
    if (!draw(plot, out)) missing.push_back(plot.name);
  }
  const FlowPoint& reference = study.points[study.reference];
  HtmlReport report("Accuracy against cost: " + title,
                    fmt::format("The flow at several steps, beside {} at {:g} of the Rayleigh time, {:.4g} s.", word(reference.method),
                                reference.step_fraction, reference.step));
  report.paragraph(
      "How to read it: a bar that does not reach 0 is a step, or an integrator, that the flow sees; of six quantities one is by chance beyond twice its "
      "standard error in one point of four. What to choose: the largest step up to which nothing is beyond, if the errors are as small as the "
      "accuracy that is asked for; else a longer run, or more replicas, first.");
  report.figure(out / "deviations.svg", "Relative deviations with their standard errors, the reference's included.");
  report.figure(out / "front.svg", "Where a deviation is below its standard error, the runs are too short to see it.");
  std::vector<std::vector<std::string>> rows;
  for (const FlowPoint& p : study.points) {
    std::vector<std::string> row = {word(p.method), fmt::format("{:g}", p.step_fraction), fmt::format("{:.3g}", p.force_evaluations),
                                    fmt::format("{:.2g}", p.seconds)};
    for (const Comparison& c : p.deviations)
      row.push_back(std::isfinite(c.relative.value) ? fmt::format("{:+.2f} ± {:.2f}", 100 * c.relative.value, 100 * c.relative.error)
                                                    : "-");
    rows.push_back(row);
  }
  std::vector<std::string> header = {"method", "step fraction", "force evaluations", "wall time [s]"};
  for (const std::string& name : tradeoff_quantities()) header.push_back(name + " [%]");
  report.table(header, rows);
  write_file(out / "index.html", report.text());
  return missing;
}

}  // namespace scalebreak

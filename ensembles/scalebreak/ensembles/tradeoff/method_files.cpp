#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/tradeoff/tradeoff_files.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/html.hpp>
#include <scalebreak/output/known.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

constexpr double margin = 1.4;        ///< of lines beyond the marks, on an axis of logarithms
constexpr double least_drawn = 1e-4;  ///< of an error, on an axis of logarithms

CsvCell filled(double value) { return known_cell(value); }
CsvCell filled(const std::string& text) { return text.empty() ? CsvCell() : CsvCell(text); }

/// Columns of csv_of that plots take, from 1.
constexpr const char *error_column = "10", *bar_columns = "12:13", *work_column = "18", *time_column = "19";

/// Root mean square about the mean flow [m/s]; of a bed what is left of its motion.
double fluctuation_speed(const CellResult& result) {
  const Quantity* temperature = result.quantity("temperature");
  return temperature ? std::sqrt(3 * temperature->measured.value) : std::nan("");
}

Csv csv_of(const MethodTradeoff& study, std::uint64_t seed) {
  std::vector<std::string> header = {"series",
                                     "engine",
                                     "law",
                                     "factor [-]",
                                     "keep",
                                     "step_fraction [-]",
                                     "seed",
                                     "replicas",
                                     "in_reference",
                                     "error [-]",
                                     "error_error [-]",
                                     "error_low [-]",
                                     "error_high [-]",
                                     "worst",
                                     "told",
                                     "judged_error [-]",
                                     "statistical_error [-]",
                                     "work",
                                     "processor_time [s]",
                                     "on_work_front",
                                     "on_time_front",
                                     "automatic",
                                     "particles",
                                     "run_evaluations",
                                     "run_lookups",
                                     "run_sphere_steps",
                                     "run_wall_time [s]",
                                     "run_processor_time [s]",
                                     "patch_fraction [-]"};
  for (const std::string& name : study.quantities) header.push_back(name + " [-]"), header.push_back(name + "_error [-]");
  header.insert(header.end(), {"fluctuation_speed [m/s]", "failure", "version"});
  Csv csv(header);
  for (const WayPoint& p : study.points) {
    const CellResult& r = p.result;
    std::vector<CsvCell> row = {p.way.series(),
                                p.way.engine,
                                p.way.law,
                                p.way.factor,
                                filled(p.way.keep),
                                p.way.step_fraction > 0 ? CsvCell(p.way.step_fraction) : CsvCell(),
                                static_cast<double>(seed),
                                static_cast<double>(r.replicas),
                                p.in_reference ? 1.0 : 0.0,
                                filled(p.error),
                                filled(p.error_error),
                                filled(std::isfinite(p.error) ? std::max(least_drawn, p.error - p.error_error) : p.error),
                                filled(p.error + p.error_error),
                                filled(p.worst),
                                p.told ? 1.0 : 0.0,
                                filled(p.judged),
                                filled(p.statistical_error),
                                filled(p.work),
                                filled(p.seconds),
                                p.on_work_front ? 1.0 : 0.0,
                                p.on_time_front ? 1.0 : 0.0,
                                p.way.automatic ? 1.0 : 0.0,
                                r.particles,
                                filled(r.work.evaluations),
                                filled(r.work.lookups),
                                filled(r.work.sphere_steps),
                                r.wall_seconds,
                                filled(r.processor_seconds),
                                r.patch_fraction ? CsvCell(*r.patch_fraction) : CsvCell()};
    for (const std::string& name : study.quantities) {
      const auto c = std::find_if(p.deviations.begin(), p.deviations.end(), [&](const Comparison& each) { return each.name == name; });
      const bool there = c != p.deviations.end();
      row.push_back(there ? filled(c->relative.value) : CsvCell()), row.push_back(there ? filled(c->relative.error) : CsvCell());
    }
    row.push_back(filled(fluctuation_speed(r))), row.push_back(filled(p.failure)), row.push_back(filled(r.version));
    csv.add(row);
  }
  return csv;
}

/// The front as the steps of what can be had for a cost: for the line of a plot.
Csv line_of(const MethodTradeoff& study, bool WayPoint::*on, double WayPoint::*cost, const std::string& header) {
  std::vector<const WayPoint*> front;
  for (const WayPoint& point : study.points) {
    if (point.*on) front.push_back(&point);
  }
  std::sort(front.begin(), front.end(), [&](const WayPoint* a, const WayPoint* b) { return a->*cost < b->*cost; });
  Csv csv({header, "judged_error [-]", "way"});
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (i > 0) csv.add({front[i]->*cost, front[i - 1]->judged, std::string()});
    csv.add({front[i]->*cost, front[i]->judged, front[i]->way.name()});
  }
  double dearest = 0;
  for (const WayPoint& point : study.points) dearest = std::isfinite(point.*cost) ? std::max(dearest, point.*cost) : dearest;
  if (!front.empty()) csv.add({margin * dearest, front.back()->judged, std::string()});
  return csv;
}

Plot plot_of(const MethodTradeoff& study, const std::string& name, const std::string& title, const char* cost, const std::string& label) {
  Plot plot{.name = name,
            .title = title,
            .x_label = label,
            .y_label = "largest relative error of a measured quantity [-]",
            .log_x = true,
            .log_y = true,
            .curves = {{.file = name + ".csv", .x = "1", .y = "2", .title = "front"}}};
  std::vector<std::string> drawn;
  for (const WayPoint& point : study.points) {
    const std::string series = point.way.series();
    if (!std::isfinite(point.error) || !std::isfinite(point.work) || std::find(drawn.begin(), drawn.end(), series) != drawn.end()) continue;
    drawn.push_back(series);
    plot.curves.push_back({.file = "tradeoff.csv",
                           .x = cost,
                           .y = error_column,
                           .title = series,
                           .points = true,
                           .style = static_cast<int>(drawn.size()),
                           .only = fmt::format("strcol(1) eq '{}' && ${} > 0", series, error_column),
                           .error = bar_columns});
  }
  plot.curves.push_back({.file = "tradeoff.csv",
                         .x = fmt::format("(${}/{:g})", cost, margin),
                         .y = fmt::format("({:.6g})", study.resolution),
                         .title = fmt::format("not told apart below {:.2g} %", 100 * study.resolution),
                         .style = 8});
  return plot;
}

std::string number_text(double value) { return std::isfinite(value) ? fmt::format("{:.3g}", value) : "-"; }

void add_points(HtmlReport& report, const MethodTradeoff& study) {
  std::vector<std::vector<std::string>> rows;
  for (const WayPoint& p : study.points) {
    const std::string error = p.worst.empty()
                                  ? std::string("-")
                                  : fmt::format("{} {:.2f} ± {:.2f} %", study_quantity(p.worst).what, 100 * p.error, 100 * p.error_error);
    rows.push_back({p.way.name() + (p.way.automatic ? " (auto)" : ""), p.failure.empty() ? error : p.failure,
                    p.in_reference ? "reference"
                    : p.told       ? ""
                                   : "not told from 0",
                    fmt::format("{}", p.result.replicas), fmt::format("{:.0f}", p.result.particles), number_text(p.work),
                    number_text(p.seconds), fmt::format("{}{}", p.on_work_front ? "work " : "", p.on_time_front ? "time" : "")});
  }
  report.table({"way", "off most", "", "runs", "spheres", "work", "processor time [s]", "on the front of"}, rows);
}

}  // namespace

std::vector<std::string> write_tradeoff(const MethodTradeoff& study, std::uint64_t seed, const std::string& title,
                                        const std::filesystem::path& out) {
  write_file(out / "tradeoff.csv", csv_of(study, seed).text());
  write_file(out / "front_work.csv", line_of(study, &WayPoint::on_work_front, &WayPoint::work, "work").text());
  write_file(out / "front_time.csv", line_of(study, &WayPoint::on_time_front, &WayPoint::seconds, "processor_time [s]").text());
  const std::string equal = "for the same statistics";
  const Plot plots[] = {
      plot_of(study, "front_work", "Error over counted work: " + title, work_column,
              "contact forces evaluated and collisions looked up, " + equal + " [-]"),
      plot_of(study, "front_time", "Error over processor time: " + title, time_column, "processor time of one core, " + equal + " [s]")};
  std::vector<std::string> missing;
  HtmlReport report("Error against cost of all methods: " + title,
                    "Each way to the flow's answer, beside the most accurate ones of the original at its true stiffness.");
  for (const std::string& each : sentences(study)) report.paragraph(each + ".");
  for (const Plot& plot : plots) {
    if (!draw(plot, out)) missing.push_back(plot.name);
    report.figure(out / (plot.name + ".svg"), plot.title + ", " + equal + ", with standard errors.");
  }
  report.paragraph(
      "How to read it: a mark is a way, with the standard error of its error; the lower and the further to the left, the better. The black line is the "
      "front, what no other way beats in both; below the grey line errors are not told apart, and the cheapest way alone is on the front.");
  add_points(report, study);
  report.paragraph("All numbers are in tradeoff.csv, a row a way.");
  write_file(out / "index.html", report.text());
  return missing;
}

}  // namespace scalebreak

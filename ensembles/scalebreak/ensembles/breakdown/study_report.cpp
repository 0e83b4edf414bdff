#include <scalebreak/ensembles/breakdown/study_report.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/ensembles/breakdown/engine_agreement.hpp>
#include <scalebreak/ensembles/breakdown/study_files.hpp>
#include <scalebreak/ensembles/breakdown/study_plots.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>
#include <scalebreak/ensembles/report/run_json.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/html.hpp>

namespace scalebreak {
namespace {

std::string off(const std::optional<Comparison>& c) {
  if (!c) return "-";
  return fmt::format("{} {:+.1f} % ± {:.1f} %", study_quantity(c->name).what, 100 * c->relative.value, 100 * c->relative.error);
}

void add_cells(HtmlReport& report, const StudyResult& study, const std::string& parameter) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyCell& of = study.grid.cells[i];
    const CellResult& cell = study.cells[i];
    const CellVerdict verdict = cell_verdict(cell);
    rows.push_back({of.law, fmt::format("{:g}", of.factor), of.point.name(parameter), of.choice.engine,
                    standing_words[static_cast<std::size_t>(verdict.standing)], cell.failed() ? cell.failure : off(verdict.worst),
                    fmt::format("{}", cell.replicas), fmt::format("{:.0f}", cell.particles), fmt::format("{:.3g}", cell.measured_time),
                    fmt::format("{:.3g}", cell.wall_seconds),
                    cell.patch_fraction ? fmt::format("{:.2g}", *cell.patch_fraction) : std::string("-")});
  }
  report.table({"law", "factor", "point", "engine", "stands", "off most", "runs", "spheres", "measured [s]", "wall time of a run [s]",
                "patch fraction"},
               rows);
}

std::string how_judged() {
  return fmt::format(
      "Each scaled flow is compared with the original at the same point: temperature, rotational energy, collision rate, pressure and shear "
      "stress with what the law claims of them. A law holds where all of these are within {:g} %, two standard errors included, and is broken "
      "where one is beyond by two standard errors; between, the errors are too large to tell.",
      100 * broken_beyond);
}

/// What no law that enlarges can keep, where there are such cells.
std::string why_size_matters(const Input& input, const StudyResult& study) {
  const bool sheared = input.cell.kind == CellKind::shear || input.cell.kind == CellKind::couette;
  const bool enlarged = std::any_of(study.grid.cells.begin(), study.grid.cells.end(),
                                    [](const StudyCell& cell) { return size_factor(*find_scaling_law(cell.law), cell.factor) > 1; });
  if (!sheared || !enlarged) return "";
  return "Spheres that are l times as large at the same shear rate collide at l times the speed: in a steady flow of collisions temperature and "
         "stresses grow as l² whatever the forces are (+300 % at l = 2), and only a flow of lasting contacts, whose stress is given, keeps them.";
}

}  // namespace

std::vector<std::string> write_study(const Input& input, const StudyResult& study, const std::string& title,
                                     const std::filesystem::path& out) {
  const std::string& parameter = input.study.parameter;
  write_file(out / "study.csv", study_csv(study, parameter).text());
  std::vector<std::string> missing;
  HtmlReport report("Where scaling laws break: " + title, how_judged());
  report.paragraph(
      fmt::format("Modelled: {}.{}", modelled(input), study.complete ? "" : " The study was interrupted: not all runs are there."));
  if (const std::string why = why_size_matters(input, study); !why.empty()) report.paragraph(why);
  report.heading("Where they break");
  for (const std::string& each : law_digest(study, parameter)) report.paragraph(each + ".");
  report.heading("How far each law goes");
  for (const LawReach& reach : law_reaches(study)) report.paragraph(sentence(reach, parameter) + ".");
  if (const auto agreements = engine_agreements(study); !agreements.empty()) {
    report.heading("The engines beside each other");
    for (const EngineAgreement& each : agreements) report.paragraph(sentence(each) + ".");
  }
  report.heading("Maps");
  for (const MapPlot& map : deviation_maps(study, parameter, title)) {
    if (!draw(map, out)) missing.push_back(map.name);
    report.figure(out / (map.name + ".svg"), map.title + ": deviation from what the law claims, with its standard error.");
  }
  report.heading("Curves");
  for (const Plot& plot : study_plots(study, parameter, title)) {
    if (!draw(plot, out)) missing.push_back(plot.name);
    report.figure(out / (plot.name + ".svg"), plot.title + ", with standard errors.");
  }
  report.heading("Cells");
  add_cells(report, study, parameter);
  report.paragraph("All numbers are in study.csv, one row for each quantity of each cell.");
  write_file(out / "index.html", report.text());
  return missing;
}

}  // namespace scalebreak

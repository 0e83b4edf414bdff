#include <scalebreak/ensembles/report/run_report.hpp>

#include <scalebreak/ensembles/engine/engine_names.hpp>

#include <cmath>

#include <fmt/format.h>

#include <scalebreak/ensembles/report/profile_plots.hpp>
#include <scalebreak/ensembles/report/run_json.hpp>
#include <scalebreak/measure/flow_csv.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/html.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

/// Columns of series.csv, from 1.
constexpr const char *time_column = "1", *temperature_column = "2", *pressure_column = "8", *shear_stress_column = "11";

std::string title_of(const Input& input) {
  const std::string kind = cell_kind_words[static_cast<std::size_t>(input.cell.kind)];
  if (input.scaling_law == "none" && input.scaling_factor == 1) return kind;
  return fmt::format("{} under {} at {:g}", kind, input.scaling_law, input.scaling_factor);
}

std::vector<Plot> series_plots(const RunOutcome& outcome, const std::string& title) {
  Plot temperature{"temperature", "Granular temperature: " + title, "time [s]", "temperature [m^2/s^2]", false, false, {}};
  Plot stress{"stress", "Stress: " + title, "time [s]", "stress, positive in compression [Pa]", false, false, {}};
  const std::size_t replicas = outcome.replicas.size();
  for (std::size_t k = 0; k < replicas; ++k) {
    const std::string file = (replica_folder("", k, replicas) / "series.csv").string();
    const std::string of = replicas == 1 ? "" : fmt::format(", replica {}", k + 1);
    const int style = static_cast<int>(k);
    temperature.curves.push_back({file, time_column, temperature_column, "temperature" + of, false, style});
    stress.curves.push_back({file, time_column, pressure_column, "pressure" + of, false, 2 * style});
    stress.curves.push_back({file, time_column, shear_stress_column, "stress xz" + of, false, 2 * style + 1});
  }
  return {temperature, stress};
}

void add_numbers(HtmlReport& report, const RunOutcome& outcome) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& name, const std::string& unit, const Measured& m) {
    rows.push_back({name, std::isfinite(m.value) ? fmt::format("{:.6g}", m.value) : "-",
                    std::isfinite(m.error) ? fmt::format("{:.2g}", m.error) : "-", unit});
  };
  for (const Quantity& q : outcome.measured.quantities) add(q.name, q.unit, q.measured);
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2})
      add("stress " + tensor_entry_name(i, j), "Pa", {outcome.measured.stress.value(i, j), outcome.measured.stress.error(i, j)});
  }
  report.table({"quantity", "mean", "standard error", "unit"}, rows);
}

std::string how_it_flew(const RunRecord& run) {
  if (!run.patches) return "Event-driven engine";
  return fmt::format("Hybrid engine, {:.3g} of all contacts in {} patches of spheres, {} handovers to or from soft spheres alone",
                     run.patches->contact_starts / run.contact_starts, run.patches->begun, run.handovers);
}

std::string what_ran(const RunOutcome& outcome) {
  const RunRecord& run = outcome.replicas.front();
  if (flies(run.engine))
    return fmt::format(
        "{} spheres in a cell of {:g} × {:g} × {:g} m, volume fraction {:.4g}. {}, {} events, of which {} no table answered, {:.4g} s of "
        "which {:.4g} s are measured. {:.3g} s of wall time, {:.3g} events per second.",
        run.particles, run.cell.x(), run.cell.y(), run.cell.z(), run.volume_fraction, how_it_flew(run), run.events.value_or(0),
        run.integrated.value_or(0), run.time, outcome.measured.duration, outcome.wall_seconds,
        static_cast<double>(outcome.events()) / outcome.wall_seconds);
  return fmt::format(
      "{} spheres in a cell of {:g} × {:g} × {:g} m, volume fraction {:.4g}. Soft-sphere engine, {} steps of {:.4g} s (limited by {}; the smallest bound "
      "is that of the {}, {:.4g} s), {:.4g} s of which {:.4g} s are measured. {:.3g} s of wall time on {} threads, {:.3g} particle steps per second.",
      run.particles, run.cell.x(), run.cell.y(), run.cell.z(), run.volume_fraction, run.steps, run.schedule.step, run.step.limit,
      run.step.bound, run.step.bound_step, run.time, outcome.measured.duration, outcome.wall_seconds, outcome.threads,
      outcome.particle_steps() / outcome.wall_seconds);
}

}  // namespace

std::string in_words(const Quantity& quantity) {
  const Measured& m = quantity.measured;
  const std::string unit = quantity.unit == "-" ? "" : " " + quantity.unit;
  if (!std::isfinite(m.value)) return "nothing to tell";
  if (!std::isfinite(m.error)) return fmt::format("{:.6g}{}, the run is too short to tell its error", m.value, unit);
  return fmt::format("{:.6g} ± {:.2g}{}", m.value, m.error, unit);
}

std::vector<std::string> write_run_report(const Input& input, const RunOutcome& outcome, const std::filesystem::path& out) {
  const std::string title = title_of(input);
  std::vector<Plot> plots = series_plots(outcome, title);
  const bool walls = input.cell.boundary[2] == Boundary::wall;
  if (walls) {
    const std::string csv = profile_csv(outcome.measured.profile).text();
    for (const Plot& plot : profile_plots(csv.substr(0, csv.find('\n')), {{"profiles.csv", "mean over the measurement"}}, title))
      plots.push_back(plot);
  }
  std::vector<std::string> missing;
  for (const Plot& plot : plots) {
    if (!draw(plot, out)) missing.push_back(plot.name);
  }

  HtmlReport report("A flow: " + title, what_ran(outcome));
  report.paragraph("Modelled: " + modelled(input) + ".");
  if (const ShortestContact& contact = outcome.replicas.front().step.contact; contact.time > 0)
    report.paragraph(fmt::format("The shortest contact is that of {} at {:.4g} m/s ({}): {:.4g} s, by {}.", contact.of,
                                 contact.meeting.speed, contact.meeting.of, contact.time, contact_time_source(contact)));
  for (const RunRecord& run : outcome.replicas) {
    for (const std::string& warning : run.warnings) report.paragraph("Warning: " + warning + ".");
  }
  report.heading("What was measured");
  report.paragraph(
      outcome.replicas.size() == 1
          ? "Means over the time after the warm-up. A dash: there is nothing to tell, or the run is too short to tell the error."
          : fmt::format("Means over {} replicas, with the error from how they differ.", outcome.replicas.size()));
  add_numbers(report, outcome);
  report.heading("In time");
  report.figure(out / "temperature.svg", "Granular temperature at every row of series.csv, the warm-up included.");
  report.figure(out / "stress.svg", "Pressure and shear stress at every row; a single state of few contacts fluctuates.");
  if (walls) {
    report.heading("Over the height");
    for (std::size_t k = 2; k < plots.size(); ++k) report.figure(out / (plots[k].name + ".svg"), "Mean in slabs of equal height.");
  }
  write_file(out / "index.html", report.text());
  return missing;
}

}  // namespace scalebreak

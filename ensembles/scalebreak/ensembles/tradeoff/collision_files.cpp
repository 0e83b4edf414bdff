#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/ensembles/tradeoff/collision_choice.hpp>
#include <scalebreak/ensembles/tradeoff/tradeoff_files.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/html.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

CsvCell cell(const std::optional<double>& value) { return value ? CsvCell(*value) : CsvCell(); }

Csv csv_of(const std::vector<CollisionPoint>& points) {
  Csv csv({"method", "setting [-]", "step [s]", "phases", "unparted", "motion_error_rms [-]", "motion_error_largest [-]",
           "energy_gain_mean [-]", "contact_time_error_rms [-]", "contact_time_error_largest [-]", "force_evaluations", "wall_time [s]"});
  for (const CollisionPoint& p : points)
    csv.add({std::string(p.method->name()), p.setting, p.step > 0 ? CsvCell(p.step) : CsvCell(), static_cast<double>(p.phases),
             static_cast<double>(p.unparted), p.motion_rms, p.motion_largest, p.energy_mean, cell(p.time_rms), cell(p.time_largest),
             p.force_evaluations, p.seconds});
  return csv;
}

std::vector<CollisionPoint> front_of(const CollisionTradeoff& study) {
  std::vector<CollisionPoint> front;
  for (const CollisionPoint& point : study.points) {
    if (point.on_front) front.push_back(point);
  }
  std::sort(front.begin(), front.end(), [](const auto& a, const auto& b) { return a.force_evaluations < b.force_evaluations; });
  return front;
}

/// The column of a header of csv_of.
constexpr const char *step_fraction = "($3 > 0 ? $2 : NaN)", *motion_rms = "6", *motion_largest = "7", *energy_gain = "(abs($8))",
                     *time_rms = "9", *evaluations = "11", *wall_time = "(1e6*$12)";

std::vector<Plot> plots_of(const CollisionTradeoff& study, const std::string& title) {
  Plot steps{"convergence",
             "Error of a collision over the step: " + title,
             "step over the Rayleigh time [-]",
             "relative error [-]",
             true,
             true,
             {}};
  Plot work{"front",
            "Error of a collision over its work: " + title,
            "evaluations of the contact force [-]",
            "root mean square error over the impact speed [-]",
            true,
            true,
            {}};
  Plot wall{"front_wall_time",
            "Error of a collision over its wall time: " + title,
            "wall time of the fastest run [µs]",
            "root mean square error over the impact speed [-]",
            true,
            true,
            {}};
  int style = 1;
  for (const CollisionMethod& method : collision_methods()) {
    const bool there =
        std::any_of(study.points.begin(), study.points.end(), [&](const CollisionPoint& point) { return point.method == &method; });
    if (!there) continue;
    const std::string only = fmt::format("strcol(1) eq '{}'", method.name()), name = method.name();
    const auto curve = [&](const char* x, const char* y, const std::string& what, bool points) {
      return Curve{"tradeoff.csv", x, y, what, points, style, only};
    };
    if (method.steps) {
      steps.curves.push_back(curve(step_fraction, motion_rms, name + ": root mean square", true));
      steps.curves.push_back(curve(step_fraction, motion_rms, "", false));
      steps.curves.push_back(curve(step_fraction, motion_largest, name + ": largest", false));
      ++style;
      steps.curves.push_back(curve(step_fraction, energy_gain, name + ": mean energy change", true));
      if (study.contact_time) {
        ++style;
        steps.curves.push_back(curve(step_fraction, time_rms, name + ": contact time", true));
      }
    }
    const int own = 1 + static_cast<int>(&method - collision_methods().data());
    work.curves.push_back({"tradeoff.csv", evaluations, motion_rms, name, true, own, only});
    wall.curves.push_back({"tradeoff.csv", wall_time, motion_rms, name, true, own, only});
    ++style;
  }
  work.curves.push_back({"front.csv", evaluations, motion_rms, "front", false, 0});
  return {steps, work, wall};
}

std::string number(const std::optional<double>& value) { return value ? fmt::format("{:.2e}", *value) : "-"; }

void add_table(HtmlReport& report, const CollisionTradeoff& study) {
  std::vector<std::vector<std::string>> rows;
  for (const CollisionPoint& p : study.points)
    rows.push_back({p.method->name(), fmt::format("{:g}", p.setting), fmt::format("{:.2e}", p.motion_rms),
                    fmt::format("{:.2e}", p.motion_largest), fmt::format("{:+.1e}", p.energy_mean), number(p.time_rms),
                    fmt::format("{:.1f}", p.force_evaluations), fmt::format("{:.1f}", 1e6 * p.seconds),
                    fmt::format("{} of {}", p.unparted, p.phases), p.on_front ? "yes" : ""});
  report.table({"method", "setting", "error, rms", "largest", "energy gained, mean", "contact time, rms", "force evaluations",
                "wall time [µs]", "not parted", "on the front"},
               rows);
}

}  // namespace

std::string in_words(const ConvergenceOrder& order, const std::string& setting_name) {
  if (!std::isfinite(order.order)) return "too few settings to tell";
  return fmt::format("error ∝ {}^({:.2f} ± {:.2f})", setting_name, order.order, order.error);
}

std::vector<std::string> write_tradeoff(const CollisionTradeoff& study, const std::string& title, const std::filesystem::path& out) {
  write_file(out / "tradeoff.csv", csv_of(study.points).text());
  write_file(out / "front.csv", csv_of(front_of(study)).text());
  std::vector<std::string> missing;
  const std::vector<Plot> plots = plots_of(study, title);
  for (const Plot& plot : plots) {
    if (!draw(plot, out)) missing.push_back(plot.name);
  }
  HtmlReport report(
      "Accuracy against cost: " + title,
      fmt::format("One collision by each method at each setting, beside the exact engine at a tolerance of {:g}. Errors are the "
                  "largest of a body's velocity and surface speed, over the largest relative speed at the start, {:.4g} m/s.",
                  reference_tolerance, study.speed));
  report.heading("Order of convergence");
  for (const CollisionConvergence& c : study.convergence) {
    report.paragraph(fmt::format("{}: {}; of the contact time: {}.", c.method->name(), in_words(c.motion, c.method->setting),
                                 in_words(c.contact_time, c.method->setting)));
  }
  report.paragraph(
      "What it shows: the error of the soft-sphere engine's collisions over its step. How to read it: the slope of a line is its order. What to "
      "choose: the largest step whose error is allowed; a flow, in which collisions begin anywhere in a step, sees the mean, as of the energy "
      "gained, which is smaller.");
  report.figure(out / "convergence.svg", "Over the phases of a step at which the collision begins.");
  report.heading("Front");
  report.paragraph(
      "What it shows: the error of each method at each of its settings, over what it costs; exact is the exact engine, and so are the methods that "
      "are named after a stepper. How to read it: a mark is better the lower and the further to the left; the line is the front, what no other "
      "mark beats in both. What to choose, by wall time:");
  for (const std::string& each : choices(study)) report.paragraph(each + ".");
  report.figure(out / "front.svg", "Work counted: a contact's force, each time that it is evaluated; a lookup and a formula are one.");
  report.figure(out / "front_wall_time.svg", "The same by wall time on this machine.");
  for (const std::string& each : study.refusals) report.paragraph(each + ".");
  add_table(report, study);
  write_file(out / "index.html", report.text());
  return missing;
}

}  // namespace scalebreak

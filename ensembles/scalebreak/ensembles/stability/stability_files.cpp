#include <scalebreak/ensembles/stability/stability_files.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/version.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/html.hpp>
#include <scalebreak/output/known.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

/// The step over the original's.
Measured ratio(const StabilityStudy& study, const StabilityRecord& record) {
  const Measured step = record.step(), original = study.original_of(record).step();
  const double value = step.value / original.value;
  return {value, value * std::hypot(step.error / step.value, original.error / original.value)};
}

/// NaN of a contact that does not end.
double steps_per_contact(const StabilityRecord& record) {
  return record.contact.time > 0 ? record.contact.time / record.step().value : std::nan("");
}

std::string method_of(const StabilityRecord& record) { return fmt::format("{}, {}", record.law, record.integrator); }

/// What a trial was judged by; NaN where it was stopped, or of another criterion.
double judged_by(const StabilityCriterion& criterion, const StabilityRecord& record, const StepTrial& trial) {
  return record.criterion != criterion.name || !trial.stopped.empty() ? std::nan("") : criterion.of(trial);
}

/// The numbers of a record, in the order of stability.csv.
struct Column {
  const char *name, *unit;
  double (*of)(const StabilityStudy&, const StabilityRecord&);
};
constexpr Column columns[] = {
    {"step", "s", [](const StabilityStudy&, const StabilityRecord& r) { return r.step().value; }},
    {"step_error", "s", [](const StabilityStudy&, const StabilityRecord& r) { return r.step().error; }},
    {"fraction_of_rayleigh", "-", [](const StabilityStudy&, const StabilityRecord& r) { return r.fraction().value; }},
    {"fraction_of_rayleigh_error", "-", [](const StabilityStudy&, const StabilityRecord& r) { return r.fraction().error; }},
    {"rayleigh_step", "s", [](const StabilityStudy&, const StabilityRecord& r) { return r.rayleigh; }},
    {"oscillation_step", "s",
     [](const StabilityStudy&, const StabilityRecord& r) { return r.oscillation > 0 ? r.oscillation : std::nan(""); }},
    {"contact_time", "s", [](const StabilityStudy&, const StabilityRecord& r) { return r.contact.time; }},
    {"steps_per_contact", "-", [](const StabilityStudy&, const StabilityRecord& r) { return steps_per_contact(r); }},
    {"step_ratio", "-", [](const StabilityStudy& study, const StabilityRecord& r) { return ratio(study, r).value; }},
    {"step_ratio_error", "-", [](const StabilityStudy& study, const StabilityRecord& r) { return ratio(study, r).error; }},
    {"value_below", "-", [](const StabilityStudy&, const StabilityRecord& r) { return r.value_below(); }},
    {"value_above", "-", [](const StabilityStudy&, const StabilityRecord& r) { return r.value_above(); }},
    {"seeds", "-", [](const StabilityStudy&, const StabilityRecord& r) { return static_cast<double>(r.seeds.size()); }},
    {"seeds_without_bracket", "-",
     [](const StabilityStudy&, const StabilityRecord& r) { return static_cast<double>(r.without_bracket()); }},
};

/// Columns of stability.csv and of trials.csv, from 1, that the plots read.
constexpr const char *factor_column = "2", *step_column = "5", *step_error_column = "6";
constexpr const char* trial_fraction_column = "6";
constexpr std::size_t first_trial_value = 8;  ///< a column for each criterion

Plot step_plot(const StabilityStudy& study) {
  const std::string criterion = study.criteria.front().name;
  Plot plot{"largest_step", "Largest stable step over the factor", "factor [-]", "largest stable step [s]", true, true, {}};
  std::vector<std::string> seen;
  for (const StabilityRecord& record : study.records) {
    const std::string name = method_of(record) + (record.criterion == criterion ? "" : ", " + record.criterion);
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) continue;
    seen.push_back(name);
    plot.curves.push_back({.file = "stability.csv",
                           .x = factor_column,
                           .y = step_column,
                           .title = name,
                           .points = true,
                           .style = static_cast<int>(plot.curves.size()),
                           .only = fmt::format("strcol(1) eq '{}' && strcol(3) eq '{}' && strcol(4) eq '{}'", record.law, record.integrator,
                                               record.criterion),
                           .error = step_error_column});
  }
  return plot;
}

Plot trial_plot(const StabilityStudy& study, std::size_t which) {
  const StabilityCriterion& criterion = study.criteria[which];
  Plot plot{criterion.name, criterion.plot, "step / Rayleigh time [-]", criterion.axis, true, true, {}};
  for (const StabilityRecord& record : study.records) {
    if (record.criterion != criterion.name) continue;
    plot.curves.push_back({.file = "trials.csv",
                           .x = trial_fraction_column,
                           .y = fmt::format("{}", first_trial_value + which),
                           .title = fmt::format("{} at {:g}", method_of(record), record.factor),
                           .points = true,
                           .style = static_cast<int>(plot.curves.size()),
                           .only = fmt::format("strcol(1) eq '{}' && ${} == {:.17g} && strcol(3) eq '{}' && strcol(4) eq '{}'", record.law,
                                               factor_column, record.factor, record.integrator, record.criterion)});
  }
  return plot;
}

std::string introduction(const Input& input, const StabilityStudy& study) {
  if (!study.flow)
    return fmt::format(
        "One collision at {:g} m/s. A step counts as stable while no body's velocity or surface speed after it is off by more than {:g} of that "
        "speed, at {} points of a step at which it begins, and all part that should{}. It is bisected to 2 %.",
        study.speed, input.study_motion_error, input.tradeoff.phases,
        study.criteria.size() > 1
            ? "; by rolling_left, while bodies that have stopped rolling on each other roll at no more than the same share of it"
            : "");
  return fmt::format(
      "{} spheres that move at {:g} m/s (root mean square) at the start, made elastic: no dissipation, adhesion, friction, shear or gravity. "
      "A step counts as stable while the energy grows by at most {:g} per collision of each sphere, over {:g} collisions of each. It is "
      "bisected to 2 %, for {} seeds each.",
      study.spheres, study.speed, input.study_energy_growth, collisions_of_a_trial, input.run.replicas);
}

}  // namespace

std::string stability_csv(const StabilityStudy& study) {
  std::vector<std::string> header = {"law", "factor [-]", "integrator", "criterion"};
  for (const Column& column : columns) header.push_back(fmt::format("{} [{}]", column.name, column.unit));
  header.emplace_back("failure");
  Csv csv(header);
  for (const StabilityRecord& r : study.records) {
    std::vector<CsvCell> row = {r.law, r.factor, r.integrator, r.criterion};
    for (const Column& column : columns) row.push_back(known_cell(column.of(study, r)));
    row.emplace_back(r.failure());
    csv.add(row);
  }
  return csv.text();
}

std::string trials_csv(const StabilityStudy& study) {
  std::vector<std::string> header = {"law", "factor [-]", "integrator", "criterion", "seed", "fraction_of_rayleigh [-]", "step [s]"};
  for (const StabilityCriterion& criterion : study.criteria) header.push_back(fmt::format("{} [-]", criterion.name));
  header.insert(header.end(), {"collisions [-]", "stopped"});
  Csv csv(header);
  for (const StabilityRecord& r : study.records) {
    for (std::size_t seed = 0; seed < r.seeds.size(); ++seed) {
      for (const StepTrial& trial : r.seeds[seed].tried) {
        std::vector<CsvCell> row = {r.law, r.factor, r.integrator, r.criterion, static_cast<double>(seed), trial.fraction, trial.step};
        for (const StabilityCriterion& criterion : study.criteria) row.push_back(known_cell(judged_by(criterion, r, trial)));
        row.emplace_back(trial.collisions), row.emplace_back(trial.stopped);
        csv.add(row);
      }
    }
  }
  return csv.text();
}

json stability_json(const Input& input, const StabilityStudy& study) {
  json criteria = json::array(), records = json::array();
  for (const StabilityCriterion& criterion : study.criteria)
    criteria.push_back(
        {{"name", criterion.name}, {"unit", criterion.unit}, {"meaning", criterion.meaning}, {"limit", input.*criterion.limit}});
  for (const StabilityRecord& r : study.records) {
    json trials = json::array();
    for (std::size_t seed = 0; seed < r.seeds.size(); ++seed) {
      for (const StepTrial& trial : r.seeds[seed].tried) {
        trials.push_back({{"seed", seed}, {"fraction_of_rayleigh", trial.fraction}, {"stopped", trial.stopped}});
        for (const StabilityCriterion& criterion : study.criteria) {
          if (r.criterion != criterion.name) continue;
          trials.back()[criterion.name] = known_number(judged_by(criterion, r, trial));
        }
      }
    }
    json record = {{"law", r.law}, {"factor", r.factor}, {"integrator", r.integrator}, {"criterion", r.criterion}};
    for (const Column& column : columns) record[column.name] = known_number(column.of(study, r));
    record["failure"] = r.failure(), record["trials"] = trials;
    records.push_back(std::move(record));
  }
  return {{"version", version()},   {"particles", study.spheres}, {"speed", study.speed}, {"collisions", collisions_of_a_trial},
          {"seed", input.run.seed}, {"skipped", study.skipped},   {"criteria", criteria}, {"records", records}};
}

std::string in_words(const StabilityStudy& study, const StabilityRecord& r) {
  const Measured step = r.step(), fraction = r.fraction(), over_original = ratio(study, r);
  std::string text = fmt::format("{:<16} at {:<8g} {:<13}", r.law, r.factor, r.integrator);
  if (!std::isfinite(step.value))
    return text + fmt::format("no bracket: {}", r.seeds.front().stable ? "stable at every step tried" : "unstable at every step tried");
  text += fmt::format("{:.4g} ± {:.1g} s, {:.3f} of Rayleigh's {:.4g} s", step.value, step.error, fraction.value, r.rayleigh);
  if (r.oscillation > 0) text += fmt::format(", {:.3f} of the oscillation's {:.4g} s", step.value / r.oscillation, r.oscillation);
  if (r.contact.time > 0) text += fmt::format(", {:.1f} steps per contact", steps_per_contact(r));
  return text + fmt::format("; {:.3f} ± {:.3f} of the original's; {} {:.2g} below, {:.2g} above; {}", over_original.value,
                            over_original.error, r.criterion, r.value_below(), r.value_above(), r.failure());
}

std::vector<std::string> write_stability_report(const Input& input, const StabilityStudy& study, const std::filesystem::path& out) {
  write_file(out / "stability.csv", stability_csv(study));
  write_file(out / "trials.csv", trials_csv(study));
  std::vector<Plot> plots = {step_plot(study)};
  for (std::size_t which = 0; which < study.criteria.size(); ++which) plots.push_back(trial_plot(study, which));
  std::vector<std::string> missing;
  for (const Plot& plot : plots) {
    if (!draw(plot, out)) missing.push_back(plot.name);
  }
  HtmlReport report("The largest stable step", introduction(input, study));
  report.figure(out / "largest_step.svg",
                "Bars: half the bracket of the bisection, or the standard error over seeds, whichever is larger.");
  for (const StabilityCriterion& criterion : study.criteria) {
    const char* trials = criterion.at_rest ? "Every trial." : "Every trial in which all parted that should.";
    report.figure(out / (std::string(criterion.name) + ".svg"),
                  study.flow ? "Every trial that went on to its end and whose energy grew." : trials);
  }
  report.paragraph(
      "How to read it: a step over Rayleigh's below 1 is one that the Rayleigh time alone would overstep; steps per contact say whether a shorter contact is "
      "the reason; over the original's is how many times larger a step the law buys. What to choose: half of the smallest step in the table at most, and "
      "run.step_bounds, which keeps thirty steps a contact.");
  std::vector<std::vector<std::string>> rows;
  for (const StabilityRecord& r : study.records)
    rows.push_back({r.law, fmt::format("{:g}", r.factor), r.integrator, r.criterion,
                    fmt::format("{:.4g} ± {:.1g}", r.step().value, r.step().error), fmt::format("{:.3f}", r.fraction().value),
                    std::isfinite(steps_per_contact(r)) ? fmt::format("{:.1f}", steps_per_contact(r)) : std::string("-"),
                    fmt::format("{:.3f}", ratio(study, r).value), r.failure()});
  report.table({"law", "factor", "integrator", "by", "largest stable step [s]", "over Rayleigh's", "steps per contact",
                "over the original's", "beyond it"},
               rows);
  write_file(out / "index.html", report.text());
  return missing;
}

}  // namespace scalebreak

#include <scalebreak/collisions/invariance/invariance_report.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/invariance/invariance_examples.hpp>
#include <scalebreak/collisions/invariance/invariance_files.hpp>
#include <scalebreak/collisions/invariance/invariance_oblique.hpp>
#include <scalebreak/collisions/invariance/invariance_words.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

CsvCell cell(const std::optional<double>& value) { return value ? CsvCell(*value) : CsvCell(); }

/// e(v) of the original by table, densely, and how far it is from the exact engine.
struct TableCheck {
  std::string csv;
  double largest = 0;
  long looked_up = 0, exact = 0;
};

TableCheck check_table(const InvarianceChapter& chapter) {
  const ScaledContact original(chapter.input.contact, chapter.input.colliding(), *find_scaling_law("none"), 1);
  CollisionSource source(chapter.table->table, original.reduced(1.0).damping_ratio, 1e-10);
  const auto [low, high] = std::minmax_element(chapter.study.speeds.begin(), chapter.study.speeds.end());
  Csv csv({"normal_speed [m/s]", "restitution_normal [-]", "restitution_exact [-]", "contact_time [s]"});
  TableCheck check;
  constexpr int points = 300;
  for (int i = 0; i <= points; ++i) {
    const double speed = *low * std::pow(*high / *low, i / static_cast<double>(points));
    const ReducedCollision problem = original.reduced(speed);
    const TableOutcome outcome = source.collide(problem.speed);
    const PairCollision exact = original.collide(speed, 1e-10);
    check.largest = std::max(check.largest, std::abs(outcome.restitution * outcome.restitution - exact.restitution * exact.restitution));
    csv.add({speed, outcome.restitution, exact.restitution,
             cell(outcome.stuck ? std::optional<double>() : outcome.contact_time * problem.scales.time)});
  }
  check.csv = csv.text(), check.looked_up = source.looked_up(), check.exact = source.resolved_exactly();
  return check;
}

/// Force over overlap of original and scaled in Washino's variables (2024, eqs 79–83): overlap over (m*v²/(E*√R*))^{2/5},
/// force over m*v² by that length. In them a law that is exact falls on the original.
std::string loops_csv(const InvarianceChapter& chapter, double speed) {
  Csv csv({"law", "factor [-]", "overlap_reduced [-]", "force_reduced [-]"});
  const auto add = [&](const std::string& name, const ScalingLaw& law, double factor) {
    const Bodies scaled_system = scaled_bodies(law, factor, chapter.input.colliding(), chapter.input.contact.normal);
    const ScaledContact contact(chapter.input.contact, chapter.input.colliding(), law, factor);
    const NormalPair& pair = contact.scaled().pair;
    const auto impact = reduce(effective_kind(contact.kind(), 0), pair, speed).scales;
    const double length = impact.overlap * contact.scaled().overlap;
    const double force = scaled_system.pair().mass * speed * speed / length;
    for (const TrajectoryPoint& p : contact.trajectory(speed, 1e-8, 150))
      csv.add({name, factor, p.overlap / length, (p.elastic_force + p.damping_force) / force});
  };
  add("original", *find_scaling_law("none"), 1);
  for (const Example& e : examples(chapter.study, false)) add(std::string(e.law->name), *e.law, e.factor);
  return csv.text();
}

std::string legend(const Example& e) { return fmt::format("{}, {:g}", e.law->name, e.factor); }
std::string only(const Example& e) { return fmt::format("strcol(1) eq '{}' && $2 == {}", e.law->name, e.factor); }

bool exact(const InvarianceStudy& study, const Example& e) {
  return std::any_of(study.summaries.begin(), study.summaries.end(),
                     [&](const LawSummary& s) { return s.law == e.law->name && s.softer == (e.factor < 1) && s.exact; });
}

std::vector<Plot> plots(const InvarianceChapter& chapter, double loop_speed) {
  const InvarianceStudy& study = chapter.study;
  const std::string title = readable(chapter.title);
  Plot e{"restitution",
         "Restitution of original and scaled pairs: " + title,
         "impact speed [m/s]",
         "coefficient of restitution [-]",
         true,
         false,
         {}};
  if (study.wet) {
    const Example first = examples(study, true).front();
    e.curves.push_back({"invariance.csv", "3", "6", "original", false, 0, only(first)});
  } else {
    e.curves.push_back({"restitution.csv", "1", "2", "original (table)"});
  }
  Plot time{"contact_time", "Contact time, scaled over original: " + title, "impact speed [m/s]", "contact time ratio [-]", true, true, {}};
  for (const Example& x : examples(study, true)) {
    e.curves.push_back({"invariance.csv", "3", "5", legend(x), true, x.style, only(x)});
    time.curves.push_back({"invariance.csv", "3", "8", legend(x), true, x.style, only(x)});
  }
  std::vector<Plot> all{e, time};
  if (study.wet) return all;
  Plot loops{"force_overlap",
             fmt::format("Force and overlap at {:.3g} m/s: {}", loop_speed, title),
             "overlap over (m*v^2/(E*R*^{{1/2}}))^{{2/5}} [-]",
             "force over m*v^2 by that length [-]",
             false,
             false,
             {}};
  loops.curves.push_back({"loops.csv", "3", "4", "original", false, 0, "strcol(1) eq 'original'"});
  for (const Example& x : examples(study, false))
    loops.curves.push_back({"loops.csv", "3", "4", legend(x), exact(study, x), x.style, only(x)});
  all.push_back(loops);
  if (study.sticking_speed && *study.sticking_speed > 0) {
    Plot stick{"sticking_speed",
               "Sticking speed, scaled over original: " + title,
               "factor: stiffness ratio below 1, size ratio above [-]",
               "sticking speed ratio [-]",
               true,
               true,
               {}};
    for (const Example& x : examples(study, true)) {
      stick.curves.push_back({"invariance.csv", "2", "11", std::string(x.law->name) + (x.factor < 1 ? ", softer" : ", larger"), true,
                              x.style, fmt::format("strcol(1) eq '{}' && ($2 < 1) == {:d}", x.law->name, x.factor < 1)});
    }
    all.push_back(stick);
  }
  return all;
}

}  // namespace

bool write_chapter(const InvarianceChapter& chapter, const std::filesystem::path& folder, HtmlReport& report) {
  const InvarianceStudy& study = chapter.study;
  const double loop_speed =
      study.sticking_speed && *study.sticking_speed > 0 ? 2 * *study.sticking_speed : study.speeds[study.speeds.size() / 2];
  write_file(folder / "invariance.csv", records_csv(study));
  write_file(folder / "summary.csv", summary_csv(study));
  TableCheck check;
  if (!study.wet) {
    check = check_table(chapter);
    write_file(folder / "restitution.csv", check.csv);
    write_file(folder / "loops.csv", loops_csv(chapter, loop_speed));
  }
  bool drawn = true;
  for (const Plot& plot : plots(chapter, loop_speed)) drawn = draw(plot, folder) && drawn;

  report.heading(readable(chapter.title));
  const NormalPair pair = chapter.input.colliding().pair();
  report.paragraph(fmt::format(
      "{}: R* = {:.4g} m, m* = {:.4g} kg, E* = {:.4g} Pa, surface energy (of one surface) {:.4g} J/m². Modelled: contact law {}.{}",
      chapter.input.against_wall ? "A sphere and a flat wall" : "Two spheres", pair.radius, pair.mass, pair.young, pair.surface_energy,
      to_string(effective_kind(chapter.input.contact, pair.surface_energy)),
      study.wet              ? std::string(" A liquid acts: all below is of the exact motion with it.")
      : study.sticking_speed ? fmt::format(" Sticking speed of the original: {:.5g} m/s.", *study.sticking_speed)
                             : " Nothing adheres."));
  if (!study.wet) {
    const TableQuality& quality = chapter.table->table.quality();
    report.paragraph(fmt::format(
        "Collision table: {} × {} nodes, measured error {:.1e} (largest, in e² and relative contact time, {} fresh collisions), "
        "{}. Along the curve below it differs from the exact engine by at most {:.1e} in e²; {} of {} points were looked up, {} "
        "resolved exactly.",
        chapter.table->table.damping_axis().count, chapter.table->table.speed_axis().count, quality.error_max, quality.samples,
        chapter.table->built ? fmt::format("built in {:.2f} s", chapter.table->build_seconds) : std::string("read from the cache"),
        check.largest, check.looked_up, check.looked_up + check.exact, check.exact));
  }
  if (study.motion) report.paragraph(motion_introduction(chapter.input));
  std::vector<std::vector<std::string>> rows;
  for (const LawSummary& s : study.summaries) {
    rows.push_back({full_name(s), s.exact ? "yes" : "no",
                    s.restitution_change < kept_tolerance ? "kept" : fmt::format("up to {:.3g}", s.restitution_change),
                    verdict(s.sticking_speed), verdict(s.contact_time), verdict(s.max_overlap)});
  }
  report.table({"law", study.motion ? "normal contact exact" : "exact for the pair", "restitution change", "sticking speed", "contact time",
                "largest overlap"},
               rows);
  if (study.motion) report_motion(study, report);
  for (const LawSummary& s : study.summaries) report.paragraph(in_words(s));
  report.figure(folder / "restitution.svg",
                "Restitution over impact speed: the original (line) and every law at its factor farthest from 1 (marks). A law whose marks "
                "lie on the line keeps the collision; 0 means that the pair sticks.");
  report.figure(folder / "contact_time.svg",
                "Contact time of the scaled pair over the original's: a horizontal row of marks is one power of the factor. Long contacts "
                "are where scaled flows break first when they are crowded.");
  if (study.sticking_speed && *study.sticking_speed > 0)
    report.figure(folder / "sticking_speed.svg",
                  "Sticking speed over the original's, against the factor: 1 is kept. Above 1 the scaled particles are stickier than the "
                  "real ones.");
  if (!study.wet)
    report.figure(folder / "force_overlap.svg",
                  "Force against overlap in the variables of the impact (Washino et al. 2024, eqs 79–83): laws that are exact for the pair "
                  "(marks) fall on the original, the others (lines) do not. Every law at its factor nearest to 1.");
  return write_oblique_charts(chapter.input, study, chapter.title, folder, chapter.threads, report) && drawn;
}

}  // namespace scalebreak

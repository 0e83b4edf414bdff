#include <scalebreak/collisions/invariance/invariance_oblique.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/collisions/invariance/invariance_examples.hpp>
#include <scalebreak/collisions/invariance/invariance_files.hpp>
#include <scalebreak/collisions/invariance/invariance_words.hpp>
#include <scalebreak/collisions/parallel.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

/// A motion that a chart asks for.
struct Asked {
  const ScalingLaw* law;
  double factor;
  Input input;
};

std::vector<PairMotion> resolve_all(const std::vector<Asked>& asked, int threads) {
  std::vector<PairMotion> motions(asked.size());
  parallel_for(asked.size(), threads, [&](std::size_t i) {
    motions[i] = resolve_motion(asked[i].input, *asked[i].law, asked[i].factor, asked[i].input.tolerance);
  });
  return motions;
}

/// From 1 to `end`, evenly in the logarithm.
std::vector<double> factors_to(double end, int count) {
  std::vector<double> factors;
  for (int i = 0; i < count; ++i) factors.push_back(std::pow(end, i / (count - 1.0)));
  return factors;
}

std::string named(const std::string& name) { return fmt::format("strcol(1) eq '{}'", name); }

bool keeps_spin(const InvarianceStudy& study, const Example& e) {
  return std::any_of(study.summaries.begin(), study.summaries.end(), [&](const LawSummary& s) {
    const auto kept = [](const MotionTrend& t) { return t.quantity->key == "spin_ratio" && t.verdict != TrendVerdict::moved; };
    return s.law == e.law->name && s.softer == (e.factor < 1) && std::any_of(s.motion.begin(), s.motion.end(), kept);
  });
}

/// The spin gained in the input's own impact, every law over its factors, and what is predicted without torque l^{p+1}.
bool spin_chart(const Input& input, const InvarianceStudy& study, const std::string& title, const std::filesystem::path& folder,
                int threads, HtmlReport& report) {
  const ScalingLaw& unscaled = *find_scaling_law("none");
  const PairMotion original = resolve_motion(input, unscaled, 1, input.tolerance);
  const MotionQuantity& spin = motion_quantity("spin_ratio");
  if (original.stuck || !spin.ratio(original, original, 1)) return true;
  std::vector<Asked> asked;
  const auto farthest = examples(study, true);
  double largest = 1;
  for (const Example& e : farthest) {
    if (e.factor == 1) continue;
    largest = std::max(largest, e.factor);
    for (const double factor : factors_to(e.factor, 25)) asked.push_back({e.law, factor, input});
  }
  const auto motions = resolve_all(asked, threads);
  // Each side has a file of its own; a factor of 1 starts the curve that follows it.
  Csv softened({"law", "factor [-]", "spin_ratio [-]"}), enlarged({"law", "factor [-]", "spin_ratio [-]"});
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto& [law, factor, at] = asked[i];
    const double side = factor == 1 ? asked[i + 1].factor : factor;
    if (motions[i].stuck) continue;
    (side < 1 ? softened : enlarged).add({std::string(law->name), factor, *spin.ratio(motions[i], original, size_factor(*law, factor))});
  }
  const auto chart = [&](const std::string& name, bool soft, const char* x_label) {
    Plot plot{name,    "Spin gained × size, scaled over original: " + readable(title),
              x_label, "spin gained × size, over the original's [-]",
              soft,    false,
              {}};
    for (const Example& e : farthest) {
      const std::string law(e.law->name);
      if (e.factor != 1 && (e.factor < 1) == soft)
        plot.curves.push_back({name + ".csv", "2", "3", law, keeps_spin(study, e), e.style, named(law)});
    }
    return plot;
  };
  const Plot softer = chart("spin_ratio_stiffness", true, "stiffness ratio [-]");
  Plot plot = chart("spin_ratio", false, "size ratio l [-]");
  const bool torque_off =
      std::any_of(farthest.begin(), farthest.end(), [](const Example& e) { return e.law->direct_force && e.law->torque == e.law->force; });
  if (torque_off && input.surface.tangential != TangentialModel::none && largest > 1) {
    const char *sliding = "sliding throughout: 1/l", *rigid = "no slip: 7/(2l + 5)";
    for (const double l : factors_to(largest, 9)) {
      enlarged.add({std::string(sliding), l, 1 / l});
      enlarged.add({std::string(rigid), l, 7 / (2 * l + 5)});
    }
    plot.curves.push_back({"spin_ratio.csv", "2", "3", sliding, true, 0, named(sliding)});
    plot.curves.push_back({"spin_ratio.csv", "2", "3", rigid, true, 13, named(rigid)});
  }
  bool drawn = true;
  if (!softer.curves.empty()) {
    write_file(folder / "spin_ratio_stiffness.csv", softened.text());
    drawn = draw(softer, folder);
    report.figure(folder / "spin_ratio_stiffness.svg",
                  "Spin gained, softened over original, against the stiffness ratio: 1 is kept. Marks: laws that keep it, at least in the "
                  "limit of small overlaps.");
  }
  if (plot.curves.empty()) return drawn;
  write_file(folder / "spin_ratio.csv", enlarged.text());
  drawn = draw(plot, folder) && drawn;
  report.figure(folder / "spin_ratio.svg",
                fmt::format("Spin gained × size over the original's, against the size ratio, at {:g} m/s normal and {:g} m/s tangential "
                            "speed: 1 is kept. Coloured marks: laws that keep it. Black marks: what docs/oblique.md derives for a torque "
                            "that grows only as the force does, where the contact slides throughout and where it never slips and its "
                            "tangential spring is rigid.",
                            input.normal_speed, input.tangential_speed));
  return drawn;
}

/// e_t over the impact angle, without spins, at the input's normal speed.
bool angle_chart(Input input, const InvarianceStudy& study, const std::string& title, const std::filesystem::path& folder, int threads,
                 HtmlReport& report) {
  input.spin1.setZero();
  input.spin2.setZero();
  constexpr int points = 81;
  constexpr double low = 0.05, high = 20;
  struct Line {
    std::string name;
    double factor;
    int style;
  };
  std::vector<Line> lines = {{"original", 1, 0}};
  std::vector<Asked> asked;
  const auto add = [&](const ScalingLaw& law, double factor) {
    for (int i = 0; i < points; ++i) {
      Input oblique = input;
      oblique.tangential_speed = input.normal_speed * low * std::pow(high / low, i / (points - 1.0));
      asked.push_back({&law, factor, std::move(oblique)});
    }
  };
  add(*find_scaling_law("none"), 1);
  for (const Example& e : examples(study, false)) {
    lines.push_back({std::string(e.law->name), e.factor, e.style});
    add(*e.law, e.factor);
  }
  const auto motions = resolve_all(asked, threads);
  Csv csv({"law", "factor [-]", "angle [deg]", "tangential_over_normal_speed [-]", "restitution_tangential [-]", "restitution_normal [-]"});
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (motions[i].stuck) continue;
    const double ratio = asked[i].input.tangential_speed / input.normal_speed;
    csv.add({lines[i / points].name, lines[i / points].factor, std::atan(ratio) * 180 / std::numbers::pi, ratio,
             *motions[i].restitution_tangential, motions[i].restitution_normal});
  }
  write_file(folder / "angle.csv", csv.text());
  Plot plot{"tangential_restitution",
            "Tangential restitution against impact angle: " + readable(title),
            "impact angle from the normal [degree]",
            "tangential speed of the centres, after over before [-]",
            false,
            false,
            {}};
  for (const Line& line : lines) {
    plot.curves.push_back({"angle.csv", "3", "5", line.style == 0 ? line.name : fmt::format("{}, {:g}", line.name, line.factor), false,
                           line.style, fmt::format("{} && $2 == {}", named(line.name), line.factor)});
  }
  const bool drawn = draw(plot, folder);
  report.figure(
      folder / "tangential_restitution.svg",
      fmt::format("Tangential restitution of the centres against the angle of an impact without spin, at {:g} m/s normal speed: the "
                  "original (black) and every law at its factor nearest to 1. Towards the right the contact slides throughout, and "
                  "how the torque grows does not matter to the centres.",
                  input.normal_speed));
  return drawn;
}

/// What the pair's angular momentum does under direct-force laws.
bool angular_momentum_chart(const Input& input, const std::string& title, const std::filesystem::path& folder, int threads,
                            HtmlReport& report) {
  constexpr int points = 33;
  constexpr double largest = 10;
  std::vector<Asked> asked;
  for (const ScalingLaw& law : scaling_laws()) {
    if (!law.direct_force) continue;
    for (const double factor : factors_to(largest, points)) asked.push_back({&law, factor, input});
  }
  const auto motions = resolve_all(asked, threads);
  Csv csv({"law", "factor [-]", "angular_momentum_change [-]", "angular_momentum_share [-]"});
  Plot plot{"angular_momentum",
            "Angular momentum gained by the pair in one collision: " + readable(title),
            "size ratio l [-]",
            "gain over m* d v_s, the surfaces' own at touch [-]",
            false,
            false,
            {}};
  std::map<std::string, int> drawn_laws;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto &change = motions[i].angular_momentum_change, &share = motions[i].angular_momentum_share;
    if (!change || !share) continue;
    const std::string name(asked[i].law->name);
    csv.add({name, asked[i].factor, *change, *share});
    if (drawn_laws.emplace(name, 0).second)
      plot.curves.push_back({"angular_momentum.csv", "2", "3", name, false, static_cast<int>(drawn_laws.size()), named(name)});
  }
  if (plot.curves.empty()) return true;
  // Laws that conserve it lie on each other: marks for the last of them.
  plot.curves.back().points = true;
  write_file(folder / "angular_momentum.csv", csv.text());
  const bool drawn = draw(plot, folder);
  report.figure(
      folder / "angular_momentum.svg",
      fmt::format("Angular momentum that the pair gains in one collision at {:g} m/s normal and {:g} m/s tangential, over m* d v_s "
                  "(v_s: the surfaces' speed at touch), against the size ratio: 0 is conserved. Of what friction takes from the "
                  "orbital motion, sup, overlap_kept and force_cubed give the share 1/l to the spins, the others all.",
                  input.normal_speed, input.tangential_speed));
  return drawn;
}

}  // namespace

std::string motion_introduction(const Input& input) {
  std::string text = fmt::format(
      "Impact: {:g} m/s tangential beside {:g} m/s normal, and spins in proportion at the other speeds; {}. Every collision is the exact "
      "motion of the scaled pair, with its own overlaps. ",
      input.tangential_speed, input.normal_speed, to_string(input.surface));
  text += has_small_overlap_limit(input)
              ? "Each is resolved again at a tenth of the overlaps and where they vanish beside the radius: what a law keeps there but not "
                "here it keeps to first order in overlap over radius, and powers of the factor are those of that limit."
              : "The liquid bridge has a length of its own, so that there is no limit of small overlaps to tell first-order deviations "
                "from others.";
  return text;
}

void report_motion(const InvarianceStudy& study, HtmlReport& report) {
  std::vector<const MotionQuantity*> columns;
  for (const MotionQuantity& quantity : motion_quantities()) {
    const bool there = std::any_of(study.summaries.begin(), study.summaries.end(), [&](const LawSummary& s) {
      return std::any_of(s.motion.begin(), s.motion.end(), [&](const MotionTrend& t) { return t.quantity == &quantity; });
    });
    if (there) columns.push_back(&quantity);
  }
  std::vector<std::string> header = {"law"};
  for (const MotionQuantity* quantity : columns) header.push_back(readable(std::string(quantity->key)));
  std::vector<std::vector<std::string>> rows;
  for (const LawSummary& s : study.summaries) {
    rows.push_back({full_name(s)});
    for (const MotionQuantity* quantity : columns) {
      const auto at = std::find_if(s.motion.begin(), s.motion.end(), [&](const MotionTrend& t) { return t.quantity == quantity; });
      rows.back().push_back(at == s.motion.end() ? "–" : verdict(*at));
    }
  }
  report.table(header, rows);
}

bool write_oblique_charts(const Input& input, const InvarianceStudy& study, const std::string& title, const std::filesystem::path& folder,
                          int threads, HtmlReport& report) {
  if (!study.motion) return true;
  write_file(folder / "motion.csv", motion_csv(study));
  bool drawn = spin_chart(input, study, title, folder, threads, report);
  if (input.surface.tangential == TangentialModel::none) return drawn;
  drawn = angle_chart(input, study, title, folder, threads, report) && drawn;
  return angular_momentum_chart(input, title, folder, threads, report) && drawn;
}

}  // namespace scalebreak

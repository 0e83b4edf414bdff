#include <fmt/format.h>

#include <scalebreak/collisions/papers/middle_sphere.hpp>
#include <scalebreak/output/csv.hpp>

namespace scalebreak {
namespace {

constexpr std::array<const char*, 3> labels = {"normal velocity of the middle sphere, v_y/v_c [-]",
                                               "tangential velocity of the middle sphere, v_x/v_c [-]",
                                               "spin of the middle sphere, {/Symbol w}_z/{/Symbol w}_c [-]"};
Plot plot_of(std::size_t quantity, const std::string& name, const std::string& title) {
  return {fmt::format("{}_{}", name, middle_quantities[quantity]), title, "dimensionless time [-]", labels[quantity], false, false, {}};
}

std::string only(const CaseSystem& system, bool rolling) {
  return fmt::format("strcol(1) eq '{}' && $2 == {} && strcol(3) eq '{}'", system.original() ? "original" : system.law->name, system.factor,
                     rolling);
}

/// The curve of a law that should fall on the original is drawn as a few marks.
std::string sparse(const std::string& condition) { return condition + " && int($0) % 50 == 0"; }

double grid_time(double duration, int i) { return duration * i / middle_grid; }

}  // namespace

std::string middle_curves_csv(const std::vector<const MiddleCurve*>& curves, double duration) {
  Csv csv({"law", "factor [-]", "rolling", "time_reduced [-]", "velocity_y_reduced [-]", "velocity_x_reduced [-]", "spin_z_reduced [-]"});
  for (const MiddleCurve* curve : curves) {
    for (int i = 0; i <= middle_grid; ++i) {
      const double t = grid_time(duration, i);
      csv.add({std::string(curve->system.original() ? "original" : curve->system.law->name), curve->system.factor,
               std::string(curve->rolling ? "true" : "false"), t, curve->curve[0].at(t), curve->curve[1].at(t), curve->curve[2].at(t)});
    }
  }
  return csv.text();
}

std::string middle_limit_csv(const std::vector<MiddleComparison>& comparisons) {
  Csv csv({"law", "factor [-]", "velocity_y_distance [-]", "velocity_x_distance [-]", "spin_z_distance [-]", "overlap_over_radius [-]",
           "overlap_over_reduced_radius [-]", "turned [rad]"});
  const auto cell = [](const std::optional<double>& value) { return value ? CsvCell(*value) : CsvCell(); };
  for (const MiddleComparison& c : comparisons)
    csv.add({std::string(c.system.law->name), c.system.factor, cell(c.distance[0]), cell(c.distance[1]), cell(c.distance[2]),
             c.overlap_over_radius, c.overlap_over_reduced_radius, c.turned});
  return csv.text();
}

std::vector<CasePlot> middle_plots(const Input& input, const std::vector<MiddleCurve>& scaled, bool with_rolling) {
  std::vector<CasePlot> all;
  const CaseSystem original{find_scaling_law("none"), 1};
  const std::string rolling = to_string(input.surface.rolling);
  const double first = scaled.size() > 1 ? scaled[1].system.factor : 1;
  for (std::size_t q = 0; q < 3 && with_rolling; ++q) {
    Plot plot = plot_of(q, "rolling", fmt::format("What rolling resistance does to the {} (original stiffness)", middle_words[q]));
    plot.curves = {{"curves.csv", "4", std::to_string(5 + q), "with rolling resistance, " + rolling, false, 0, only(original, true)},
                   {"curves.csv", "4", std::to_string(5 + q), "without rolling resistance", false, 2, only(original, false)}};
    all.push_back(
        {plot, fmt::format("The {} of the middle sphere of the original system, with and without rolling resistance.", middle_words[q])});
  }
  for (std::size_t q = 0; q < 3; ++q) {
    Plot plot = plot_of(q, "scaled", fmt::format("The {} at a stiffness ratio of {:g}", middle_words[q], first));
    plot.curves = {{"curves.csv", "4", std::to_string(5 + q), "original", false, 0, only(original, true)}};
    int style = 1;
    for (const MiddleCurve& curve : scaled) {
      if (curve.system.original() || curve.system.factor != first || curve.lost) continue;
      const bool marks = curve.system.law->name == "rps";
      const std::string condition = only(curve.system, true);
      plot.curves.push_back(
          {"curves.csv", "4", std::to_string(5 + q), curve.system.name(), marks, style++, marks ? sparse(condition) : condition});
    }
    all.push_back({plot, fmt::format("The {} of the middle sphere: original (line), and softened with RPS (marks) and without any scaling. "
                                     "Each system is measured by its own characteristic time.",
                                     middle_words[q])});
  }
  for (std::size_t q = 0; q < 3; ++q) {
    Plot plot = plot_of(q, "factors", fmt::format("The {} under RPS at falling stiffness", middle_words[q]));
    plot.curves = {{"curves.csv", "4", std::to_string(5 + q), "original", false, 0, only(original, true)}};
    int style = 1;
    for (const MiddleCurve& curve : scaled) {
      if (curve.system.law->name != "rps" || curve.lost) continue;
      plot.curves.push_back({curve.system.factor == first ? "curves.csv" : "factors.csv", "4", std::to_string(5 + q), curve.system.name(),
                             false, style++, only(curve.system, true)});
    }
    all.push_back(
        {plot, fmt::format("The {} under RPS, down to where spheres overlap so far that they are none any more.", middle_words[q])});
  }
  Plot limit{"limit",
             "How far the softened curves are from the original",
             "stiffness ratio [-]",
             "largest distance over the original's range [-]",
             true,
             true,
             {}};
  int style = 1;
  for (const char* law : {"rps", "none"}) {
    for (std::size_t q = 0; q < 3; ++q) {
      limit.curves.push_back({"limit.csv", "2", std::to_string(3 + q), fmt::format("{}: {}", law, middle_words[q]), true, style++,
                              fmt::format("strcol(1) eq '{}'", law)});
    }
  }
  limit.curves.push_back({"limit.csv", "2", "7", "rps: overlap over R*", false, 0, "strcol(1) eq 'rps'"});
  limit.curves.push_back({"limit.csv", "2", "(0.1)", "overlaps end to be small: 0.1 R*", false, 8});
  all.push_back({limit,
                 "Largest distance from the original's curve, over that curve's range, against the stiffness ratio. Where the black "
                 "line exceeds the grey one (a tenth of R*) the contact laws are out of their range."});
  return all;
}

}  // namespace scalebreak

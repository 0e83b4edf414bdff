#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/collisions/papers/middle_sphere.hpp>

// The case of three spheres in a row: its systems, what the paper says of them, and what had to be assumed.

namespace scalebreak {
namespace {

void add_bars(CaseResult& result, const std::vector<MiddleComparison>& comparisons, const Input& input) {
  // RPS maps overlaps and not radii: adhesive contacts of small spheres are deep, and their curves coincide only in the limit.
  const double bar = input.contact.adhesive() ? 0.03 : 0.005;
  const auto find = [&](std::string_view law) {
    return std::find_if(comparisons.begin(), comparisons.end(),
                        [&](const MiddleComparison& c) { return c.system.law->name == law && c.system.factor == 1e-2; });
  };
  const auto rps = find("rps"), none = find("none");
  if (rps == comparisons.end()) return;
  for (std::size_t q = 0; q < 3; ++q) {
    if (!rps->distance[q]) continue;
    result.bars.push_back(
        {fmt::format("RPS at 1e-2 gives the same curve: {}, distance over range", middle_words[q]), *rps->distance[q], bar});
    if (none == comparisons.end() || !none->distance[q]) continue;
    result.bars.push_back({fmt::format("without scaling at 1e-2 the curve is another: {}, distance over that of RPS", middle_words[q]),
                           *none->distance[q] / *rps->distance[q], 10, false});
  }
}

/// "Almost no impact on the normal velocity", "largely influences the angular velocity", "non-negligible" on the tangential one.
void add_rolling_bars(CaseResult& result, const std::array<std::optional<double>, 3>& free) {
  constexpr double none = 0.001, some = 0.01, large = 0.1;
  const auto add = [&](std::size_t q, const char* what, double bar, bool at_most) {
    if (free[q])
      result.bars.push_back(
          {fmt::format("rolling resistance {} the {}: distance over range", what, middle_words[q]), *free[q], bar, at_most});
  };
  add(0, "hardly changes", none, true);
  add(1, "visibly changes", some, false);
  add(2, "largely changes", large, false);
}

}  // namespace

CaseResult run_three_particles(const Input& input, const std::function<void(double)>& progress) {
  const std::vector<CaseSystem> systems = case_systems(input);
  const bool with_rolling = input.surface.rolling != RollingModel::none;
  const double duration = input.run.duration / characteristic_time(input, systems.front());
  Input rolls_freely = input;
  rolls_freely.surface.rolling = RollingModel::none;

  std::vector<MiddleCurve> curves;
  for (const CaseSystem& system : systems) {
    curves.push_back(follow_middle(input, system, duration));
    if (progress) progress(static_cast<double>(curves.size()) / static_cast<double>(systems.size() + 1));
  }
  const MiddleCurve& original = curves.front();
  const MiddleCurve free = follow_middle(rolls_freely, systems.front(), duration);
  if (progress) progress(1);

  CaseResult result;
  std::vector<MiddleComparison> comparisons;
  const double reduced = input.colliding().pair().radius / input.bodies[middle_sphere].radius;
  const auto numbers = [&](const std::string& name, const MiddleCurve& curve, const std::array<std::optional<double>, 3>& distances) {
    const double depth = curve.overlap_over_radius;
    const auto end = [&](double value) { return curve.lost ? std::nullopt : std::optional(value); };
    CaseCurve row{name, {}};
    for (std::size_t q = 0; q < 3; ++q) row.numbers.push_back({std::string(middle_quantities[q]) + "_distance", "-", distances[q]});
    for (std::size_t q = 0; q < 3; ++q)
      row.numbers.push_back({std::string(middle_quantities[q]) + "_end", "-", end(curve.curve[q].value.back())});
    row.numbers.push_back({"overlap_over_radius", "-", depth});
    row.numbers.push_back({"overlap_over_reduced_radius", "-", depth / reduced});
    row.numbers.push_back({"line_of_centres_turned", "rad", end(curve.turned)});
    row.numbers.push_back({"touches", "-", end(curve.touches)});
    result.curves.push_back(row);
  };
  const auto distances = [&](const MiddleCurve& curve) {
    std::array<std::optional<double>, 3> all;
    for (std::size_t q = 0; q < 3 && !curve.lost; ++q) all[q] = curve_distance(original.curve[q], curve.curve[q], duration, middle_grid);
    return all;
  };
  numbers("original", original, distances(original));
  if (with_rolling) numbers("original without rolling resistance", free, distances(free));
  std::vector<const MiddleCurve*> near = {&original}, far;
  if (with_rolling) near.push_back(&free);
  int deep = 0, lost = 0;
  for (const MiddleCurve& curve : curves) {
    if (curve.system.original()) continue;
    if (!curve.lost) (curve.system.factor == curves[1].system.factor ? near : far).push_back(&curve);
    const double depth = curve.overlap_over_radius;
    comparisons.push_back({curve.system, distances(curve), depth, depth / reduced, curve.turned});
    lost += curve.lost;
    numbers(curve.system.name(), curve, comparisons.back().distance);
    deep += depth / reduced > deep_overlap;
  }
  if (with_rolling) add_rolling_bars(result, distances(free));
  add_bars(result, comparisons, input);
  result.notes = {
      fmt::format(
          "The spheres of the row all but touch at the start: the paper gives no gap, and RPS maps overlaps but not gaps, so that only such "
          "spheres meet at the same dimensionless times at every stiffness. Middle and bottom approach each other at once; the top sphere "
          "begins to press when the middle one has been slowed down."),
      fmt::format("Every system is followed to dimensionless time {:.4g} ({:.4g} s of the original), and measured by its own stiffness.",
                  duration, input.run.duration)};
  const auto rps = std::find_if(curves.begin(), curves.end(), [](const MiddleCurve& c) { return c.system.law->name == "rps" && !c.lost; });
  if (rps != curves.end())
    result.notes.push_back(fmt::format(
        "What RPS still changes is the turning of the line of centres while spheres touch, which the dimensionless equations have fixed: contacts "
        "last longer, and it turns by {:.3g} rad at a factor of {:g}, by {:.3g} rad in the original. The distances of RPS grow in proportion.",
        rps->turned, rps->system.factor, original.turned));
  if (deep > 0)
    result.notes.push_back(
        fmt::format("In {} of {} scaled systems the largest overlap exceeds a tenth of R*, more than the contact laws are meant for.", deep,
                    comparisons.size()));
  if (lost > 0)
    result.notes.push_back(
        fmt::format("{} of these are not followed to the end and have no distance: the surface of one sphere passes the centre of "
                    "another, which leaves no spheres to speak of.",
                    lost));
  result.files = {{"curves.csv", middle_curves_csv(near, duration)}, {"limit.csv", middle_limit_csv(comparisons)}};
  if (!far.empty()) result.files.push_back({"factors.csv", middle_curves_csv(far, duration)});
  result.plots = middle_plots(input, curves, with_rolling);
  return result;
}

}  // namespace scalebreak

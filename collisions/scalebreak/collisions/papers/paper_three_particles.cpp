#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/collisions/papers/paper_case.hpp>
#include <scalebreak/collisions/papers/paper_curve.hpp>
#include <scalebreak/output/csv.hpp>

// Three spheres in contact range (Washino et al. 2024, section 4): the velocities of the middle one in the variables in which the
// softened system should repeat the original.

namespace scalebreak {
namespace {

constexpr std::size_t middle = 1;
constexpr std::array<const char*, 3> quantities = {"velocity_y", "velocity_x", "spin_z"};
/// Instants per motion, and of the common grid of dimensionless time on which curves are compared and written.
constexpr int samples = 4000, grid = 2000;

/// What velocity, spin and time are measured by: of the system itself, as it starts.
struct Characteristic {
  double speed, spin, time;
};

/// W eqs 56, 57 and 59 or 83, with radius, mass and stiffness of the middle sphere.
Characteristic characteristic(const Input& input, const MovingScene& scene, const CaseSystem& system) {
  const MovingBody& body = scene.bodies[middle];
  const Material material = scaled_material(*system.law, system.factor, input.material_of(input.bodies[middle]), input.contact.normal);
  const double speed = body.velocity.norm();
  const double rate = input.contact.traits().constant_spring ? std::sqrt(material.spring_constant / body.mass)
                                                             : std::pow(material.young * std::sqrt(body.radius * speed) / body.mass, 0.4);
  return {speed, body.spin.norm(), 1 / rate};
}

/// The middle sphere's motion, dimensionless.
struct MiddleCurve {
  CaseSystem system;
  bool rolling = true;
  std::array<PaperCurve, 3> curve;
  bool lost = false;  ///< deeper than spheres go: not followed to the end
  double overlap_over_radius = 0;
  double turned = 0;  ///< [rad]
  int touches = 0;
};

/// Overlap over radius beyond which there are no two spheres any more: the surface of one has passed the centre of the other.
constexpr double no_spheres = 1;

/// Ends a motion that has lost its meaning.
struct Lost {};

MiddleCurve follow(const Input& input, const CaseSystem& system, double duration) {
  MiddleCurve motion{.system = system, .rolling = input.surface.rolling != RollingModel::none};
  const MovingScene scene = moving_scene(input, *system.law, system.factor);
  const Characteristic unit = characteristic(input, scene, system);
  MotionOptions options{.tolerance = input.tolerance, .duration = duration * unit.time};
  options.sample_interval = options.duration / samples;
  const double radius = scene.bodies[middle].radius;
  options.observer = [&](const MotionSample& sample) {
    motion.overlap_over_radius = std::max(motion.overlap_over_radius, sample.largest_overlap / radius);
    if (motion.overlap_over_radius > no_spheres) throw Lost{};
    const double t = sample.time / unit.time;
    if (!motion.curve[0].time.empty() && t <= motion.curve[0].time.back()) return;
    const MovingBody& body = sample.bodies[middle];
    motion.curve[0].add(t, body.velocity.y() / unit.speed);
    motion.curve[1].add(t, body.velocity.x() / unit.speed);
    motion.curve[2].add(t, body.spin.z() / unit.spin);
  };
  try {
    const MotionOutcome outcome = scene.move(options);
    motion.turned = outcome.turned;
    motion.touches = outcome.touches;
  } catch (const Lost&) {
    motion.lost = true;
  }
  return motion;
}

double grid_time(double duration, int i) { return duration * i / grid; }

std::string curves_csv(const std::vector<const MiddleCurve*>& curves, double duration) {
  Csv csv({"law", "factor [-]", "rolling", "time_reduced [-]", "velocity_y_reduced [-]", "velocity_x_reduced [-]", "spin_z_reduced [-]"});
  for (const MiddleCurve* curve : curves) {
    for (int i = 0; i <= grid; ++i) {
      const double t = grid_time(duration, i);
      csv.add({std::string(curve->system.original() ? "original" : curve->system.law->name), curve->system.factor,
               std::string(curve->rolling ? "true" : "false"), t, curve->curve[0].at(t), curve->curve[1].at(t), curve->curve[2].at(t)});
    }
  }
  return csv.text();
}

constexpr std::array<const char*, 3> labels = {"normal velocity of the middle sphere, v_y/v_c [-]",
                                               "tangential velocity of the middle sphere, v_x/v_c [-]",
                                               "spin of the middle sphere, {/Symbol w}_z/{/Symbol w}_c [-]"};
constexpr std::array<const char*, 3> words = {"normal velocity", "tangential velocity", "spin"};

Plot plot_of(std::size_t quantity, const std::string& name, const std::string& title) {
  return {fmt::format("{}_{}", name, quantities[quantity]), title, "dimensionless time [-]", labels[quantity], false, false, {}};
}

std::string only(const CaseSystem& system, bool rolling) {
  return fmt::format("strcol(1) eq '{}' && $2 == {} && strcol(3) eq '{}'", system.original() ? "original" : system.law->name, system.factor,
                     rolling);
}

/// The curve of a law that should fall on the original is drawn as a few marks.
std::string sparse(const std::string& condition) { return condition + " && int($0) % 50 == 0"; }

/// What is said of one system.
struct Comparison {
  CaseSystem system;
  std::array<std::optional<double>, 3> distance;
  double overlap_over_radius, overlap_over_reduced_radius, turned;
};

std::string limit_csv(const std::vector<Comparison>& comparisons) {
  Csv csv({"law", "factor [-]", "velocity_y_distance [-]", "velocity_x_distance [-]", "spin_z_distance [-]", "overlap_over_radius [-]",
           "overlap_over_reduced_radius [-]", "turned [rad]"});
  const auto cell = [](const std::optional<double>& value) { return value ? CsvCell(*value) : CsvCell(); };
  for (const Comparison& c : comparisons)
    csv.add({std::string(c.system.law->name), c.system.factor, cell(c.distance[0]), cell(c.distance[1]), cell(c.distance[2]),
             c.overlap_over_radius, c.overlap_over_reduced_radius, c.turned});
  return csv.text();
}

std::vector<CasePlot> plots(const Input& input, const std::vector<MiddleCurve>& scaled, bool with_rolling) {
  std::vector<CasePlot> all;
  const CaseSystem original{find_scaling_law("none"), 1};
  const std::string rolling = to_string(input.surface.rolling);
  const double first = scaled.size() > 1 ? scaled[1].system.factor : 1;
  for (std::size_t q = 0; q < 3 && with_rolling; ++q) {
    Plot plot = plot_of(q, "rolling", fmt::format("What rolling resistance does to the {} (original stiffness)", words[q]));
    plot.curves = {{"curves.csv", "4", std::to_string(5 + q), "with rolling resistance, " + rolling, false, 0, only(original, true)},
                   {"curves.csv", "4", std::to_string(5 + q), "without rolling resistance", false, 2, only(original, false)}};
    all.push_back(
        {plot, fmt::format("The {} of the middle sphere of the original system, with and without rolling resistance.", words[q])});
  }
  for (std::size_t q = 0; q < 3; ++q) {
    Plot plot = plot_of(q, "scaled", fmt::format("The {} at a stiffness ratio of {:g}", words[q], first));
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
                                     words[q])});
  }
  for (std::size_t q = 0; q < 3; ++q) {
    Plot plot = plot_of(q, "factors", fmt::format("The {} under RPS at falling stiffness", words[q]));
    plot.curves = {{"curves.csv", "4", std::to_string(5 + q), "original", false, 0, only(original, true)}};
    int style = 1;
    for (const MiddleCurve& curve : scaled) {
      if (curve.system.law->name != "rps" || curve.lost) continue;
      plot.curves.push_back({curve.system.factor == first ? "curves.csv" : "factors.csv", "4", std::to_string(5 + q), curve.system.name(),
                             false, style++, only(curve.system, true)});
    }
    all.push_back({plot, fmt::format("The {} under RPS, down to where spheres overlap so far that they are none any more.", words[q])});
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
      limit.curves.push_back({"limit.csv", "2", std::to_string(3 + q), fmt::format("{}: {}", law, words[q]), true, style++,
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

void add_bars(CaseResult& result, const std::vector<Comparison>& comparisons, const Input& input) {
  // RPS maps overlaps and not radii: adhesive contacts of small spheres are deep, and their curves coincide only in the limit.
  const double bar = input.contact.adhesive() ? 0.03 : 0.005;
  const auto find = [&](std::string_view law) {
    return std::find_if(comparisons.begin(), comparisons.end(),
                        [&](const Comparison& c) { return c.system.law->name == law && c.system.factor == 1e-2; });
  };
  const auto rps = find("rps"), none = find("none");
  if (rps == comparisons.end()) return;
  for (std::size_t q = 0; q < 3; ++q) {
    if (!rps->distance[q]) continue;
    result.bars.push_back({fmt::format("RPS at 1e-2 gives the same curve: {}, distance over range", words[q]), *rps->distance[q], bar});
    if (none == comparisons.end() || !none->distance[q]) continue;
    result.bars.push_back({fmt::format("without scaling at 1e-2 the curve is another: {}, distance over that of RPS", words[q]),
                           *none->distance[q] / *rps->distance[q], 10, false});
  }
}

/// "Almost no impact on the normal velocity", "largely influences the angular velocity", "non-negligible" on the tangential one.
void add_rolling_bars(CaseResult& result, const std::array<std::optional<double>, 3>& free) {
  constexpr double none = 0.001, some = 0.01, large = 0.1;
  const auto add = [&](std::size_t q, const char* what, double bar, bool at_most) {
    if (free[q])
      result.bars.push_back({fmt::format("rolling resistance {} the {}: distance over range", what, words[q]), *free[q], bar, at_most});
  };
  add(0, "hardly changes", none, true);
  add(1, "visibly changes", some, false);
  add(2, "largely changes", large, false);
}

}  // namespace

CaseResult run_three_particles(const Input& input, const std::function<void(double)>& progress) {
  const std::vector<CaseSystem> systems = case_systems(input);
  const bool with_rolling = input.surface.rolling != RollingModel::none;
  const Characteristic unit = characteristic(input, moving_scene(input), systems.front());
  const double duration = input.run.duration / unit.time;
  Input rolls_freely = input;
  rolls_freely.surface.rolling = RollingModel::none;

  std::vector<MiddleCurve> curves;
  for (const CaseSystem& system : systems) {
    curves.push_back(follow(input, system, duration));
    if (progress) progress(static_cast<double>(curves.size()) / static_cast<double>(systems.size() + 1));
  }
  const MiddleCurve& original = curves.front();
  const MiddleCurve free = follow(rolls_freely, systems.front(), duration);
  if (progress) progress(1);

  CaseResult result;
  std::vector<Comparison> comparisons;
  const double reduced = input.colliding().pair().radius / input.bodies[middle].radius;
  const auto numbers = [&](const std::string& name, const MiddleCurve& curve, const std::array<std::optional<double>, 3>& distances) {
    const double depth = curve.overlap_over_radius;
    const auto end = [&](double value) { return curve.lost ? std::nullopt : std::optional(value); };
    CaseCurve row{name, {}};
    for (std::size_t q = 0; q < 3; ++q) row.numbers.push_back({std::string(quantities[q]) + "_distance", "-", distances[q]});
    for (std::size_t q = 0; q < 3; ++q) row.numbers.push_back({std::string(quantities[q]) + "_end", "-", end(curve.curve[q].value.back())});
    row.numbers.push_back({"overlap_over_radius", "-", depth});
    row.numbers.push_back({"overlap_over_reduced_radius", "-", depth / reduced});
    row.numbers.push_back({"line_of_centres_turned", "rad", end(curve.turned)});
    row.numbers.push_back({"touches", "-", end(curve.touches)});
    result.curves.push_back(row);
  };
  const auto distances = [&](const MiddleCurve& curve) {
    std::array<std::optional<double>, 3> all;
    for (std::size_t q = 0; q < 3 && !curve.lost; ++q) all[q] = curve_distance(original.curve[q], curve.curve[q], duration, grid);
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
  result.files = {{"curves.csv", curves_csv(near, duration)}, {"limit.csv", limit_csv(comparisons)}};
  if (!far.empty()) result.files.push_back({"factors.csv", curves_csv(far, duration)});
  result.plots = plots(input, curves, with_rolling);
  return result;
}

}  // namespace scalebreak

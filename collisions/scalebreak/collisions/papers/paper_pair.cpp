#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/collisions/papers/paper_case.hpp>
#include <scalebreak/collisions/papers/paper_curve.hpp>
#include <scalebreak/output/csv.hpp>

// The head-on cases of Chen & Elliott: two unlike spheres (their Fig. 3), and a sphere on a plane at many speeds (Figs 5 and 6).

namespace scalebreak {
namespace {

std::string only(const CaseSystem& system) {
  return fmt::format("strcol(1) eq '{}' && $2 == {}", system.original() ? "original" : system.law->name, system.factor);
}
std::string law_name(const CaseSystem& system) { return std::string(system.original() ? "original" : system.law->name); }

/// The smaller sphere's collision: quantities over time, forces over the pull-off force of the system itself.
struct HeadOn {
  CaseSystem system;
  PaperCurve velocity, force, overlap;
  PairCollision collision;
  std::optional<double> sticking_speed;
  double pull_off_force = 0;
};

HeadOn collide(const Input& input, const CaseSystem& system) {
  HeadOn run{.system = system};
  const Bodies original = input.colliding(), bodies = scaled_bodies(*system.law, system.factor, original, input.contact.normal);
  const ScaledContact contact(input.contact, original, *system.law, system.factor);
  const Eigen::Vector3d line = (input.bodies[1].position - input.bodies[0].position).normalized();
  const double v1 = input.bodies[0].velocity.dot(line), v2 = input.bodies[1].velocity.dot(line), speed = v1 - v2;
  const double size = size_factor(*system.law, system.factor);
  const double m1 = sphere_mass(size * original.radius[0], bodies.first.density),
               m2 = sphere_mass(size * original.radius[1], bodies.second.density);
  const double common = (m1 * v1 + m2 * v2) / (m1 + m2), share = m2 / (m1 + m2);
  const NormalPair& pair = contact.scaled().pair;
  run.pull_off_force = 3 * std::numbers::pi * pair.surface_energy * pair.radius * contact.scaled().force;
  for (const TrajectoryPoint& p : contact.trajectory(speed, input.tolerance, 1500)) {
    if (!run.velocity.time.empty() && p.time <= run.velocity.time.back()) continue;
    run.velocity.add(p.time, common + share * p.speed);
    run.force.add(p.time, (p.elastic_force + p.damping_force) / run.pull_off_force);
    run.overlap.add(p.time, p.overlap);
  }
  run.collision = contact.collide(speed, input.tolerance, true);
  run.sticking_speed = contact.sticking_speed(input.tolerance);
  return run;
}

std::string head_on_csv(const std::vector<HeadOn>& runs) {
  Csv csv({"law", "factor [-]", "time [s]", "velocity_of_smaller [m/s]", "force_over_pull_off [-]", "overlap [m]"});
  for (const HeadOn& run : runs) {
    for (std::size_t i = 0; i < run.velocity.time.size(); i += 3)
      csv.add(
          {law_name(run.system), run.system.factor, run.velocity.time[i], run.velocity.value[i], run.force.value[i], run.overlap.value[i]});
  }
  return csv.text();
}

std::vector<CasePlot> head_on_plots(const std::vector<HeadOn>& runs) {
  struct Panel {
    const char *name, *x, *y, *x_label, *y_label, *title;
  };
  constexpr Panel panels[] = {
      {"velocity", "($3*1e6)", "4", "time [{/Symbol m}s]", "velocity of the smaller sphere [m/s]", "Velocity of the smaller sphere"},
      {"force", "($3*1e6)", "5", "time [{/Symbol m}s]", "normal force over pull-off force [-]", "Normal force over time"},
      {"overlap", "($3*1e6)", "($6*1e6)", "time [{/Symbol m}s]", "overlap [{/Symbol m}m]", "Overlap over time"},
      {"force_overlap", "($6*1e6)", "5", "overlap [{/Symbol m}m]", "normal force over pull-off force [-]", "Normal force over overlap"}};
  std::vector<CasePlot> plots;
  for (const Panel& panel : panels) {
    Plot plot{panel.name, fmt::format("{}: original and enlarged spheres", panel.title), panel.x_label, panel.y_label, false, false, {}};
    int style = 0;
    for (const HeadOn& run : runs) {
      const bool marks = run.system.law->name == "chen_elliott";
      plot.curves.push_back({"head_on.csv", panel.x, panel.y, run.system.name(), marks, style++,
                             marks ? only(run.system) + " && int($0) % 12 == 0" : only(run.system)});
    }
    plots.push_back(
        {plot, fmt::format("{}, of the original (black line) and of spheres enlarged under each law. Marks on the line: the law "
                           "keeps the collision.",
                           panel.title)});
  }
  return plots;
}

/// Where a law that keeps a pair may be off: what integration and interpolation leave.
constexpr double same_curve = 1e-5;

}  // namespace

CaseResult run_head_on(const Input& input, const std::function<void(double)>& progress) {
  CaseResult result;
  std::vector<HeadOn> runs;
  const auto systems = case_systems(input);
  for (const CaseSystem& system : systems) {
    runs.push_back(collide(input, system));
    if (progress) progress(static_cast<double>(runs.size()) / static_cast<double>(systems.size()));
  }
  const HeadOn& original = runs.front();
  const double end = original.velocity.time.back();
  const HeadOn *bond = nullptr, *cohesion = nullptr;
  const auto force_distance = [&](const HeadOn& run) { return curve_distance(original.force, run.force, end).value_or(0); };
  for (const HeadOn& run : runs) {
    if (run.system.law->name == "bond" && !bond) bond = &run;
    if (run.system.law->name == "cohesion" && !cohesion) cohesion = &run;
    result.curves.push_back({run.system.name(),
                             {{"velocity_distance", "-", curve_distance(original.velocity, run.velocity, end)},
                              {"force_distance", "-", curve_distance(original.force, run.force, end)},
                              {"overlap_distance", "-", curve_distance(original.overlap, run.overlap, end)},
                              {"velocity_after", "m/s", run.velocity.value.back()},
                              {"restitution", "-", run.collision.restitution},
                              {"contact_time", "s", run.collision.contact_time},
                              {"max_overlap", "m", run.collision.max_overlap},
                              {"max_force_over_pull_off", "-", run.collision.max_force / run.pull_off_force},
                              {"sticking_speed", "m/s", run.sticking_speed}}});
    if (run.system.law->name == "chen_elliott") {
      const std::string who = run.system.name();
      result.bars.push_back({who + ": velocities as the original's, distance over range",
                             curve_distance(original.velocity, run.velocity, end).value_or(0), same_curve});
      result.bars.push_back({who + ": forces over pull-off as the original's, distance over range", force_distance(run), same_curve});
      result.bars.push_back({who + ": overlaps as the original's, distance over range",
                             curve_distance(original.overlap, run.overlap, end).value_or(0), same_curve});
    }
  }
  const double before = original.velocity.value.front(), after = original.velocity.value.back();
  result.bars.push_back({"the smaller sphere leaves faster than it came: speed after over before", std::abs(after / before), 1, false});
  if (bond && bond->collision.contact_time && original.collision.contact_time) {
    result.bars.push_back({"Bond underestimates that speed: over the original's", std::abs(bond->velocity.value.back() / after), 1});
    result.bars.push_back({"Bond overestimates the contact time: over the original's",
                           *bond->collision.contact_time / *original.collision.contact_time, 1, false});
    result.bars.push_back({"Bond overestimates the largest overlap: over the original's",
                           bond->collision.max_overlap / original.collision.max_overlap, 1, false});
  }
  if (bond && cohesion && bond->collision.contact_time && cohesion->collision.contact_time && original.collision.contact_time) {
    const auto excess = [&](auto quantity) { return (quantity(*cohesion) - quantity(original)) / (quantity(*bond) - quantity(original)); };
    result.bars.push_back({"Cohesion does better than Bond: what its contact time is off by, over Bond's",
                           excess([](const HeadOn& run) { return *run.collision.contact_time; }), 1});
    result.bars.push_back({"Cohesion does better than Bond: what its largest overlap is off by, over Bond's",
                           excess([](const HeadOn& run) { return run.collision.max_overlap; }), 1});
    result.bars.push_back({"Cohesion does better than Bond: what its velocity afterwards is off by, over Bond's",
                           excess([](const HeadOn& run) { return run.velocity.value.back(); }), 1});
    result.notes.push_back(
        fmt::format("Instant by instant the force under Cohesion is no nearer to the original's than under Bond: their distances "
                    "are {:.3g} and {:.3g} of its range; contact time, depth and rebound are nearer.",
                    force_distance(*cohesion), force_distance(*bond)));
  }
  const double reduced = input.colliding().pair().radius;
  result.notes.insert(
      result.notes.begin(),
      {fmt::format(
           "Assumed, since Table 4 does not say: \"particle size\" is the radius, as in the paper's Table 5 (with diameters the pair under "
           "Bond's law would stick, which their figure does not show); density {:g} kg/m³, of the same table; each sphere moves at {:g} "
           "m/s (with the larger at rest the smaller could not rebound faster than it came); k = {:g}, as in the paper's Fig. 7.",
           input.material.density, input.bodies[0].velocity.norm(), systems.size() > 1 ? systems[1].factor : 1.0),
       fmt::format("The largest overlap of the original is {:.2g} R*{}.", original.collision.max_overlap / reduced,
                   original.collision.max_overlap > deep_overlap * reduced ? ", deeper than the contact laws are meant for" : "")});
  result.files = {{"head_on.csv", head_on_csv(runs)}};
  result.plots = head_on_plots(runs);
  return result;
}

CaseResult run_impact_speeds(const Input& input, const std::function<void(double)>& progress) {
  CaseResult result;
  std::vector<double> speeds = input.study_speeds.empty() ? std::vector<double>{input.normal_speed} : input.study_speeds;
  std::sort(speeds.begin(), speeds.end());
  Csv csv({"law", "factor [-]", "impact_speed [m/s]", "stuck", "restitution [-]", "contact_time [s]", "max_overlap [m]"});
  std::vector<PairCollision> original;
  Plot restitution{"restitution",
                   "Restitution of a sphere on a plane, original and enlarged",
                   "impact speed [m/s]",
                   "coefficient of restitution [-]",
                   false,
                   false,
                   {}};
  Plot time{"contact_time",
            "Contact time of a sphere on a plane, original and enlarged",
            "impact speed [m/s]",
            "contact time [ns]",
            false,
            false,
            {}};
  int style = 0;
  const auto systems = case_systems(input);
  for (const CaseSystem& system : systems) {
    const ScaledContact contact(input.contact, input.colliding(), *system.law, system.factor);
    double restitution_change = 0, time_change = 0;
    PairCollision last;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const PairCollision c = contact.collide(speeds[i], input.tolerance);
      csv.add({law_name(system), system.factor, speeds[i], std::string(c.stuck ? "true" : "false"), c.restitution,
               c.contact_time ? CsvCell(*c.contact_time) : CsvCell(), c.max_overlap});
      if (system.original()) original.push_back(c);
      restitution_change = std::max(restitution_change, std::abs(c.restitution - original[i].restitution));
      if (c.contact_time && original[i].contact_time)
        time_change = std::max(time_change, std::abs(*c.contact_time / *original[i].contact_time - 1));
      last = c;
    }
    result.curves.push_back({system.name(),
                             {{"restitution_change", "-", restitution_change},
                              {"contact_time_change", "-", time_change},
                              {"restitution_fastest", "-", last.restitution},
                              {"contact_time_fastest", "s", last.contact_time},
                              {"sticking_speed", "m/s", contact.sticking_speed(input.tolerance)}}});
    if (system.law->name == "chen_elliott") {
      result.bars.push_back({system.name() + ": restitution as the original's, largest change", restitution_change, 1e-7});
      result.bars.push_back({system.name() + ": contact time as the original's, largest relative change", time_change, 1e-7});
    }
    restitution.curves.push_back({"speeds.csv", "3", "5", system.name(), !system.original(), style, only(system)});
    time.curves.push_back({"speeds.csv", "3", "($6*1e9)", system.name(), !system.original(), style++, only(system)});
    if (progress) progress(static_cast<double>(style) / static_cast<double>(systems.size()));
  }
  const auto ten = std::lower_bound(speeds.begin(), speeds.end(), 10.0);
  if (ten != speeds.end() && speeds.back() > *ten)
    result.bars.push_back({"a plateau beyond 10 m/s: what the restitution still gains",
                           original.back().restitution - original[static_cast<std::size_t>(ten - speeds.begin())].restitution, 0.02});
  result.bars.push_back({"the plateau is the dashpot's: its restitution less that at the greatest speed",
                         std::abs(input.wall.material.restitution - original.back().restitution), 0.02});
  result.notes = {
      "The measurements of Dahneke (1975) that the paper's Fig. 5 shows are not printed in it; none are shown here.",
      fmt::format("Assumed: 1.27 µm is the sphere's diameter, its density {:g} kg/m³; the plane's modulus is the second one in the table, "
                  "{:g} GPa, and one surface energy holds for both. Coarse-graining ratios: those of the paper's Fig. 4.",
                  input.material.density, input.wall.material.young / 1e9)};
  result.files = {{"speeds.csv", csv.text()}};
  result.plots = {{restitution,
                   "Restitution over impact speed: the energy lost in peeling is fixed, and weighs less the faster the impact; at high "
                   "speeds the dashpot's restitution is left."},
                  {time, "Contact time over impact speed."}};
  return result;
}

}  // namespace scalebreak

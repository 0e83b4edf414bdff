#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/papers/paper_case.hpp>
#include <scalebreak/collisions/papers/paper_curve.hpp>
#include <scalebreak/output/csv.hpp>

// A sphere that hits a plane obliquely, original and enlarged (Chen & Elliott, Fig. 4).

namespace scalebreak {
namespace {

struct Quantity {
  const char *name, *unit, *label, *title;
};
constexpr Quantity quantities[] = {
    {"tangential_stiffness_over_mass_ratio", "N/m", "tangential stiffness over mass ratio k^3 [N/m]", "Tangential stiffness"},
    {"tangential_force_over_pull_off", "-", "tangential force over pull-off force [-]", "Tangential force"},
    {"spin_times_k", "rad/s", "spin times k [rad/s]", "Rotational velocity"},
    {"velocity_normal", "m/s", "normal velocity [m/s]", "Normal velocity"},
    {"velocity_tangential", "m/s", "tangential velocity [m/s]", "Tangential velocity"}};
constexpr std::size_t count = std::size(quantities);

struct Oblique {
  CaseSystem system;
  PaperCurve curve[count];
  MotionOutcome outcome;
};

Oblique collide(const Input& input, const CaseSystem& system) {
  Oblique run{.system = system};
  const MovingScene scene = moving_scene(input, *system.law, system.factor);
  const double size = size_factor(*system.law, system.factor);
  const Bodies original = input.colliding();
  const NormalPair pair =
      (system.law->direct_force ? original : scaled_bodies(*system.law, system.factor, original, input.contact.normal)).pair();
  const double pull_off = 3 * std::numbers::pi * pair.surface_energy * pair.radius * scene.laws[0].force;
  const double mass_ratio = size * size * size;
  MotionOptions options{.tolerance = input.tolerance};
  const MotionOutcome first = scene.move(options);
  options.sample_interval = (first.last_separation - first.first_touch) / 1500;
  options.sample_contacts = true;
  options.observer = [&](const MotionSample& sample) {
    if (sample.contacts.empty()) return;
    const double t = sample.time - first.first_touch;
    if (!run.curve[0].time.empty() && t <= run.curve[0].time.back()) return;
    const ContactState& contact = sample.contacts.front();
    const MovingBody& sphere = sample.bodies.front();
    run.curve[0].add(t, contact.tangential_stiffness / mass_ratio);
    run.curve[1].add(t, contact.tangential_force.x() / pull_off);
    run.curve[2].add(t, sphere.spin.y() * size);
    run.curve[3].add(t, sphere.velocity.z());
    run.curve[4].add(t, sphere.velocity.x());
  };
  run.outcome = scene.move(options);
  return run;
}

}  // namespace

CaseResult run_oblique(const Input& input, const std::function<void(double)>& progress) {
  CaseResult result;
  const auto systems = case_systems(input);
  std::vector<Oblique> runs;
  std::vector<std::string> header = {"law", "factor [-]", "time [s]"};
  for (const Quantity& quantity : quantities) header.push_back(fmt::format("{} [{}]", quantity.name, quantity.unit));
  Csv csv(header);
  for (const CaseSystem& system : systems) {
    runs.push_back(collide(input, system));
    const Oblique &run = runs.back(), &original = runs.front();
    CaseCurve row{system.name(), {}};
    for (std::size_t q = 0; q < count; ++q) {
      const auto distance = curve_distance(original.curve[q], run.curve[q], original.curve[q].time.back());
      row.numbers.push_back({std::string(quantities[q].name) + "_distance", "-", distance});
      if (system.law->name == "chen_elliott")
        result.bars.push_back(
            {fmt::format("{}: {} as the original's, distance over range", system.name(), quantities[q].title), distance.value_or(0), 1e-5});
    }
    row.numbers.push_back({"contact_time", "s", run.outcome.last_separation - run.outcome.first_touch});
    row.numbers.push_back({"velocity_tangential_after", "m/s", run.outcome.bodies[0].velocity.x()});
    row.numbers.push_back({"velocity_normal_after", "m/s", run.outcome.bodies[0].velocity.z()});
    row.numbers.push_back({"spin_after", "rad/s", run.outcome.bodies[0].spin.y()});
    row.numbers.push_back({"overlap_over_radius", "-", run.outcome.max_overlap / run.outcome.bodies[0].radius});
    result.curves.push_back(row);
    for (std::size_t i = 0; i < run.curve[0].time.size(); i += 3) {
      std::vector<CsvCell> cells = {std::string(system.original() ? "original" : system.law->name), system.factor, run.curve[0].time[i]};
      for (const PaperCurve& curve : run.curve) cells.emplace_back(curve.value[i]);
      csv.add(cells);
    }
    if (progress) progress(static_cast<double>(runs.size()) / static_cast<double>(systems.size()));
  }
  for (std::size_t q = 0; q < count; ++q) {
    Plot plot{quantities[q].name,
              fmt::format("{}: original and enlarged spheres", quantities[q].title),
              "time [ns]",
              quantities[q].label,
              false,
              false,
              {}};
    int style = 0;
    for (const CaseSystem& system : systems) {
      std::string only = fmt::format("strcol(1) eq '{}' && $2 == {}", system.original() ? "original" : system.law->name, system.factor);
      if (!system.original()) only += fmt::format(" && int($0) % 20 == {}", 10 * (style % 2));
      plot.curves.push_back({"oblique.csv", "($3*1e9)", std::to_string(4 + q), system.name(), !system.original(), style++, only});
    }
    result.plots.push_back({plot, fmt::format("{} during the contact; marks on the line: the law keeps it.", quantities[q].title)});
  }
  result.notes = {fmt::format(
      "Assumed: 1.27 µm is the sphere's diameter, its density {:g} kg/m³ (the table gives none); the plane has the table's second "
      "modulus, {:g} GPa. The paper's velocity along the plane, −5 m/s, is mirrored. The lever of friction is the radius.",
      input.material.density, input.wall.material.young / 1e9)};
  result.files = {{"oblique.csv", csv.text()}};
  return result;
}

}  // namespace scalebreak

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/collisions/papers/paper_case.hpp>
#include <scalebreak/output/csv.hpp>

// Three spheres in a row with a gap before the third: what RPS, which maps overlaps and not gaps, makes of it.

namespace scalebreak {
namespace {

using Speeds = std::array<double, 3>;

double difference(const Speeds& a, const Speeds& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// A row along the line of its first two spheres, with a gap before the third to be set.
struct Row {
  Input input;
  Eigen::Vector3d line;
  double speed;    ///< of the first impact [m/s]
  double overlap;  ///< largest of the original's first impact, by itself [m]

  explicit Row(Input from) : input(std::move(from)) {
    line = (input.bodies[1].position - input.bodies[0].position).normalized();
    speed = (input.bodies[0].velocity - input.bodies[1].velocity).dot(line);
    overlap = contact(0).collide(speed, input.tolerance).max_overlap;
  }

  /// Of sphere `first` and the next one, original.
  [[nodiscard]] ScaledContact contact(std::size_t first) const {
    const Body &a = input.bodies[first], &b = input.bodies[first + 1];
    return {input.contact, {input.material_of(a), input.material_of(b), input.wall, {a.radius, b.radius}}, *find_scaling_law("none"), 1};
  }

  /// Velocities along the line in the end; `gap` in original overlaps.
  [[nodiscard]] Speeds move(const CaseSystem& system, double gap, double* depth = nullptr) const {
    Input set = input;
    set.bodies[2].position = set.bodies[1].position + (set.bodies[1].radius + set.bodies[2].radius + gap * overlap) * line;
    const MotionOutcome outcome = moving_scene(set, *system.law, system.factor).move({.tolerance = input.tolerance});
    if (depth) *depth = outcome.max_overlap;
    const Speeds v = {outcome.bodies[0].velocity.dot(line), outcome.bodies[1].velocity.dot(line), outcome.bodies[2].velocity.dot(line)};
    if (outcome.resting && v[1] - v[2] > 1e-6 * speed)
      throw WorkError(
          "the first two spheres of the row stick to each other before they reach the third; give the first one a higher speed");
    return v;
  }

  /// Collisions of no duration, pair by pair with the exact restitution, until no pair approaches.
  [[nodiscard]] Speeds sequence(int& collisions) const {
    Speeds v;
    std::array<double, 3> mass{};
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] = input.bodies[i].velocity.dot(line);
      mass[i] = sphere_mass(input.bodies[i].radius, input.material_of(input.bodies[i]).density);
    }
    // What approaches this slowly does not count: pairs that stick, and meet with a third, approach each other ever more slowly.
    const double slow = 1e-9 * speed;
    for (collisions = 0; collisions < 1000; ++collisions) {
      const std::size_t i = v[0] - v[1] > v[1] - v[2] ? 0 : 1;
      const double approach = v[i] - v[i + 1];
      if (approach <= slow) break;
      const double restitution = contact(i).collide(approach, input.tolerance).restitution;
      const double impulse = (1 + restitution) * approach * mass[i] * mass[i + 1] / (mass[i] + mass[i + 1]);
      v[i] -= impulse / mass[i], v[i + 1] += impulse / mass[i + 1];
    }
    return v;
  }
};

/// Gap 0 has no place on a logarithmic axis: it is drawn here.
constexpr double drawn_zero = 1e-3;

std::vector<double> gaps() {
  std::vector<double> all = {0};
  for (int i = -16; i <= 24; ++i) all.push_back(std::pow(10, i / 8.0));
  return all;
}

/// The largest gap at which `far` still holds, found among the gaps and then by halving; none if it holds at none of them.
std::optional<double> last_gap(const std::vector<double>& all, const std::vector<bool>& far, const std::function<bool(double)>& is_far) {
  const auto last = std::find(far.rbegin(), far.rend(), true);
  if (last == far.rend()) return std::nullopt;
  const auto i = static_cast<std::size_t>(far.rend() - last) - 1;
  if (i + 1 == all.size()) return all[i];
  double low = all[i], high = all[i + 1];
  for (int n = 0; n < 20; ++n) {
    const double middle = (low + high) / 2;
    (is_far(middle) ? low : high) = middle;
  }
  return low;
}

/// Outcomes that differ by more than this share of the impact speed are other outcomes.
constexpr double other_outcome = 0.01;

void follow(const Row& row, const std::string& contact, const std::vector<CaseSystem>& systems, Csv& csv, CaseResult& result,
            const std::function<void(double)>& progress) {
  int collisions = 0;
  const Speeds sequence = row.sequence(collisions);
  const std::vector<double> all = gaps();
  const double limit = other_outcome * row.speed;
  result.curves.push_back({contact + ": instantaneous sequence",
                           {{"gap_of_sequence", "original overlaps", std::nullopt},
                            {"gap_of_original", "original overlaps", std::nullopt},
                            {"gap_predicted", "original overlaps", std::nullopt},
                            {"speed1_touching", "m/s", sequence[0]},
                            {"speed2_touching", "m/s", sequence[1]},
                            {"speed3_touching", "m/s", sequence[2]},
                            {"overlap_over_reduced_radius", "-", 0}}});
  csv.add({contact, std::string("sequence"), 1.0, 0.0, drawn_zero, sequence[0] / row.speed, sequence[1] / row.speed,
           sequence[2] / row.speed, 0.0});
  csv.add({contact, std::string("sequence"), 1.0, all.back(), all.back(), sequence[0] / row.speed, sequence[1] / row.speed,
           sequence[2] / row.speed, 0.0});
  std::optional<double> of_original;
  std::vector<Speeds> original;  // at each gap
  double done = 0;
  for (const CaseSystem& system : systems) {
    std::vector<bool> from_sequence, from_original;
    Speeds touching{};
    double deepest = 0;
    for (const double gap : all) {
      double depth = 0;
      const Speeds v = row.move(system, gap, &depth);
      if (gap == 0) touching = v;
      deepest = std::max(deepest, depth);
      from_sequence.push_back(difference(v, sequence) > limit);
      if (system.original()) original.push_back(v);
      from_original.push_back(difference(v, original[from_original.size()]) > limit);
      csv.add({contact, std::string(system.original() ? "original" : system.law->name), system.factor, gap, std::max(gap, drawn_zero),
               v[0] / row.speed, v[1] / row.speed, v[2] / row.speed, difference(v, sequence) / row.speed});
    }
    const auto gap1 = last_gap(all, from_sequence, [&](double gap) { return difference(row.move(system, gap), sequence) > limit; });
    const auto gap2 =
        last_gap(all, from_original, [&](double gap) { return difference(row.move(system, gap), row.move(systems.front(), gap)) > limit; });
    if (system.original()) of_original = gap1;
    // RPS is exact where gaps are mapped as overlaps are: the original's gap, times how much larger overlaps become.
    const bool rps = system.law->name == "rps";
    const double stretch = std::pow(system.factor, row.input.contact.traits().constant_spring ? -0.5 : -0.4);
    const auto predicted = rps && of_original ? std::optional(*of_original * stretch) : std::nullopt;
    const double reduced = row.input.colliding().pair().radius;
    result.curves.push_back({contact + ": " + system.name(),
                             {{"gap_of_sequence", "original overlaps", gap1},
                              {"gap_of_original", "original overlaps", gap2},
                              {"gap_predicted", "original overlaps", predicted},
                              {"speed1_touching", "m/s", touching[0]},
                              {"speed2_touching", "m/s", touching[1]},
                              {"speed3_touching", "m/s", touching[2]},
                              {"overlap_over_reduced_radius", "-", deepest / reduced}}});
    if (predicted && gap1)
      result.bars.push_back(
          {fmt::format("{}: {}: gap below which the row is no sequence of pairs, relative to factor^(−2/5) times the original's: "
                       "off by",
                       contact, system.name()),
           std::abs(*gap1 / *predicted - 1), 0.02});
    done += 1;
    if (progress) progress(done / static_cast<double>(systems.size()));
  }
  result.notes.push_back(
      fmt::format("{}: the original's first impact, at {:g} m/s, is {:.4g} m deep; {} instantaneous collisions give {:.4f}, {:.4f}, "
                  "{:.4f} of that speed.",
                  contact, row.speed, row.overlap, collisions, sequence[0] / row.speed, sequence[1] / row.speed, sequence[2] / row.speed));
}

void add_plots(const std::string& contact, const std::vector<CaseSystem>& systems, CaseResult& result) {
  constexpr const char* who[] = {"first", "second", "third"};
  for (std::size_t body = 0; body < 3; ++body) {
    Plot plot{fmt::format("{}_speed{}", contact, body + 1),
              fmt::format("Final velocity of the {} sphere ({})", who[body], contact),
              "gap before the third sphere, in original overlaps (at 0.001: touching) [-]",
              "final velocity over impact speed [-]",
              true,
              false,
              {}};
    int style = 1;
    const std::string here = fmt::format("strcol(1) eq '{}'", contact), y = std::to_string(6 + body);
    plot.curves.push_back({"row.csv", "5", y, "instantaneous pairs", false, 8, here + " && strcol(2) eq 'sequence'"});
    for (const CaseSystem& system : systems) {
      const std::string law(system.original() ? "original" : system.law->name);
      plot.curves.push_back({"row.csv", "5", y, system.name(), false, system.original() ? 0 : style++,
                             fmt::format("{} && strcol(2) eq '{}' && $3 == {}", here, law, system.factor)});
    }
    result.plots.push_back({plot, fmt::format("Final velocity of the {} sphere against the gap before the third, {} contact. Where a curve "
                                              "leaves the grey line, three spheres collide at once.",
                                              who[body], contact)});
  }
}

}  // namespace

CaseResult run_gap_row(const Input& input, const std::function<void(double)>& progress) {
  CaseResult result;
  const auto systems = case_systems(input);
  Csv csv({"contact", "law", "factor [-]", "gap [original overlaps]", "gap_drawn [original overlaps]", "speed1 [impact speeds]",
           "speed2 [impact speeds]", "speed3 [impact speeds]", "difference_from_sequence [impact speeds]"});
  result.notes = {
      "RPS makes overlaps factor^(−2/5) times larger (non-linear contact) and leaves gaps alone: in its own overlaps a softened row "
      "sees smaller gaps, and three spheres touch at once where the original's collide two by two."};
  const std::string contact = to_string(input.contact.normal);
  Input other = input;
  // The same row with adhesion, if it has none.
  const bool twice = input.contact.normal == NormalModel::hertz && input.material.surface_energy > 0;
  follow(Row(input), contact, systems, csv, result, [&](double done) {
    if (progress) progress(twice ? done / 2 : done);
  });
  add_plots(contact, systems, result);
  if (twice) {
    other.contact = {NormalModel::jkr, AdhesionRange::full, DampingOn::contact_radius};
    follow(Row(other), "jkr", systems, csv, result, [&](double done) {
      if (progress) progress(0.5 + done / 2);
    });
    add_plots("jkr", systems, result);
  }
  result.files = {{"row.csv", csv.text()}};
  return result;
}

}  // namespace scalebreak

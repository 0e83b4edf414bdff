#include <scalebreak/scene/check_cell.hpp>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/bounds.hpp>
#include <scalebreak/scene/flow_scene.hpp>

namespace scalebreak {
namespace {

constexpr double default_wall_speed = 0.3;  ///< about 40/s in the default cell [m/s]
constexpr double default_strain = 4, default_warmup_strain = 2;
constexpr double closest_packing = 0.64;  ///< at random, of spheres of one size
constexpr double default_duration = 0.1;  ///< where nothing is sheared [s]

const char* word_of(CellKind kind) { return cell_kind_words[static_cast<std::size_t>(kind)]; }

std::string words_of(const std::array<Boundary, 3>& boundary) {
  std::vector<std::string> words;
  for (const Boundary b : boundary) words.emplace_back(boundary_words[static_cast<std::size_t>(b)]);
  return to_toml(Value(words));
}

/// Homogeneous shear, at a height that is kept or that follows a pressure.
bool sheared_across_images(CellKind kind) { return kind == CellKind::shear || kind == CellKind::confined_shear; }

void complete_cell(CellInput& cell, const Given& given) {
  using enum Boundary;
  const bool walled = cell.kind == CellKind::box;
  if (!find_given(given, "cell.boundary"))
    cell.boundary = {walled ? wall : periodic, walled ? wall : periodic, walled || cell.kind == CellKind::couette ? wall : periodic};
  if (!sheared_across_images(cell.kind) && !find_given(given, "cell.shear_rate")) cell.shear_rate = 0;
  if (cell.kind == CellKind::couette && !find_given(given, "cell.wall_speed")) cell.wall_speed = default_wall_speed;
}

void check_boundary(const CellInput& cell, const Given& given) {
  using enum Boundary;
  const auto refuse = [&](const char* needs) {
    throw InputError(fmt::format("{}cell.boundary: found {} beside cell.kind = \"{}\"; allowed: {}",
                                 place(given, {"cell.boundary", "cell.kind"}), words_of(cell.boundary), word_of(cell.kind), needs));
  };
  const bool all_periodic = cell.boundary == std::array{periodic, periodic, periodic};
  const auto& [x, y, z] = cell.boundary;
  if ((sheared_across_images(cell.kind) || cell.kind == CellKind::cooling) && !all_periodic)
    refuse("[\"periodic\", \"periodic\", \"periodic\"]");
  if (cell.kind == CellKind::couette && (x != periodic || y == open || z != wall))
    refuse("[\"periodic\", \"periodic\", \"wall\"] or [\"periodic\", \"wall\", \"wall\"]");
}

void check_drive(const Input& input, const Given& given) {
  const CellInput& cell = input.cell;
  const char* kind = word_of(cell.kind);
  const bool walls = cell.boundary[2] == Boundary::wall;
  if (!sheared_across_images(cell.kind) && cell.shear_rate != 0)
    throw InputError(fmt::format("{}cell.shear_rate = {:g} needs cell.kind = \"shear\" or \"confined_shear\", found \"{}\"; allowed: 0{}",
                                 place(given, {"cell.shear_rate"}), cell.shear_rate, kind,
                                 walls ? ", the walls move at cell.wall_speed" : ""));
  if (cell.kind == CellKind::shear && cell.shear_rate == 0)
    throw InputError(fmt::format("{}cell.shear_rate: found 0 beside cell.kind = \"shear\"; allowed: above 0, or kind = \"cooling\"",
                                 place(given, {"cell.shear_rate"})));
  if (cell.kind == CellKind::confined_shear && cell.shear_rate == 0)
    throw InputError(fmt::format("{}cell.shear_rate: found 0 beside cell.kind = \"confined_shear\"; allowed: above 0",
                                 place(given, {"cell.shear_rate"})));
  if (cell.wall_speed != 0 && !(walls && cell.boundary[0] == Boundary::periodic))
    throw InputError(fmt::format("{}cell.wall_speed = {:g} needs walls along z in a cell that is periodic along x, found {}; allowed: 0",
                                 place(given, {"cell.wall_speed"}), cell.wall_speed, words_of(cell.boundary)));
  if (cell.wall_no_slip && std::find(cell.boundary.begin(), cell.boundary.end(), Boundary::wall) == cell.boundary.end())
    throw InputError(fmt::format("{}cell.wall_no_slip = true needs walls, found {}; allowed: false", place(given, {"cell.wall_no_slip"}),
                                 words_of(cell.boundary)));
  if (cell.kind == CellKind::confined_shear && cell.pressure == 0 && find_given(given, "cell.pressure"))
    throw InputError(fmt::format("{}cell.pressure: found 0 beside cell.kind = \"confined_shear\"; allowed: above 0, or kind = \"shear\"",
                                 place(given, {"cell.pressure"})));
  if (cell.kind != CellKind::confined_shear && cell.pressure != 0)
    throw InputError(fmt::format("{}cell.pressure = {:g} needs cell.kind = \"confined_shear\", found \"{}\"; allowed: 0",
                                 place(given, {"cell.pressure"}), cell.pressure, kind));
  for (int axis = 0; axis < 3; ++axis) {
    if (cell.gravity[axis] != 0 && cell.boundary[static_cast<std::size_t>(axis)] == Boundary::periodic)
      throw InputError(
          fmt::format("{}cell.gravity: found {:g} m/s2 along {}, which is periodic, so that everything would fall for ever; "
                      "allowed: 0 there, or a wall",
                      place(given, {"cell.gravity"}), cell.gravity[axis], "xyz"[axis]));
  }
  if (cell.kind == CellKind::cooling && input.particles.speed == 0)
    throw InputError(fmt::format("{}particles.speed: found 0 beside cell.kind = \"cooling\", where nothing would move; allowed: above 0",
                                 place(given, {"particles.speed"})));
}

/// Homogeneous shear under a pressure has no default of either.
void check_confined_is_whole(const CellInput& cell, const Given& given) {
  if (cell.kind != CellKind::confined_shear) return;
  for (const char* key : {"cell.pressure", "cell.shear_rate"}) {
    if (!find_given(given, key))
      throw InputError(fmt::format("{} is missing; cell.kind = \"confined_shear\" needs pressure and shear_rate", key));
  }
}

/// Of a pair of keys that say the same thing, at most one counts.
void check_exclusive(double duration, double strain, const std::string& first, const std::string& other, double rate, const Given& given) {
  if (duration > 0 && strain > 0)
    throw InputError(fmt::format("{}{} and {} exclude each other, found {:g} and {:g}; allowed: one of the two", place(given, {other}),
                                 first, other, duration, strain));
  if (strain > 0 && rate == 0)
    throw InputError(fmt::format("{}{} = {:g} needs a flow that is sheared; allowed: {}", place(given, {other}), other, strain, first));
}

}  // namespace

void complete_and_check_cell(Input& input, const Given& given) {
  complete_cell(input.cell, given);
  check_boundary(input.cell, given);
  check_drive(input, given);
  check_confined_is_whole(input.cell, given);
}

void check_room(const Input& input, const Given& given) {
  const FlowPlan plan = plan_flow(input);
  const std::vector<std::string> blame = {"cell.size", "particles.count", "particles.volume_fraction", "scaling.factor"};
  const double most = bounds_of("particles.volume_fraction").high, most_spheres = bounds_of("particles.count").high;
  if (plan.volume_fraction > most * (1 + 1e-12))
    throw InputError(
        fmt::format("{}particles.count = {} in this cell comes to a volume fraction of {:g}, more than a random filling reaches; "
                    "allowed: at most {:g}",
                    place(given, blame), input.particles.count, plan.volume_fraction, most));
  if (plan.count > most_spheres || plan.count < 1.5)
    throw InputError(fmt::format("{}the flow comes to {:.3g} spheres; allowed: 2 to {:g}", place(given, blame), plan.count, most_spheres));
  for (int axis = 0; axis < 3; ++axis) {
    const Boundary boundary = input.cell.boundary[static_cast<std::size_t>(axis)];
    const double edge = plan.size[axis], least = least_periodic_edge(plan.largest, plan.reach);
    const double pressed = edge * plan.volume_fraction / closest_packing;  // the height that the pressure can bring it to
    if (axis == 2 && input.cell.kind == CellKind::confined_shear && pressed < least)
      throw InputError(
          fmt::format("{}the cell is {:g} m long along z, and {:g} m once the pressure has brought it to a volume fraction of {:g}, "
                      "which is less than two diameters of the largest sphere and the reach of a contact; allowed: at least {:g} m then",
                      place(given, blame), edge, pressed, closest_packing, least));
    if (boundary == Boundary::periodic && edge < least)
      throw InputError(
          fmt::format("{}the cell is {:g} m long along {}, where it is periodic, which is less than two diameters of the largest "
                      "sphere and the reach of a contact; allowed: at least {:g} m",
                      place(given, blame), edge, "xyz"[axis], least));
    if (boundary == Boundary::wall && edge < 2 * plan.largest)
      throw InputError(
          fmt::format("{}the cell is {:g} m long along {}, between its walls, which is less than the diameter of the largest sphere; "
                      "allowed: at least {:g} m",
                      place(given, blame), edge, "xyz"[axis], 2 * plan.largest));
  }
}

void complete_and_check_run(Input& input, const Given& given) {
  RunInput& run = input.run;
  const double rate = mean_shear_rate(input.cell, 1);  // is there one?
  if (!find_given(given, "run.duration") && !find_given(given, "run.strain"))
    rate > 0 ? run.strain = default_strain : run.duration = default_duration;
  if (rate > 0 && !find_given(given, "run.warmup_duration") && !find_given(given, "run.warmup_strain"))
    run.warmup_strain = default_warmup_strain;
  check_exclusive(run.duration, run.strain, "run.duration", "run.strain", rate, given);
  check_exclusive(run.warmup_duration, run.warmup_strain, "run.warmup_duration", "run.warmup_strain", rate, given);
  if (run.duration == 0 && run.strain == 0)
    throw InputError(
        fmt::format("{}run.duration and run.strain are both 0, and a flow does not end by itself; allowed: one of them above 0",
                    place(given, {"run.strain", "run.duration"})));
}

}  // namespace scalebreak

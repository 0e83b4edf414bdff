#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <collisions/naive_stepper.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>
#include <scalebreak/collisions/oblique/oblique_collision.hpp>
#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/pair_resolver.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>

// Cost of one oblique collision: by the planar engine, by the engine of a few bodies, by table, and the naive way. Two glass
// spheres of 1 mm at 0.1 m/s; the impact slides, sticks and slides again.

namespace {

using namespace scalebreak;

struct Laws {
  const char* name;
  ContactKind kind;
  SurfaceKind surface;
};

Input impact(const Laws& laws) {
  Input input;
  input.contact = canonical(laws.kind);
  input.surface = laws.surface;
  input.normal_speed = 0.1;
  input.tangential_speed = 0.05;
  input.spin1 = {0, -30, 0};
  input.spin2 = {0, -10, 0};
  return input;
}

ObliquePair planar(const MovingScene& scene) {
  const auto &a = scene.bodies[0], &b = scene.bodies[1];
  return {.laws = scene.laws[0].laws,
          .mass = a.mass * b.mass / (a.mass + b.mass),
          .radius = {a.radius, b.radius},
          .inertia = {a.inertia, b.inertia},
          .distance = a.radius + b.radius};
}

void exact_planar(benchmark::State& state, const Laws& laws, double tolerance) {
  const ObliquePair pair = planar(moving_scene(impact(laws)));
  ObliqueOutcome outcome;
  for (auto _ : state) benchmark::DoNotOptimize(outcome = resolve_oblique_collision(pair, {0.1, 0.05, {30, 10}}, tolerance));
  state.counters["steps"] = outcome.steps;
}

void exact_bodies(benchmark::State& state, const Laws& laws, double tolerance) {
  const MovingScene scene = moving_scene(impact(laws));
  int steps = 0;
  for (auto _ : state) benchmark::DoNotOptimize(steps = scene.move({.tolerance = tolerance}).steps);
  state.counters["steps"] = steps;
}

/// Velocity Verlet at a fixed step, halved until the velocities and spins are right to `error`.
void naive(benchmark::State& state, const Laws& laws, double error) {
  const MovingScene scene = moving_scene(impact(laws));
  const MotionOutcome exact = scene.move({.tolerance = 1e-11});
  const double contact_time = exact.last_separation - exact.first_touch;
  const auto collide = [&](double steps) {
    return tests::NaivePair(scene.bodies, scene.laws[0]).collide(contact_time / steps, 40L * static_cast<long>(steps));
  };
  const auto wrong = [&](const std::vector<MovingBody>& found) {
    double largest = 0;
    for (std::size_t b = 0; b < 2; ++b) {
      largest = std::max({largest, (found[b].velocity - exact.bodies[b].velocity).norm() / 0.1,
                          found[b].radius * (found[b].spin - exact.bodies[b].spin).norm() / 0.1});
    }
    return largest;
  };
  double steps = 16;
  while (wrong(collide(steps)) > error && steps < 1e7) steps *= 2;
  for (auto _ : state) benchmark::DoNotOptimize(collide(steps));
  state.counters["steps"] = steps;
}

void table_build(benchmark::State& state, const Laws& laws) {
  const auto key = *oblique_key(impact(laws), 1e-4).key;
  ObliqueTable table;
  for (auto _ : state) table = build_oblique_table(key, 0);
  state.counters["error_max"] = table.quality().error_max;
  state.counters["MiB"] = static_cast<double>(table.bytes()) / 1048576;
  state.counters["cells"] = static_cast<double>(table.entries().cells());
  unsigned random = 1;
  const auto start = std::chrono::steady_clock::now();
  constexpr int lookups = 2'000'000;
  for (int i = 0; i < lookups; ++i) {
    random = random * 1664525u + 1013904223u;
    benchmark::DoNotOptimize(table.find(1.8 + 1e-5 * (random >> 8), 1e-4 * (random & 0xffff)));
  }
  state.counters["lookup_ns"] = 1e9 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / lookups;
}

void rolling_table_build(benchmark::State& state, const Laws& laws) {
  const auto key = *rolling_key(impact(laws), 1e-4).key;
  RollingTable table;
  for (auto _ : state) table = build_rolling_table(key, 0);
  state.counters["error_max"] = table.quality().error_max;
  state.counters["KiB"] = static_cast<double>(table.bytes()) / 1024;
  state.counters["cells"] = static_cast<double>(table.entries().cells());
}

/// The whole outcome of a pair in space by its tables.
void pair_lookup(benchmark::State& state, const Laws& laws) {
  const PairResolver pair(impact(laws), {.folder = default_table_folder()}, {.oblique = 1e-3, .turning = 1});
  std::vector<PairImpact> impacts;
  unsigned random = 1;
  const auto number = [&random] { return (random = random * 1664525u + 1013904223u) / 2147483648.0 - 1; };
  for (int i = 0; i < 1024; ++i) {
    const Eigen::Vector3d normal = Eigen::Vector3d(number(), number(), number()).normalized();
    PairImpact impact{.normal = normal};
    impact.velocity = {0.1 * (1.1 + number()) * normal + 0.03 * Eigen::Vector3d(number(), number(), number()), Eigen::Vector3d::Zero()};
    for (auto& spin : impact.spin) spin = 100 * Eigen::Vector3d(number(), number(), number());
    impacts.push_back(impact);
  }
  std::size_t i = 0;
  int refused = 0;
  for (auto _ : state) {
    const PairOutcome outcome = pair.look_up(impacts[++i % impacts.size()]);
    refused += outcome.refusal != Refusal::none;
    benchmark::DoNotOptimize(outcome.velocity[0][0]);
  }
  state.counters["refused"] = static_cast<double>(refused) / static_cast<double>(state.iterations());
}

const int registered = [] {
  using enum RollingModel;
  std::vector<Laws> all;
  const auto add = [&](const char* name, ContactKind kind, RollingModel rolling) {
    const bool linear = kind.normal == NormalModel::linear;
    SurfaceKind surface{.tangential = linear ? TangentialModel::linear : TangentialModel::mindlin, .tangential_radius = kind.damping_on};
    surface.rolling = rolling;
    all.push_back({name, kind, surface});
  };
  const ContactKind linear{.normal = NormalModel::linear}, hertz{.normal = NormalModel::hertz}, jkr;
  const ContactKind on_overlap{.damping_on = DampingOn::overlap};
  add("linear", linear, none), add("hertz", hertz, none), add("jkr", jkr, none), add("jkr_overlap", on_overlap, none);
  add("hertz_cdt", hertz, cdt), add("hertz_epsd", hertz, epsd), add("jkr_ar", jkr, ar);
  for (const Laws& laws : all) {
    const std::string name = laws.name;
    benchmark::RegisterBenchmark(("oblique/planar/1e-8/" + name).c_str(), exact_planar, laws, 1e-8)->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("oblique/bodies/1e-8/" + name).c_str(), exact_bodies, laws, 1e-8)->Unit(benchmark::kMicrosecond);
    for (const double error : {1e-3, 1e-4, 1e-5}) {
      benchmark::RegisterBenchmark(fmt::format("oblique/naive_verlet/{:.0e}/{}", error, name).c_str(), naive, laws, error)
          ->Unit(benchmark::kMicrosecond);
    }
    if (laws.kind.damping_on == DampingOn::contact_radius || !laws.kind.adhesive()) {
      benchmark::RegisterBenchmark(("oblique/pair_lookup/" + name).c_str(), pair_lookup, laws)->Unit(benchmark::kNanosecond);
    }
    if (laws.surface.rolling != none) {
      benchmark::RegisterBenchmark(("oblique/rolling_table_build/1e-4/" + name).c_str(), rolling_table_build, laws)
          ->Unit(benchmark::kSecond)
          ->Iterations(1)
          ->UseRealTime();
    } else {
      benchmark::RegisterBenchmark(("oblique/table_build/1e-4/" + name).c_str(), table_build, laws)
          ->Unit(benchmark::kSecond)
          ->Iterations(1)
          ->UseRealTime();
    }
  }
  return 0;
}();

}  // namespace

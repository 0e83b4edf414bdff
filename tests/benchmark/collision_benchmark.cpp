#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/collisions/tables/table_builder.hpp>
#include <scalebreak/contact/damping.hpp>
#include <scalebreak/contact/reduced.hpp>

#include "collisions/kinds.hpp"

// Cost of one normal collision: exact, by table, and the naive way. Run with --benchmark_repetitions=9 and read medians.

namespace {

using namespace scalebreak;

constexpr double speed = 3.0;
const double beta = damping_ratio(0.81);

double impact_speed(const ContactKind& kind) { return kind.adhesive() ? speed : 1.0; }

void exact_collision(benchmark::State& state, ContactKind kind, double tolerance) {
  int steps = 0;
  double v = impact_speed(kind);
  for (auto _ : state) {
    const auto outcome = resolve_normal_collision<double>(kind, beta, v, {.tolerance = tolerance});
    benchmark::DoNotOptimize(steps = outcome.steps);
  }
  state.counters["steps"] = steps;
}

/// Fixed steps of velocity Verlet in the overlap, with the dashpot at the half-step's speed, as a soft-sphere program does it;
/// contact ends with the step that leaves it. Returns the restitution.
template <class Law>
double verlet(const Law& law, double v, double h) {
  const double end = law.overlap(law.separation());
  double overlap = 0, acceleration = -(law.force(law.touch()) + law.damping(law.touch()) * v);
  const double v0 = v;
  for (;;) {
    v += h / 2 * acceleration;
    overlap += h * v;
    if (overlap <= end) return -v / v0;
    const double x = law.coordinate(overlap);
    acceleration = -(law.force(x) + law.damping(x) * v);
    v += h / 2 * acceleration;
  }
}

template <class Law>
void naive_collision(benchmark::State& state, const ContactKind& kind, const Law& law, double error) {
  const auto exact = resolve_normal_collision<double>(kind, beta, impact_speed(kind), {.tolerance = 1e-12});
  double steps = 16;
  while (std::abs(verlet(law, impact_speed(kind), exact.contact_time / steps) - exact.restitution) > error && steps < 1e8) steps *= 2;
  for (auto _ : state) benchmark::DoNotOptimize(verlet(law, impact_speed(kind), exact.contact_time / steps));
  state.counters["steps"] = steps;
}

void table_build(benchmark::State& state, ContactKind kind) {
  double error = 0;
  for (auto _ : state) error = build_collision_table({kind, 1e-6}).quality().error_max;
  state.counters["error_max"] = error;
}

/// Speeds that no branch predictor knows.
double next_speed(unsigned& random) {
  random = random * 1664525u + 1013904223u;
  return 1.5 + 1e-5 * (random >> 8);
}

void row_lookup(benchmark::State& state, ContactKind kind) {
  const TableRow row = *build_collision_table({kind, 1e-6}).row(beta);
  unsigned random = 1;
  for (auto _ : state) benchmark::DoNotOptimize(row.find(next_speed(random)));
}

void table_lookup(benchmark::State& state, ContactKind kind) {
  const CollisionTable table = build_collision_table({kind, 1e-6});
  unsigned random = 1;
  for (auto _ : state) {
    const double v = next_speed(random);
    benchmark::DoNotOptimize(table.find(0.001 + 0.003 * v, v));
  }
}

const int registered = [] {
  for (const ContactKind& kind : all_contact_kinds()) {
    const std::string name = tests::kind_name(kind);
    benchmark::RegisterBenchmark(("exact/1e-10/" + name).c_str(), exact_collision, kind, 1e-10)->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("row_lookup/" + name).c_str(), row_lookup, kind);
    benchmark::RegisterBenchmark(("table_lookup/" + name).c_str(), table_lookup, kind);
    benchmark::RegisterBenchmark(("table_build/1e-6/" + name).c_str(), table_build, kind)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->UseRealTime();
  }
  const ContactKind hertz = canonical({.normal = NormalModel::hertz}), jkr;
  for (const double error : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const std::string suffix = fmt::format("{:.0e}", error);
    benchmark::RegisterBenchmark(("exact/" + suffix + "/hertz").c_str(), exact_collision, hertz, std::min(error, 1e-6))
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("naive_verlet/" + suffix + "/hertz").c_str(), [=](benchmark::State& state) {
      naive_collision(state, hertz, reduced_law<Hertz>(beta), error);
    })->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("naive_verlet/" + suffix + "/jkr").c_str(), [=](benchmark::State& state) {
      naive_collision(state, jkr, reduced_law<JkrOnRadius>(beta, AdhesionRange::full), error);
    })->Unit(benchmark::kMicrosecond);
  }
  return 0;
}();

}  // namespace

#include "flow_comparison.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/comparison.hpp>
#include <scalebreak/measure/flow_json.hpp>
#include <scalebreak/measure/flow_measurement.hpp>
#include <scalebreak/statistics/block_series.hpp>
#include <scalebreak/statistics/standard_error.hpp>

#include "lammps_series.hpp"
#include "peer_scene.hpp"

namespace scalebreak::peers {
namespace {

constexpr PeerScene gas = {"flow", 1e8, false, false, 0, 0};

std::string row(const std::string& name, const std::string& unit, const Measured& ours, const Measured& theirs,
                const Measured& difference) {
  return fmt::format("| {} | {} | {:.5g} ± {:.1g} | {:.5g} ± {:.1g} | {:+.2f} % ± {:.2f} % | {:+.1f} |\n", name, unit, ours.value,
                     ours.error, theirs.value, theirs.error, 100 * difference.value / theirs.value,
                     std::abs(100 * difference.error / theirs.value), difference.value / difference.error);
}
constexpr const char* head =
    " | unit | scalebreak | LAMMPS | scalebreak − LAMMPS | in standard errors |\n| --- | --- | --- | --- | --- | --- |\n";

FlowResult run_shear(const ShearRun& run, System state) {
  state.cell.shear_rate = run.rate;
  for (std::size_t i = 0; i < state.count(); ++i) state.velocity[i] += mean_flow(state.cell, state.position[i].z());
  DemSetup setup = peer_setup(gas, run.restitution, false);
  setup.threads = run.threads;
  Dem dem(state, setup);
  dem.advance(run.warm_up);
  FlowMeasurement measurement;
  const auto measure = [&] {
    const System system = dem.system();
    const std::vector<ContactForce> contacts = dem.contact_forces();
    const DemTotals& totals = dem.totals();
    measurement.add({.system = system,
                     .contacts = contacts,
                     .contact_starts = totals.contact_starts,
                     .elastic_energy = dem.elastic_energy(),
                     .shear_work = totals.shear_work,
                     .contact_time = totals.contact_time,
                     .contact_moment = totals.contact_moment});
  };
  measure();
  for (long step = 0; step < run.steps; step += run.every) {
    dem.advance(run.every);
    measure();
  }
  return measurement.result();
}

/// The mean of a column of the series, its rows evenly spaced in time.
template <class Value>
Measured mean(const std::vector<SeriesRow>& rows, Value value) {
  BlockSeries series;
  for (const SeriesRow& r : rows) series.add(Eigen::Array2d(value(r), 1));
  std::vector<double> sums, numbers;
  for (const Eigen::ArrayXd& block : series.blocks()) {
    sums.push_back(block[0]);
    numbers.push_back(block[1]);
  }
  return ratio_of_sums(sums, numbers);
}

struct Thermal {
  double temperature, rotational_energy;
};
Thermal thermal(const System& system) {
  Thermal sum{0, 0};
  for (std::size_t i = 0; i < system.count(); ++i) {
    sum.temperature += system.velocity[i].squaredNorm() / 3;
    sum.rotational_energy += system.inertia(i) * system.spin[i].squaredNorm() / 2;
  }
  const double count = static_cast<double>(system.count());
  return {sum.temperature / count, sum.rotational_energy / count};
}

/// Of independent values.
Measured independent_mean(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += std::pow(value - sum / count, 2);
  return {sum / count, std::sqrt(squares / (count - 1) / count)};
}

}  // namespace

std::string compare_shear(const ShearRun& run) {
  const std::vector<SeriesRow> rows = read_series(run.series);
  const long covered = rows.back().step - rows.front().step;
  if (covered != run.steps)
    throw InputError(fmt::format("{}: the series covers {} steps; allowed: {}, as --steps says", run.series, covered, run.steps));
  const System state = peer_state(run.state, false);
  double mass = 0;
  for (const double m : state.mass) mass += m;
  const double solid_density = mass / state.cell.volume();

  const std::vector<Quantity> ours = all_quantities(run_shear(run, state));
  const std::vector<Quantity> theirs = {
      {"temperature", "m2/s2", mean(rows, [](const SeriesRow& r) { return r.temperature; })},
      {"rotational_energy", "J", mean(rows, [](const SeriesRow& r) { return r.rotational_energy; })},
      {"coordination", "-", mean(rows, [](const SeriesRow& r) { return r.coordination; })},
      {"pressure", "Pa", mean(rows, [&](const SeriesRow& r) { return r.contact_pressure + solid_density * r.temperature; })},
      {"stress_contact_zx", "Pa", mean(rows, [](const SeriesRow& r) { return r.contact_stress_xz; })},
  };
  std::string table = std::string("| quantity") + head;
  for (const Comparison& c : compare(theirs, ours)) table += row(c.name, c.unit, c.second, c.first, c.difference);
  return table;
}

std::string compare_cooling(const CoolingRun& run) {
  if (run.states.size() != run.series.size() || run.states.size() < 3)
    throw InputError(
        fmt::format("--states: found {}, and {} --series; allowed: as many of both, at least 3", run.states.size(), run.series.size()));
  std::vector<std::vector<SeriesRow>> theirs;
  std::vector<std::vector<Thermal>> ours;
  DemSetup setup = peer_setup(gas, run.restitution, false);
  setup.threads = run.threads;
  for (std::size_t k = 0; k < run.states.size(); ++k) {
    theirs.push_back(read_series(run.series[k]));
    Dem dem(peer_state(run.states[k], false), setup);
    for (const SeriesRow& r : theirs.back()) {
      dem.advance(r.step - dem.steps());
      if (ours.size() == k) ours.emplace_back();
      ours.back().push_back(thermal(dem.system()));
    }
    if (theirs.back().size() != theirs.front().size()) throw InputError(run.series[k] + ": of another length than the first series");
  }
  std::string table = std::string("| after steps, quantity") + head;
  for (std::size_t i = 1; i < theirs.front().size(); ++i) {
    const auto add = [&](const char* name, const char* unit, auto our, auto their) {
      std::vector<double> first, second, difference;
      for (std::size_t k = 0; k < theirs.size(); ++k) {
        first.push_back(our(ours[k][i]));
        second.push_back(their(theirs[k][i]));
        difference.push_back(first.back() - second.back());
      }
      table += row(fmt::format("{}, {}", theirs.front()[i].step, name), unit, independent_mean(first), independent_mean(second),
                   independent_mean(difference));
    };
    add(
        "temperature", "m2/s2", [](const Thermal& t) { return t.temperature; }, [](const SeriesRow& r) { return r.temperature; });
    add(
        "rotational_energy", "J", [](const Thermal& t) { return t.rotational_energy; },
        [](const SeriesRow& r) { return r.rotational_energy; });
  }
  return table;
}

}  // namespace scalebreak::peers

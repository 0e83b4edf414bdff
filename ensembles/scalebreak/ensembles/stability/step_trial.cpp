#include <scalebreak/ensembles/stability/step_trial.hpp>

#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

constexpr long steps_between_looks = 50, most_steps = 100'000'000;
constexpr double hopeless_growth = 10;

double energy_of(const Dem& dem) {
  const System system = dem.system();
  double energy = dem.elastic_energy();
  for (std::size_t i = 0; i < system.count(); ++i)
    energy += system.mass[i] / 2 * system.velocity[i].squaredNorm() + system.inertia(i) / 2 * system.spin[i].squaredNorm();
  return energy;
}

}  // namespace

StepTrial try_step(const System& start, const DemSetup& setup, double collisions) {
  StepTrial trial{.step = setup.step};
  Dem dem(start, setup);
  dem.keep_sums(false);
  const double before = energy_of(dem);
  double energy = before;
  while (trial.collisions < collisions && energy < hopeless_growth * before) {
    if (dem.steps() > most_steps)
      throw WorkError(fmt::format("after {} steps each sphere has had {:.3g} collisions on the mean, and a trial of the step needs {:g}",
                                  dem.steps(), trial.collisions, collisions));
    try {
      dem.advance(steps_between_looks);
    } catch (const WorkError& error) {
      trial.stopped = error.what();
      return trial;
    }
    trial.collisions = 2 * dem.totals().contact_starts / static_cast<double>(dem.count());
    energy = energy_of(dem);
  }
  if (trial.collisions > 0) trial.energy_growth = std::log(energy / before) / trial.collisions;
  return trial;
}

}  // namespace scalebreak

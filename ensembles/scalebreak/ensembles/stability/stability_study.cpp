#include <scalebreak/ensembles/stability/stability_study.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/collisions/parallel.hpp>
#include <scalebreak/dem/critical_step.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/ensembles/engine/flow_start.hpp>
#include <scalebreak/ensembles/engine/step_choice.hpp>
#include <scalebreak/ensembles/stability/elastic_scene.hpp>
#include <scalebreak/ensembles/stability/rolling_left.hpp>
#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>
#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>

namespace scalebreak {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Mean and standard error of so many values.
Measured over_seeds(const std::vector<double>& values) {
  if (values.empty()) return {nothing, nothing};
  const double n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  return {sum / n, values.size() > 1 ? std::sqrt(squares / (n * (n - 1))) : 0};
}

/// One bisection.
struct Job {
  StabilityRecord* record;
  const StabilityCriterion* criterion;
  const Input* input;
  Integrator integrator;
  std::size_t seed;
};

double smallest_radius(const System& system) { return *std::min_element(system.radius.begin(), system.radius.end()); }

/// A collision at one step.
StepTrial try_collision(const CollisionScene& scene, const Job& job, double fraction) {
  const auto phases = static_cast<int>(scene.input.tradeoff.phases);
  if (job.criterion->at_rest)
    return {.fraction = fraction,
            .step = step_of(scene, fraction),
            .collisions = 1,
            .rolling_left = rolling_left(scene, job.integrator, fraction, phases)};
  const CollisionMethod& method = collision_methods()[static_cast<std::size_t>(job.integrator)];
  const CollisionPoint point = measure_collision(scene, method, fraction, phases);
  StepTrial trial{.fraction = fraction, .step = point.step, .collisions = 1, .motion_error = point.motion_largest};
  if (point.unparted > 0) trial.stopped = fmt::format("in {} of {} collisions the bodies did not part", point.unparted, point.phases);
  return trial;
}

LargestStep bisect(const Job& job) {
  Input input = *job.input;
  input.run.integrator = job.integrator;
  if (!input.flow) {
    const CollisionScene scene = collision_scene(input);
    return largest_step([&](double fraction) { return try_collision(scene, job, fraction); },
                        [&](const StepTrial& trial) { return job.criterion->holds(trial, input); });
  }
  const FlowStart start = flow_start(input, job.seed);
  const double rayleigh = rayleigh_step(dem_setup(input, 0, 1), smallest_radius(start.system));
  return largest_step(
      [&](double fraction) {
        StepTrial trial = try_step(start.system, dem_setup(input, fraction * rayleigh, 1), collisions_of_a_trial);
        trial.fraction = fraction;
        return trial;
      },
      [&](const StepTrial& trial) { return job.criterion->holds(trial, input); });
}

/// The same of a collision.
StabilityRecord collision_record(const Input& input, Integrator integrator, const StabilityCriterion& criterion) {
  const CollisionScene scene = collision_scene(input);
  StabilityRecord record{.law = input.scaling_law,
                         .factor = input.scaling_factor,
                         .integrator = integrator_words[static_cast<std::size_t>(integrator)],
                         .criterion = criterion.name,
                         .rayleigh = step_of(scene, 1),
                         .contact = {},
                         .seeds = std::vector<LargestStep>(1)};
  if (scene.reference.last_separation > 0) record.contact.time = scene.reference.last_separation - scene.reference.first_touch;
  return record;
}

StabilityRecord record_of(const Input& input, Integrator integrator, const StabilityCriterion& criterion) {
  if (!input.flow) return collision_record(input, integrator, criterion);
  const FlowStart start = flow_start(input);
  const StepScene scene = step_scene(input, start.system, start.speed);
  const DemSetup setup = dem_setup(input, 0, 1);
  StabilityRecord record{.law = input.scaling_law,
                         .factor = input.scaling_factor,
                         .integrator = integrator_words[static_cast<std::size_t>(integrator)],
                         .criterion = criterion.name,
                         .rayleigh = rayleigh_step(setup, smallest_radius(start.system)),
                         .contact = shortest_contact(input, scene.smallest, scene.walls, scene.meeting, nullptr),
                         .seeds = std::vector<LargestStep>(input.run.replicas)};
  for (const StepBound& bound : critical_steps(setup, smallest_radius(start.system))) {
    if (bound.name == "oscillation") record.oscillation = bound.step;
  }
  return record;
}

const StabilityCriterion& criterion_of(const StabilityRecord& record) {
  for (const bool flow : {true, false}) {
    for (const StabilityCriterion& criterion : stability_criteria(flow)) {
      if (record.criterion == criterion.name) return criterion;
    }
  }
  throw WorkError(fmt::format("there is no criterion {}", record.criterion));
}

/// The criterion's number at an end of the bracket, of the seeds whose trial went on to its end.
double value_at(const StabilityRecord& record, std::optional<StepTrial> LargestStep::*end) {
  std::vector<double> values;
  for (const LargestStep& seed : record.seeds) {
    const std::optional<StepTrial>& trial = seed.*end;
    if (trial && trial->stopped.empty()) values.push_back(criterion_of(record).of(*trial));
  }
  return over_seeds(values).value;
}

}  // namespace

std::size_t StabilityRecord::without_bracket() const {
  return static_cast<std::size_t>(std::count_if(seeds.begin(), seeds.end(), [](const LargestStep& seed) { return !seed.found(); }));
}

Measured StabilityRecord::fraction() const {
  std::vector<double> fractions;
  double half = 0;
  for (const LargestStep& seed : seeds) {
    if (seed.found()) fractions.push_back(seed.fraction()), half = std::max(half, seed.half_width());
  }
  Measured mean = over_seeds(fractions);
  mean.error = std::max(mean.error, half);
  return mean;
}

Measured StabilityRecord::step() const {
  const Measured of_rayleigh = fraction();
  return {of_rayleigh.value * rayleigh, of_rayleigh.error * rayleigh};
}

double StabilityRecord::value_below() const { return value_at(*this, &LargestStep::stable); }
double StabilityRecord::value_above() const { return value_at(*this, &LargestStep::unstable); }

std::string StabilityRecord::failure() const {
  bool beyond = false;
  for (const LargestStep& seed : seeds) {
    if (seed.unstable && !seed.unstable->stopped.empty()) return seed.unstable->stopped;
    beyond = beyond || seed.unstable;
  }
  return beyond ? criterion + " exceeds its limit" : "none was seen";
}

const StabilityRecord& StabilityStudy::original_of(const StabilityRecord& record) const {
  return *std::find_if(records.begin(), records.end(), [&](const StabilityRecord& other) {
    return other.criterion == record.criterion && other.integrator == record.integrator;
  });
}

std::vector<Input> stability_inputs(const Input& input, int* skipped) {
  const auto under = [scene = input.flow ? elastic_scene(input) : input](const std::string& law, double factor) {
    Input scaled = scene;
    scaled.scaling_law = law, scaled.scaling_factor = factor;
    return scaled;
  };
  std::vector<Input> all = {under("none", 1)};
  for (const std::string& name : study_laws(all.front())) {
    for (const double factor : input.study_factors) {
      if (refusal(*find_scaling_law(name), factor, input.contact.normal)) {
        if (skipped) ++*skipped;
        continue;
      }
      all.push_back(under(name, factor));
    }
  }
  return all;
}

StabilityStudy run_stability(const Input& input, int threads, const std::function<void(double)>& progress) {
  if (input.flow && input.particles.file.empty() && input.particles.speed == 0)
    throw InputError("particles.speed: found 0, and a step is tried on collisions; allowed: above 0");
  StabilityStudy study{.flow = input.flow, .records = {}};
  const std::vector<Input> inputs = stability_inputs(input, &study.skipped);
  if (input.flow) {
    const FlowStart original = flow_start(inputs.front());
    study.spheres = original.system.count(), study.speed = original.speed;
  } else {
    const CollisionScene original = collision_scene(inputs.front());
    study.spheres = original.moving.bodies.size(), study.speed = original.speed;
  }
  study.criteria = stability_criteria(inputs.front());
  std::vector<Job> jobs;
  study.records.reserve(inputs.size() * study.criteria.size() * input.study_integrators.size());  // jobs point into it
  for (const StabilityCriterion& criterion : study.criteria) {
    for (const Integrator integrator : input.study_integrators) {
      for (const Input& scaled : inputs) {
        StabilityRecord& record = study.records.emplace_back(record_of(scaled, integrator, criterion));
        for (std::size_t seed = 0; seed < record.seeds.size(); ++seed) jobs.push_back({&record, &criterion, &scaled, integrator, seed});
      }
    }
  }
  std::atomic<std::size_t> done = 0;
  parallel_for(jobs.size(), threads, [&](std::size_t k) {
    jobs[k].record->seeds[jobs[k].seed] = bisect(jobs[k]);
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(jobs.size()));
  });
  return study;
}

}  // namespace scalebreak

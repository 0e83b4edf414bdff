#include <scalebreak/ensembles/run/flow_run.hpp>

#include <algorithm>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/ensembles/engine/energy_account.hpp>
#include <scalebreak/ensembles/engine/engine_names.hpp>
#include <scalebreak/ensembles/engine/event_engine.hpp>
#include <scalebreak/ensembles/engine/flow_start.hpp>
#include <scalebreak/ensembles/engine/hybrid_engine.hpp>
#include <scalebreak/start/filling.hpp>

namespace scalebreak {
namespace {

double gravity_energy(const System& system, const Eigen::Vector3d& gravity) {
  if (gravity.isZero(0)) return 0;
  double energy = 0;
  for (std::size_t i = 0; i < system.count(); ++i) energy += system.mass[i] * gravity.dot(system.position[i]);
  return energy;
}

TableStore store_of(const TableStore* tables) { return tables ? *tables : TableStore{.folder = default_table_folder()}; }

}  // namespace

Sample FlowInstant::sample() const {
  return {.system = system,
          .contacts = contacts,
          .contact_starts = totals.contact_starts,
          .work = work,
          .elastic_energy = elastic_energy,
          .forces_known = forces_known,
          .shear_work = totals.shear_work,
          .dissipated = totals.dissipated,
          .contact_time = totals.contact_time,
          .contact_moment = totals.contact_moment};
}

void FlowRun::plan(const Input& input, const System& start, double speed, const TableStore* tables) {
  const RunTimes times = run_times(input, start.cell);
  if (steps(record_.engine)) record_.step = choose_step(input, step_scene(input, start, speed), tables);
  if (flies(record_.engine)) {
    const double most = std::min(event_sample_interval(start, speed), times.interval);
    record_.schedule = run_schedule(times, most / most_steps_per_sample);
  } else {
    record_.schedule = run_schedule(times, record_.step.step);
  }
  if (!record_.step.warning.empty()) record_.warnings.push_back(record_.step.warning);
}

template <class Start>
std::unique_ptr<FlowEngine> FlowRun::make_engine(const Start& start, const Input& input, int threads, const TableStore* tables) const {
  const DemSetup setup = dem_setup(input, flies(record_.engine) ? record_.step.step : record_.schedule.step, threads);
  if (record_.engine == "event") return std::make_unique<EventEngine>(start, input, store_of(tables));
  if (record_.engine == "hybrid") return std::make_unique<HybridEngine>(start, input, store_of(tables), setup);
  return std::make_unique<DemEngine>(start, setup, why_account_is_open(input).has_value());
}

FlowRun::FlowRun(const Input& input, std::uint64_t replica, int threads, const TableStore* tables, const std::string& engine)
    : gravity_(input.cell.gravity) {
  const FlowStart start = flow_start(input, replica);
  const System& system = start.system;
  record_.replica = replica;
  record_.particles = system.count();
  record_.cell = system.cell.size;
  record_.volume_fraction = volume_fraction(system.cell, system.radius);
  record_.gravity_energy = gravity_energy(system, gravity_);
  record_.warnings = start.warnings;
  record_.engine = engine;
  plan(input, system, start.speed, tables);
  engine_ = make_engine(system, input, threads, tables);
  engine_->keep_sums(measures());
  look();
}

FlowRun::FlowRun(const Input& input, std::string_view saved, int threads, const TableStore* tables) : gravity_(input.cell.gravity) {
  record_.load(saved);
  take_bytes(saved, sample_);
  measurement_.load(take_text(saved));
  const std::string engine = take_text(saved);
  engine_ = make_engine(std::string_view(engine), input, threads, tables);
  engine_->keep_sums(measures());
}

void FlowRun::look() {
  if (!row_is_due() && !measures()) return;
  instant_ = {engine_->system(), engine_->contact_forces(), engine_->totals(), engine_->elastic_energy(), 0, engine_->tells_forces()};
  instant_.work = instant_.totals.wall_work + gravity_energy(instant_.system, gravity_) - record_.gravity_energy;
  if (measures()) measurement_.add(instant_.sample());
}

void FlowRun::advance() {
  engine_->advance_to(record_.schedule.time_of(sample_ + 1));
  ++sample_;
  if (sample_ == record_.schedule.warmup_samples) engine_->keep_sums(true);
  const EngineTotals totals = engine_->totals();
  record_.time = engine_->time(), record_.steps = totals.steps, record_.events = totals.events, record_.integrated = totals.integrated,
  record_.delayed = totals.delayed, record_.patches = totals.patches, record_.handovers = totals.handovers;
  record_.contact_starts = totals.contact_starts;
  const RunWork done = RunWork::of(totals, static_cast<double>(record_.particles));
  if (sample_ <= record_.schedule.warmup_samples) record_.warmup = done;
  record_.work = {done.evaluations - record_.warmup.evaluations, done.lookups - record_.warmup.lookups,
                  done.sphere_steps - record_.warmup.sphere_steps};
  look();
}

std::string FlowRun::save() const {
  std::string bytes;
  record_.save(bytes);
  put_bytes(bytes, sample_);
  put_text(bytes, measurement_.save());
  put_text(bytes, engine_->save());
  return bytes;
}

}  // namespace scalebreak

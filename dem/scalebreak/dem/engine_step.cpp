#include <cmath>

#include <fmt/format.h>
#include <omp.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/engine.hpp>
#include <scalebreak/dem/list_keeper.hpp>
#include <scalebreak/dem/team_barrier.hpp>

namespace scalebreak {

using namespace dem;

namespace {

/// A sphere that moves by more than this share of the smallest radius in a step has left what its laws can follow.
constexpr double farthest_in_a_step = 0.1;

}  // namespace

template <class Work>
void Dem::Engine::guarded(Worker& worker, Work work) {
  if (worker.failure) return;
  try {
    work();
  } catch (...) {
    worker.failure = std::current_exception();
  }
}

void Dem::Engine::rethrow() {
  for (Worker& worker : workers_) {
    if (worker.failure) std::rethrow_exception(worker.failure);
  }
}

void Dem::Engine::advance(long steps) {
  failed_ = false;
  const int threads = static_cast<int>(workers_.size());
  TeamBarrier all(threads);
  int granted = 0;
#pragma omp parallel num_threads(threads)
  {
#pragma omp single
    granted = omp_get_num_threads();
    Worker& worker = workers_[static_cast<std::size_t>(omp_get_thread_num())];
    for (long step = 0; step < steps && !failed_ && granted == threads; ++step) {
      move(worker);
      if (height_.follows()) map_onto_height(worker);
      all.wait([&] { guarded(worker, [&] { plan_lists(); }); });
      if (lists_due_) {
        if (grid_due_) guarded(worker, [&] { find_neighbours(worker); });
        if (!grid_due_) bring_up_resting(worker);
        all.wait();
        guarded(worker, [&] { select_pairs(worker); });
        clear_marks(worker);
        all.wait();
        mark_movers(worker);
        collect_pushed(worker);
        all.wait();
        collect_movers(worker);
      }
      guarded(worker, [&] { find_contacts(worker); });
      if (histories_are_ahead() && workers_.size() > 1) {
        all.wait();
        adopt_met(worker);
        all.wait();
      }
      guarded(worker, [&] { add_forces(worker, history_steps()); });
      all.wait();
      fetch_deferred(worker);
      if (height_.follows()) sum_normal_flux(worker);
      all.wait([&] { finish_step(); });
    }
  }
  if (granted != threads)
    throw WorkError(fmt::format("the system grants {} of {} threads; ask for fewer, or see OMP_THREAD_LIMIT", granted, threads));
  rethrow();
}

void Dem::Engine::finish_step() {
  if (lists_due_) lists_due_ = grid_due_ = false, steps_since_lists_ = 0, travel_ = 0;
  for (const Worker& each : workers_) failed_ = failed_ || each.failure;
  if (!failed_ && height_.follows()) push_height();
  if (!failed_) take_tallies();
}

void Dem::Engine::move(Worker& worker) {
  const std::uint32_t stretch = worker.end - worker.begin, movers = static_cast<std::uint32_t>(worker.movers.size());
  MoveTask task{.spheres = spheres_.view(), .step = setup_.step, .shear_rate = flow_rate_, .middle = cell_.size.z() / 2};
  task.gravity = {setup_.gravity.x(), setup_.gravity.y(), setup_.gravity.z(), 0};
  if (!spheres_.seen_velocity.empty()) {
    task.estimate = spheres_.seen_velocity.data();
    task.estimate_spin = turns_ ? spheres_.seen_spin.data() : nullptr;
  }
  task.pushed = worker.pushed.data(), task.pushed_count = static_cast<std::uint32_t>(worker.pushed.size());
  if (movers == stretch) {
    task.begin = worker.begin, task.end = worker.end;
  } else {
    task.movers = worker.movers.data(), task.end = movers;
  }
  kernel_.move(task);
  worker.fastest_squared = task.fastest_squared;
}

double Dem::Engine::travel_of(double fastest_squared) const {
  const double shared = std::abs(flow_rate_) + std::abs(stretch_ - 1) / setup_.step;  // of the distance, in a second
  return setup_.step * (2 * std::sqrt(fastest_squared) + shared * (2 * largest_ + largest_reach() + skins_.neighbours));
}

void Dem::Engine::plan_lists() {
  ++steps_, ++steps_since_lists_;
  if (height_.follows()) stretch_cell();
  double fastest = 0;
  for (const Worker& worker : workers_) {
    // What flies on its own may have gained by gravity, and by where it is in the mean flow.
    const double time = setup_.step * static_cast<double>(steps_since_lists_);
    const double resting = std::sqrt(worker.resting_fastest_squared) * (1 + std::abs(flow_rate_) * time) + setup_.gravity.norm() * time;
    if (!std::isfinite(worker.fastest_squared)) unstable(worker.fastest_squared);
    fastest = std::max({fastest, worker.fastest_squared, resting * resting});
  }
  fastest_squared_ = fastest;
  if (!(std::sqrt(fastest) * setup_.step <= farthest_in_a_step * smallest_)) unstable(std::sqrt(fastest));
  const double travel = travel_of(fastest);
  travel_ += travel, travel_of_grid_ += travel;
  grid_due_ = travel_of_grid_ > skins_.neighbours;
  lists_due_ = grid_due_ || travel_ > skins_.near;
  if (cell_.shear_rate != 0 || height_.follows()) images_ = Images(cell_, image_offset());
  totals_.lists_made += lists_due_ ? 1 : 0;
  if (!grid_due_) return;
  for (Worker& worker : workers_) bring_up_resting(worker);
  make_grid(contact_memories());
}

double Dem::Engine::image_offset() const {
  if (height_.follows()) return grid_offset_;
  return grid_offset_ + cell_.shear_rate * cell_.size.z() * setup_.step * static_cast<double>(steps_ - steps_at_grid_);
}

void Dem::Engine::unstable(double speed) const {
  throw WorkError(
      fmt::format("the run became unstable at t = {:.6g} s (step {}): the fastest sphere moves at {:.3g} m/s, {:.2g} of the smallest "
                  "radius in a step of {:.3g} s; allowed: {:g} of it; take a smaller step",
                  time(), steps_, speed, speed * setup_.step / smallest_, setup_.step, farthest_in_a_step));
}

Dem::Engine::HistorySteps Dem::Engine::history_steps() const {
  const double after = histories_are_ahead() ? setup_.step / 2 : 0.0;
  return {setup_.step - after, after};
}

Dem::Engine::HistorySteps Dem::Engine::history_steps_again() const {
  const double after = history_steps().after;
  return {-after, after};
}

ForceTask Dem::Engine::force_task(Worker& worker, Pairs& pairs, const WallView* wall, HistorySteps histories) {
  const LawRows& rows = rows_for(worker, wall != nullptr);
  const MappedLaws& mapped = rows.mapped();
  return {.spheres = spheres_.view(),
          .near = pairs.near(),
          .contacts = pairs.contacts.view(),
          .diameter = smallest_ == largest_ ? 2 * smallest_ : 0.0,
          .rows = rows.rows(),
          .one_row = rows.one(),
          .hold = rows.hold(),
          .bridge = rows.bridge(),
          .shift = images_.shift.data(),
          .shift_velocity = images_.velocity.data(),
          .stretch_rate = stretch_rate_,
          .wall = wall,
          .length = mapped.length,
          .spin = mapped.spin,
          .force = mapped.force,
          .torque = mapped.torque,
          .radius_share = rows.radius_share(),
          .history_step = histories.before,
          .history_after = histories.after,
          .turns = turns_,
          .sums_moment = keep_sums_ || height_.follows(),
          .own_begin = worker.begin,
          .own_end = worker.end,
          .deferred = worker.deferred.data(),
          .deferred_count = worker.deferred_count,
          .deferred_room = static_cast<std::uint32_t>(worker.deferred.size())};
}

void Dem::Engine::find_contacts(Worker& worker) {
  worker.met.clear();
  const auto find = [&](Pairs& pairs, const WallView* wall) {
    ForceTask task = force_task(worker, pairs, wall, {0, 0});
    ListKeeper keeper(*this, worker, pairs, wall != nullptr);
    task.keeper = &keeper;
    kernel_.find_contacts(task);
    worker.tally.starts += task.tally.starts;
  };
  find(worker.pairs, nullptr);
  for (std::size_t w = 0; w < walls_.size(); ++w) find(worker.walls[w].pairs, &walls_[w]);
}

void Dem::Engine::adopt_met(Worker& worker) {
  for (const Worker& other : workers_) {
    for (const std::uint32_t sphere : other.met) meet(worker, sphere);
  }
}

void Dem::Engine::add_forces(Worker& worker, HistorySteps histories) {
  worker.deferred_count = 0;
  const auto run = [&](Pairs& pairs, const WallView* wall) {
    ForceTask task = force_task(worker, pairs, wall, histories);
    ListKeeper keeper(*this, worker, pairs, wall != nullptr);
    task.keeper = &keeper;
    task.tally = worker.tally;
    kernel_.forces(task);
    worker.tally = task.tally;
    worker.deferred_count = task.deferred_count;
  };
  run(worker.pairs, nullptr);
  for (std::size_t w = 0; w < walls_.size(); ++w) run(worker.walls[w].pairs, &walls_[w]);
}

void Dem::Engine::fetch_deferred(Worker& worker) {
  const auto add = [](Quad& to, const Quad& from) { to = {to.x + from.x, to.y + from.y, to.z + from.z, 0}; };
  for (const Worker& other : workers_) {
    if (&other == &worker) continue;
    for (std::uint32_t k = 0; k < other.deferred_count; ++k) {
      const Deferred& deferred = other.deferred[k];
      const std::uint32_t sphere = deferred.sphere();
      if (sphere - worker.begin >= worker.end - worker.begin) continue;
      add(spheres_.force[sphere], deferred.force);
      if (turns_) add(spheres_.torque[sphere], deferred.torque);
      push(worker, sphere);
    }
  }
}

void Dem::Engine::take_tallies() {
  for (Worker& worker : workers_) {
    const Tally& tally = worker.tally;
    totals_.contact_starts += tally.starts;
    totals_.contact_time += tally.touches * setup_.step;
    totals_.wall_work += tally.wall_power * setup_.step;
    totals_.pairs_tested += worker.pairs.count();
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) totals_.contact_moment(a, b) += tally.moment[3 * a + b] * setup_.step;
    }
    worker.tally = {};
  }
}

void Dem::Engine::kick(std::uint32_t i, double share) {
  const double time = share * setup_.step;
  const auto add = [&](Quad& v, const Quad& force, const Eigen::Vector3d& body) {
    v = {v.x + time * (v.w * force.x + body.x()), v.y + time * (v.w * force.y + body.y()), v.z + time * (v.w * force.z + body.z()), v.w};
  };
  add(spheres_.velocity[i], spheres_.force[i], setup_.gravity);
  if (turns_) add(spheres_.spin[i], spheres_.torque[i], Eigen::Vector3d::Zero());
}

}  // namespace scalebreak

#include <scalebreak/ensembles/breakdown/run_study.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include <scalebreak/ensembles/engine/engine_names.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>
#include <scalebreak/ensembles/run/run_estimate.hpp>
#include <scalebreak/ensembles/run/run_flow.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/sphere_sizes.hpp>

namespace scalebreak {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double most_growth = 4;  ///< of the number of runs of a cell at once: an error from few runs is not well known

double seconds_of(const StudyCell& cell) {
  const RunEstimate estimate = estimate_run(cell.input, 1);
  return flies(cell.choice.engine) ? estimate.hybrid_seconds : estimate.seconds;
}

/// Tables are made by all threads, once, before runs ask for them side by side.
void make_tables(const StudyGrid& grid, const TableStore& store) {
  std::set<std::string> made;
  for (const StudyCell& cell : grid.cells) {
    if (!flies(cell.choice.engine)) continue;
    Input plain = cell.input;  // what tables depend on: the laws and materials, the sizes, whether there are walls
    plain.particles.count = 2, plain.particles.volume_fraction = 0.1, plain.particles.speed = 1, plain.cell.size.setZero();
    plain.run = {};
    if (!made.insert(write_input(plain)).second) continue;
    const double size = size_factor(*find_scaling_law(cell.law), cell.factor);
    const Particles& particles = cell.input.particles;
    SphereKinds kinds{.kinds = {{size * particles.radius, 0}}};
    if (particles.size == SizeKind::bidisperse) {
      kinds.kinds.push_back({size * particles.large_radius, 1});
    } else if (particles.size != SizeKind::mono) {
      const SizeRange range = size_range(particles, {cell.input.material.density, cell.input.second.density});
      kinds = {.kinds = {{size * range.least, 0}, {size * range.largest, 0}}, .many = true};
    }
    const Unanswered unanswered = cell.choice.engine == "event" ? Unanswered::integrate : Unanswered::leave;
    const TableRule rule(cell.input, kinds, store, {}, unanswered);
  }
}

/// The runs of a study, taken by threads one by one.
class Schedule {
 public:
  Schedule(const Input& input, const StudyGrid& grid, const StudyOptions& options)
      : input_(input), grid_(grid), options_(options), files_(options.out / "cells"), cells_(grid.cells.size()) {
    for (std::size_t i = 0; i < cells_.size(); ++i) cells_[i].wanted = input.run.replicas, cells_[i].seconds = seconds_of(grid.cells[i]);
  }

  void run() {
    std::vector<std::jthread> threads;
    for (int t = 0; t < std::max(1, options_.threads); ++t) threads.emplace_back([this] { work(); });
    threads.clear();
    if (failure_) std::rethrow_exception(failure_);
  }

  [[nodiscard]] bool stopped() const { return stopped_; }
  [[nodiscard]] CellResult result(std::size_t cell) const {
    std::vector<CellReplica> replicas;
    for (const auto& [number, replica] : cells_[cell].done) replicas.push_back(replica);
    return cell_result(cell, replicas);
  }

 private:
  struct Cell {
    std::map<std::uint64_t, CellReplica> done;
    std::uint64_t wanted = 0, begun = 0;
    double seconds = 0;  ///< expected of a run
  };

  void work() {
    std::unique_lock lock(mutex_);
    while (!failure_ && !stopped_) {
      const auto next = take();
      if (!next) {
        if (running_ == 0) break;
        changed_.wait(lock);
        continue;
      }
      ++running_;
      lock.unlock();
      std::optional<CellReplica> replica;
      std::exception_ptr failure;
      try {
        replica = obtain(next->first, next->second);
      } catch (const RunInterrupted&) {
        stopped_ = true;
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      --running_;
      if (failure && !failure_) failure_ = failure;
      if (replica) put(next->first, next->second, std::move(*replica));
      changed_.notify_all();
    }
    changed_.notify_all();
  }

  /// The next run: of the cell that has the fewest.
  std::optional<std::pair<std::size_t, std::uint64_t>> take() {
    Cell* least = nullptr;
    for (Cell& cell : cells_) {
      if (cell.begun < cell.wanted && (!least || cell.begun < least->begun)) least = &cell;
    }
    if (!least) return {};
    return std::pair{static_cast<std::size_t>(least - cells_.data()), least->begun++};
  }

  [[nodiscard]] CellReplica obtain(std::size_t cell, std::uint64_t replica) {
    const StudyCell& of = grid_.cells[cell];
    const bool keeps = !options_.out.empty();
    if (auto kept = keeps ? files_.read(of, replica) : std::nullopt) return *kept;
    CellReplica result = run_replica(of, replica, options_.tables, [this] { return stopped_ || (options_.stop && options_.stop()); });
    if (keeps) files_.write(of, replica, result);
    return result;
  }

  void put(std::size_t index, std::uint64_t number, CellReplica replica) {
    Cell& cell = cells_[index];
    cell.done.emplace(number, std::move(replica));
    if (cell.done.size() == cell.wanted) want_more(index, cell);
    if (!options_.progress) return;
    double done = 0, all = 0;
    for (const Cell& each : cells_)
      done += each.seconds * static_cast<double>(each.done.size()), all += each.seconds * static_cast<double>(each.wanted);
    options_.progress(std::min(1.0, done / all));
  }

  void want_more(std::size_t index, Cell& cell) {
    const double target = input_.study.target_error;
    const std::uint64_t most = std::max(input_.study.most_replicas, input_.run.replicas);
    if (target == 0 || cell.wanted >= most) return;
    const double spent = std::chrono::duration<double>(Clock::now() - began_).count();
    if (input_.study.budget_seconds > 0 && spent > input_.study.budget_seconds) return;
    const CellResult so_far = result(index);
    if (so_far.failed()) return;
    const double excess = relative_error(so_far) / target;
    if (excess <= 1) return;
    const double growth = std::min(excess * excess, most_growth);
    cell.wanted = std::min(most, static_cast<std::uint64_t>(std::ceil(growth * static_cast<double>(cell.wanted))));
  }

  const Input& input_;
  const StudyGrid& grid_;
  const StudyOptions& options_;
  CellFiles files_;
  std::vector<Cell> cells_;
  Clock::time_point began_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable changed_;
  int running_ = 0;
  std::atomic<bool> stopped_ = false;
  std::exception_ptr failure_;
};

}  // namespace

StudyResult run_study(const Input& input, StudyGrid grid, const StudyOptions& options) {
  StudyResult study{.grid = std::move(grid), .cells = {}};
  make_tables(study.grid, options.tables);
  Schedule schedule(input, study.grid, options);
  schedule.run();
  for (std::size_t i = 0; i < study.grid.cells.size(); ++i) study.cells.push_back(schedule.result(i));
  study.complete = !schedule.stopped();
  compare_with_originals(study);
  return study;
}

double expected_seconds(const StudyGrid& grid, const Input& input) {
  double seconds = 0;
  for (const StudyCell& cell : grid.cells) seconds += static_cast<double>(input.run.replicas) * seconds_of(cell);
  return seconds;
}

}  // namespace scalebreak

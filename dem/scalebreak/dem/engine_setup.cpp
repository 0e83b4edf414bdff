#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/engine.hpp>
#include <scalebreak/dem/walls.hpp>

namespace scalebreak {

using namespace dem;

namespace {

/// Up to so many kinds of spheres have their laws in one table.
constexpr std::size_t most_kinds = 16;

}  // namespace

Dem::Engine::Engine(const System& start, const DemSetup& setup)
    : kernel_(dem::kernel(setup.kernel)), setup_(setup), images_(start.cell, 0) {
  set_up(start);
  const std::vector<std::uint32_t> kind = sort_out_kinds(start);
  turns_ = rows_.mapped().laws.spins() || (!walls_.empty() && wall_rows_.mapped().laws.spins());
  spheres_ = Spheres(start, turns_, setup.integrator == Integrator::synchronized);
  spheres_.kind.assign(kind.begin(), kind.end());
  for (std::uint32_t i = 0; i < spheres_.count(); ++i) {
    const Quad &v = spheres_.velocity[i], &x = spheres_.position[i];
    const double along = v.x - flow_rate_ * (x.z - cell_.size.z() / 2);
    fastest_squared_ = std::max(fastest_squared_, along * along + v.y * v.y + v.z * v.z);
  }
  make_workers();
  make_grid(start.contacts);
  for (Worker& worker : workers_) find_neighbours(worker);
  for (Worker& worker : workers_) select_pairs(worker);
  for (Worker& worker : workers_) clear_marks(worker), collect_pushed(worker);
  for (const Worker& worker : workers_) mark_movers(worker);
  for (Worker& worker : workers_) collect_movers(worker);
  // The forces of the start, by which velocities are set half a step back; histories stay as they are.
  for (Worker& worker : workers_) find_contacts(worker);
  for (Worker& worker : workers_) adopt_met(worker);
  for (Worker& worker : workers_) add_forces(worker, {0, history_steps().after});
  rethrow();
  for (Worker& worker : workers_) fetch_deferred(worker);
  for (std::uint32_t i = 0; i < spheres_.count(); ++i) kick(i, -0.5);
  if (height_.follows()) {
    for (Worker& worker : workers_) sum_normal_flux(worker);
    push_height();
  }
  for (Worker& worker : workers_) worker.tally.touches = worker.tally.wall_power = 0;
  take_tallies();
}

void Dem::Engine::set_up(const System& start) {
  if (start.count() == 0) throw InputError("there are no spheres");
  if (!(setup_.step > 0) || !std::isfinite(setup_.step)) throw InputError(fmt::format("the step is {} s; allowed: above 0", setup_.step));
  if (setup_.threads < 1) throw InputError(fmt::format("found {} threads; allowed: 1 or more", setup_.threads));
  cell_ = start.cell;
  start_time_ = start.time;
  material_ = start.material;
  double solid = 0;
  smallest_ = std::numeric_limits<double>::infinity();
  for (const double radius : start.radius) {
    smallest_ = std::min(smallest_, radius);
    largest_ = std::max(largest_, radius);
    solid += 4.0 / 3 * std::numbers::pi * radius * radius * radius;
  }
  volume_fraction_ = solid / cell_.volume();
  set_up_height(start);
  if (!cell_.walled(0)) flow_rate_ = cell_.shear_rate != 0 ? cell_.shear_rate : cell_.walled(2) ? 2 * cell_.wall_speed / cell_.size.z() : 0;
}

std::vector<std::uint32_t> Dem::Engine::sort_out_kinds(const System& start) {
  std::vector<std::uint32_t> kinds(start.count(), 0);
  for (std::size_t i = 0; i < start.count() && !each_; ++i) {
    const LawRows::Kind kind{start.radius[i], start.material[i]};
    const auto at = std::find(kinds_.begin(), kinds_.end(), kind);
    kinds[i] = static_cast<std::uint32_t>(at - kinds_.begin());
    if (at == kinds_.end()) kinds_.push_back(kind);
    each_ = kinds_.size() > most_kinds;
  }
  if (each_) {
    // The extremes stand for all: their forms are compared, and the largest reach is theirs.
    kinds_.clear();
    for (const std::uint8_t material : {std::uint8_t{0}, std::uint8_t{1}}) {
      if (std::find(material_.begin(), material_.end(), material) == material_.end()) continue;
      kinds_.push_back({smallest_, material});
      kinds_.push_back({largest_, material});
    }
    std::fill(kinds.begin(), kinds.end(), 0u);
  }
  make_rows();
  const double least = 2 * largest_ + rows_.largest_reach();
  for (const int axis : {0, 1, 2}) {
    if (cell_.periodic(axis) && !(cell_.size[axis] > 2 * least))
      throw InputError(
          fmt::format("the cell is {:g} m long along its periodic axis {}; allowed: above {:g} m, twice the reach of the largest "
                      "spheres, so that no sphere meets two images of another",
                      cell_.size[axis], "xyz"[axis], 2 * least));
  }
  return kinds;
}

void Dem::Engine::make_rows() {
  rows_ = LawRows(setup_, kinds_, false, each_);
  walls_ = walls_of(cell_, setup_.wall_no_slip);
  if (!walls_.empty()) wall_rows_ = LawRows(setup_, kinds_, true, each_);
}

void Dem::Engine::make_workers() {
  workers_.resize(static_cast<std::size_t>(setup_.threads));
  for (Worker& worker : workers_) {
    worker.walls.resize(walls_.size());
    if (rows_.each()) worker.rows = rows_, worker.wall_rows = wall_rows_;
  }
  moves_.resize(spheres_.count());
  pushed_.resize(spheres_.count());
}

LawRows& Dem::Engine::rows_for(Worker& worker, bool wall) {
  if (rows_.each()) return wall ? worker.wall_rows : worker.rows;
  return wall ? wall_rows_ : rows_;
}

double Dem::Engine::largest_reach() const { return std::max(rows_.largest_reach(), walls_.empty() ? 0.0 : wall_rows_.largest_reach()); }

}  // namespace scalebreak

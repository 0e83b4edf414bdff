#include <algorithm>
#include <atomic>
#include <cmath>

#include <scalebreak/dem/engine.hpp>

// How the engine finds which pairs can touch: neighbours from a grid, now and then, and of these the near pairs, more often.

namespace scalebreak {

using namespace dem;

namespace {

double peculiar_squared(const Quad& velocity, const Quad& position, double rate, double middle) {
  const double along = velocity.x - rate * (position.z - middle);
  return along * along + velocity.y * velocity.y + velocity.z * velocity.z;
}

}  // namespace

void Dem::Engine::wrap_spheres() {
  const Cell cell = cell_now();
  for (std::uint32_t i = 0; i < spheres_.count(); ++i) {
    Quad &x = spheres_.position[i], &v = spheres_.velocity[i];
    Eigen::Vector3d position(x.x, x.y, x.z), velocity(v.x, v.y, v.z);
    wrap(cell, position, velocity);
    x = {position.x(), position.y(), position.z(), x.w};
    if (!spheres_.seen_velocity.empty()) spheres_.seen_velocity[i].x += velocity.x() - v.x;
    v = {velocity.x(), velocity.y(), velocity.z(), v.w};
  }
}

void Dem::Engine::make_grid(const std::vector<ContactMemory>& contacts) {
  wrap_spheres();
  const Cell cell = cell_now();
  grid_offset_ = central_offset(cell);
  steps_at_grid_ = steps_;
  images_ = Images(cell, grid_offset_);
  skins_ = best_skins(2 * smallest_, volume_fraction_, travel_of(fastest_squared_));
  // In a narrow cell a pair's image must stay the one that it was found in.
  for (const int axis : {0, 1, 2}) {
    if (!cell.periodic(axis)) continue;
    const double room = cell.size[axis] - 2 * (2 * largest_ + largest_reach());
    skins_.neighbours = std::min(skins_.neighbours, room / 2);
  }
  skins_.near = std::min(skins_.near, skins_.neighbours);
  grid_.emplace(cell, spheres_.position, largest_reach() + skins_.neighbours);
  spheres_.sort(grid_->order());
  grid_->renumber();
  const std::size_t count = spheres_.count(), threads = workers_.size();
  for (std::size_t t = 0; t < threads; ++t) {
    workers_[t].begin = static_cast<std::uint32_t>(count * t / threads);
    workers_[t].end = static_cast<std::uint32_t>(count * (t + 1) / threads);
  }
  hand_out(contacts);
  travel_of_grid_ = 0;
  totals_.grids_made += 1;
}

void Dem::Engine::hand_out(const std::vector<ContactMemory>& contacts) {
  std::vector<std::uint32_t> place(spheres_.count());
  for (std::uint32_t k = 0; k < place.size(); ++k) place[spheres_.id[k]] = k;
  for (Worker& worker : workers_) {
    worker.remembered.clear();
    for (WallPairs& wall : worker.walls) wall.remembered.clear();
  }
  const auto owner = [&](std::uint32_t sphere) -> Worker& {
    return *std::find_if(workers_.begin(), workers_.end(), [&](const Worker& worker) { return sphere < worker.end; });
  };
  for (const ContactMemory& memory : contacts) {
    Remembered contact{.first = place[static_cast<std::size_t>(memory.first)],
                       .state = memory.touching ? touching : bridged,
                       .begun = memory.begun,
                       .slide = {memory.sliding.x(), memory.sliding.y(), memory.sliding.z(), 0},
                       .roll = {memory.rolling.x(), memory.rolling.y(), memory.rolling.z(), 0}};
    if (memory.second < 0) {
      Worker& worker = owner(contact.first);
      for (std::size_t w = 0; w < walls_.size(); ++w) {
        if (wall_number(walls_[w].axis, walls_[w].side > 0) == memory.second) worker.walls[w].remembered.push_back(contact);
      }
      continue;
    }
    contact.second = place[static_cast<std::size_t>(memory.second)];
    if (!grid_->keeps(contact.first, contact.second)) {
      std::swap(contact.first, contact.second);  // what the first does past the second turns round
      contact.slide = {-contact.slide.x, -contact.slide.y, -contact.slide.z, 0};
    }
    owner(contact.first).remembered.push_back(contact);
  }
  const auto sort = [](std::vector<Remembered>& list) {
    std::sort(list.begin(), list.end(),
              [](const Remembered& a, const Remembered& b) { return std::pair(a.first, a.second) < std::pair(b.first, b.second); });
  };
  for (Worker& worker : workers_) {
    sort(worker.remembered);
    for (WallPairs& wall : worker.walls) sort(wall.remembered);
  }
}

void Dem::Engine::find_neighbours(Worker& worker) {
  worker.start.resize(worker.end - worker.begin + 1);
  worker.neighbours.clear();
  for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
    worker.start[i - worker.begin] = static_cast<std::uint32_t>(worker.neighbours.size());
    grid_->neighbours_of(i, spheres_.position, images_.shift.data(), worker.neighbours);
  }
  worker.start.back() = static_cast<std::uint32_t>(worker.neighbours.size());
}

void Dem::Engine::select_pairs(Worker& worker) {
  Pairs& pairs = worker.pairs;
  if (!grid_due_ && steps_since_lists_ > 0) worker.remembered = pairs.remember();
  pairs.reserve(worker.neighbours.size() + 1);
  SelectTask task{.spheres = spheres_.view(),
                  .start = worker.start.data() - worker.begin,
                  .neighbour = worker.neighbours.data(),
                  .shift = images_.shift.data(),
                  .begin = worker.begin,
                  .end = worker.end,
                  .margin = largest_reach() + skins_.near,
                  .first = pairs.first.data(),
                  .second = pairs.second.data()};
  kernel_.select(task);
  pairs.reset(task.count, has_slides(), has_rolls());
  LawRows& rows = rows_for(worker, false);
  for (std::uint32_t k = 0; k < pairs.count; ++k) {
    const std::uint32_t i = pairs.first[k], j = sphere_of(pairs.second[k]);
    const double touch = spheres_.position[i].w + spheres_.position[j].w;
    pairs.reach_squared[k] = touch * touch;
    pairs.row[k] = rows.each() ? 0 : rows.row_of(spheres_.kind[i], spheres_.kind[j]);
  }
  if (rows.each()) rows.close_all(), rows.reserve(pairs.count);
  pairs.recall(worker.remembered, false, [&](std::uint32_t k) {
    const std::uint32_t i = pairs.first[k], j = sphere_of(pairs.second[k]);
    if (rows.each()) pairs.row[k] = rows.open(kind_at(i), kind_at(j));
    const double bridge = rows.bridge() ? rows.bridge()[pairs.row[k]] : 0.0;
    const double reach = std::sqrt(pairs.reach_squared[k]) + std::max(bridge, rows.hold()[pairs.row[k]]);
    pairs.reach_squared[k] = reach * reach;
  });
  worker.deferred.resize(std::max<std::size_t>(worker.deferred.size(), pairs.count + 1));
  select_walls(worker);
}

void Dem::Engine::select_walls(Worker& worker) {
  std::size_t near_walls = 0;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    Pairs& pairs = worker.walls[w].pairs;
    if (!grid_due_ && steps_since_lists_ > 0) worker.walls[w].remembered = pairs.remember();
    pairs.reserve(worker.end - worker.begin + 1);
    std::uint32_t count = 0;
    for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
      const Quad& x = spheres_.position[i];
      const double gap = walls_[w].side * (walls_[w].place - (&x.x)[walls_[w].axis]) - x.w;
      if (gap < largest_reach() + skins_.near) pairs.first[count] = i, pairs.second[count++] = 0;
    }
    pairs.reset(count, has_slides(), has_rolls());
    near_walls += count;
  }
  if (walls_.empty()) return;
  LawRows& rows = rows_for(worker, true);
  if (rows.each()) rows.close_all(), rows.reserve(near_walls);
  for (WallPairs& wall : worker.walls) {
    Pairs& pairs = wall.pairs;
    for (std::uint32_t k = 0; k < pairs.count; ++k) {
      const std::uint32_t i = pairs.first[k];
      pairs.reach_squared[k] = spheres_.position[i].w * spheres_.position[i].w;
      pairs.row[k] = rows.each() ? 0 : rows.row_of(spheres_.kind[i], 0);
    }
    pairs.recall(wall.remembered, true, [&](std::uint32_t k) {
      const std::uint32_t i = pairs.first[k];
      if (rows.each()) pairs.row[k] = rows.open(kind_at(i), kind_at(i));
      const double bridge = rows.bridge() ? rows.bridge()[pairs.row[k]] : 0.0;
      const double reach = spheres_.position[i].w + std::max(bridge, rows.hold()[pairs.row[k]]);
      pairs.reach_squared[k] = reach * reach;
    });
  }
}

void Dem::Engine::reopen_rows(Worker& worker) {
  if (!each_) return;
  const auto reopen = [&](Pairs& pairs, LawRows& rows, bool wall) {
    for (std::uint32_t k = 0; k < pairs.count; ++k) {
      const std::uint32_t i = pairs.first[k], j = wall ? i : sphere_of(pairs.second[k]);
      if (pairs.state[k] != apart) pairs.row[k] = rows.open(kind_at(i), kind_at(j));
    }
  };
  reopen(worker.pairs, worker.rows, false);
  for (WallPairs& wall : worker.walls) reopen(wall.pairs, worker.wall_rows, true);
}

// Spheres that are near none fly on their own until the lists are made anew. Who is near whom is told across threads: all have to
// clear before any marks, and to mark before any collects.

void Dem::Engine::clear_marks(Worker& worker) { std::fill(moves_.begin() + worker.begin, moves_.begin() + worker.end, std::uint8_t{0}); }

void Dem::Engine::mark_movers(const Worker& worker) {
  const auto mark = [&](std::uint32_t sphere) { std::atomic_ref(moves_[sphere]).store(1, std::memory_order_relaxed); };
  for (std::uint32_t k = 0; k < worker.pairs.count; ++k) mark(worker.pairs.first[k]), mark(sphere_of(worker.pairs.second[k]));
  for (const WallPairs& wall : worker.walls) {
    for (std::uint32_t k = 0; k < wall.pairs.count; ++k) mark(wall.pairs.first[k]);
  }
}

void Dem::Engine::collect_movers(Worker& worker) {
  worker.movers.clear();
  double fastest = 0;
  for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
    if (moves_[i]) {
      worker.movers.push_back(i);
    } else {
      fastest = std::max(fastest, peculiar_squared(spheres_.velocity[i], spheres_.position[i], flow_rate_, cell_.size.z() / 2));
    }
  }
  worker.resting_fastest_squared = fastest;
}

void Dem::Engine::fly(Quad& x, Quad& v) const {
  const double steps = static_cast<double>(steps_since_lists_), time = steps * setup_.step,
               fall = setup_.step * setup_.step * steps * (steps + 1) / 2;
  const Eigen::Vector3d& g = setup_.gravity;
  x = {x.x + time * v.x + fall * g.x(), x.y + time * v.y + fall * g.y(), x.z + time * v.z + fall * g.z(), x.w};
  v = {v.x + time * g.x(), v.y + time * g.y(), v.z + time * g.z(), v.w};
}

void Dem::Engine::bring_up_resting(Worker& worker) {
  if (worker.movers.size() == worker.end - worker.begin) return;
  const Eigen::Vector3d& g = setup_.gravity;
  for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
    if (moves_[i]) continue;
    Quad &x = spheres_.position[i], &v = spheres_.velocity[i];
    fly(x, v);
    if (spheres_.seen_velocity.empty()) continue;
    const double half = setup_.step / 2;
    spheres_.seen_velocity[i] = {v.x + half * g.x(), v.y + half * g.y(), v.z + half * g.z(), v.w};
    if (turns_) spheres_.seen_spin[i] = spheres_.spin[i];
  }
}

}  // namespace scalebreak

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
    Contact contact{.first = place[static_cast<std::size_t>(memory.first)],
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
    std::uint32_t second = place[static_cast<std::size_t>(memory.second)];
    if (!grid_->keeps(contact.first, second)) {
      std::swap(contact.first, second);  // what the first does past the second turns round
      contact.slide = {-contact.slide.x, -contact.slide.y, -contact.slide.z, 0};
    }
    contact.second = packed(second, no_image);  // until the near pairs tell
    owner(contact.first).remembered.push_back(contact);
  }
  const auto sort = [](std::vector<Contact>& list) {
    std::sort(list.begin(), list.end(),
              [](const Contact& a, const Contact& b) { return std::pair(a.first, a.second) < std::pair(b.first, b.second); });
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

void Dem::Engine::take_contacts(Worker& worker, Pairs& pairs, std::vector<Contact>& remembered, bool wall) {
  LawRows& rows = rows_for(worker, wall);
  if (grid_due_ || steps_since_lists_ == 0) {
    pairs.contacts.slides = has_slides(), pairs.contacts.rolls = has_rolls();
    pairs.contacts.clear();
    for (Contact& contact : remembered) {
      const std::uint32_t i = contact.first, j = wall ? i : sphere_of(contact.second);
      contact.row = rows.each() ? rows.open(kind_at(i), kind_at(j)) : rows.row_of(spheres_.kind[i], wall ? 0 : spheres_.kind[j]);
      pairs.contacts.add(contact);
    }
    std::vector<Contact>().swap(remembered);
    pairs.contacts.sorted = pairs.contacts.count;
  } else {
    pairs.contacts.tidy();
  }
  pairs.part_contacts_from_near(wall);
}

void Dem::Engine::select_pairs(Worker& worker) {
  Pairs& pairs = worker.pairs;
  pairs.reserve(worker.neighbours.size() + 1);
  SelectTask task{.spheres = spheres_.view(),
                  .start = worker.start.data() - worker.begin,
                  .neighbour = worker.neighbours.data(),
                  .shift = images_.shift.data(),
                  .begin = worker.begin,
                  .end = worker.end,
                  .margin = largest_reach() + skins_.near,
                  .first = pairs.near_first.data(),
                  .second = pairs.near_second.data()};
  kernel_.select(task);
  pairs.near_count = task.count;
  if (rows_.each() && grid_due_) worker.rows.close_all(), worker.wall_rows.close_all();
  take_contacts(worker, pairs, worker.remembered, false);
  for (std::size_t w = 0; w < walls_.size(); ++w) select_wall(worker, w);
}

void Dem::Engine::select_wall(Worker& worker, std::size_t w) {
  Pairs& pairs = worker.walls[w].pairs;
  pairs.reserve(worker.end - worker.begin + 1);
  pairs.near_count = 0;
  for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
    const Quad& x = spheres_.position[i];
    const double gap = walls_[w].side * (walls_[w].place - (&x.x)[walls_[w].axis]) - x.w;
    if (gap >= largest_reach() + skins_.near) continue;
    pairs.near_first[pairs.near_count] = i;
    pairs.near_second[pairs.near_count++] = packed(0, no_image);
  }
  take_contacts(worker, pairs, worker.walls[w].remembered, true);
}

void Dem::Engine::reopen_rows(Worker& worker) {
  if (!each_) return;
  // Those that are apart too: the kernel reads the row of every lane, also of one that does not act.
  const auto reopen = [&](Contacts& contacts, LawRows& rows, bool wall) {
    for (std::uint32_t k = 0; k < contacts.count; ++k) {
      const std::uint32_t i = contacts.first[k], j = wall ? i : sphere_of(contacts.second[k]);
      contacts.row[k] = rows.open(kind_at(i), kind_at(j));
    }
  };
  reopen(worker.pairs.contacts, worker.rows, false);
  for (WallPairs& wall : worker.walls) reopen(wall.pairs.contacts, worker.wall_rows, true);
}

// Spheres that are near none fly on their own until the lists are made anew. Who is near whom is told across threads: all have to
// clear before any marks, and to mark before any collects.

void Dem::Engine::clear_marks(Worker& worker) {
  const std::uint8_t mark = height_.follows() ? 1 : 0;  // then all of them go with the height at every step
  std::fill(moves_.begin() + worker.begin, moves_.begin() + worker.end, mark);
}

void Dem::Engine::mark_movers(const Worker& worker) {
  const auto mark = [&](std::uint32_t sphere) { std::atomic_ref(moves_[sphere]).store(1, std::memory_order_relaxed); };
  const Pairs& pairs = worker.pairs;
  for (std::uint32_t k = 0; k < pairs.near_count; ++k) mark(pairs.near_first[k]), mark(sphere_of(pairs.near_second[k]));
  for (std::uint32_t k = 0; k < pairs.contacts.count; ++k) mark(pairs.contacts.first[k]), mark(sphere_of(pairs.contacts.second[k]));
  for (const WallPairs& wall : worker.walls) {
    for (std::uint32_t k = 0; k < wall.pairs.near_count; ++k) mark(wall.pairs.near_first[k]);
    for (std::uint32_t k = 0; k < wall.pairs.contacts.count; ++k) mark(wall.pairs.contacts.first[k]);
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

bool Dem::Engine::push(Worker& worker, std::uint32_t sphere) {
  if (sphere - worker.begin >= worker.end - worker.begin || pushed_[sphere]) return false;
  pushed_[sphere] = 1;
  worker.pushed.push_back(sphere);
  return true;
}

void Dem::Engine::meet(Worker& worker, std::uint32_t sphere) {
  if (!push(worker, sphere) || spheres_.seen_velocity.empty()) return;
  const Quad& v = spheres_.velocity[sphere];
  const Eigen::Vector3d gain = (steps_ == 0 ? 0.0 : setup_.step / 2) * setup_.gravity;  // velocities of the start are not behind
  spheres_.seen_velocity[sphere] = {v.x + gain.x(), v.y + gain.y(), v.z + gain.z(), v.w};
  if (turns_) spheres_.seen_spin[sphere] = spheres_.spin[sphere];
}

void Dem::Engine::collect_pushed(Worker& worker) {
  std::fill(pushed_.begin() + worker.begin, pushed_.begin() + worker.end, std::uint8_t{0});
  worker.pushed.clear();
  for (const Worker& other : workers_) {
    const Contacts& contacts = other.pairs.contacts;
    if (&other == &worker) {
      for (std::uint32_t k = 0; k < contacts.count; ++k) push(worker, contacts.first[k]);
    }
    for (std::uint32_t k = 0; k < contacts.count; ++k) push(worker, sphere_of(contacts.second[k]));
  }
  for (const WallPairs& wall : worker.walls) {
    for (std::uint32_t k = 0; k < wall.pairs.contacts.count; ++k) push(worker, wall.pairs.contacts.first[k]);
  }
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
  for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
    if (!moves_[i]) fly(spheres_.position[i], spheres_.velocity[i]);
  }
}

}  // namespace scalebreak

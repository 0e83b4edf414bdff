#include <algorithm>
#include <cmath>
#include <cstring>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/engine.hpp>
#include <scalebreak/dem/list_keeper.hpp>
#include <scalebreak/dem/spring_energy.hpp>

// What the engine shows of its state, and how it keeps it.

namespace scalebreak {

using namespace dem;

namespace {

Eigen::Vector3d vector(const Quad& quad) { return {quad.x, quad.y, quad.z}; }

}  // namespace

System Dem::Engine::system() const {
  const std::size_t n = spheres_.count();
  System system{.time = time(), .cell = cell_now()};
  system.radius.resize(n), system.mass.resize(n), system.material = material_;
  system.position.resize(n), system.velocity.resize(n), system.spin.assign(n, Eigen::Vector3d::Zero());
  const double half = setup_.step / 2;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t i = spheres_.id[k];
    Quad x = spheres_.position[k], v = spheres_.velocity[k];
    if (!moves_[k]) fly(x, v);  // those near none are where they were when the lists were made
    system.radius[i] = x.w;
    system.mass[i] = 1 / v.w;
    system.position[i] = vector(x);
    system.velocity[i] = vector(v);
    system.velocity[i] += half * (v.w * vector(spheres_.force[k]) + setup_.gravity);
    if (turns_) system.spin[i] = vector(spheres_.spin[k]) + half * spheres_.spin[k].w * vector(spheres_.torque[k]);
    wrap(system.cell, system.position[i], system.velocity[i]);
  }
  system.contacts = histories_are_ahead() ? with_histories_of_now().contact_memories() : contact_memories();
  return system;
}

std::vector<ContactMemory> Dem::Engine::contact_memories() const {
  std::vector<ContactMemory> memories;
  const auto put = [&](const Contacts& contacts, const WallView* wall) {
    for (std::uint32_t k = 0; k < contacts.count; ++k) {
      if (contacts.state[k] == apart) continue;
      const Contact contact = contacts.get(k);
      memories.push_back({.first = static_cast<std::int32_t>(spheres_.id[contact.first]),
                          .second = second_of(contact, wall),
                          .touching = contact.state == touching,
                          .begun = contact.begun,
                          .sliding = vector(contact.slide),
                          .rolling = vector(contact.roll)});
    }
  };
  for (const Worker& worker : workers_) {
    put(worker.pairs.contacts, nullptr);
    for (std::size_t w = 0; w < walls_.size(); ++w) put(worker.walls[w].pairs.contacts, &walls_[w]);
  }
  return memories;
}

std::int32_t Dem::Engine::second_of(const Contact& contact, const WallView* wall) const {
  return wall ? wall_number(wall->axis, wall->side > 0) : static_cast<std::int32_t>(spheres_.id[sphere_of(contact.second)]);
}

std::vector<ContactForce> Dem::Engine::contact_forces() const {
  // The forces once more, on copies, told of one by one.
  Engine copy(*this);
  std::vector<ContactForce> forces;
  const auto visit = [&](Worker& worker, Pairs& pairs, const WallView* wall) {
    const Contacts& contacts = pairs.contacts;
    std::vector<Quad> force(contacts.count), branch(contacts.count);
    ForceTask task = copy.force_task(worker, pairs, wall, history_steps_again());
    ListKeeper keeper(copy, worker, pairs, wall != nullptr);
    task.keeper = &keeper;
    task.contact_force = force.data(), task.contact_branch = branch.data();
    copy.kernel_.forces(task);
    worker.deferred_count = task.deferred_count;
    for (std::uint32_t k = 0; k < contacts.count; ++k) {
      if (contacts.state[k] == apart) continue;
      forces.push_back({.first = static_cast<std::int32_t>(spheres_.id[contacts.first[k]]),
                        .second = second_of(contacts.get(k), wall),
                        .touching = contacts.state[k] == touching,
                        .branch = vector(branch[k]),
                        .force = -vector(force[k])});
    }
  };
  for (Worker& worker : copy.workers_) {
    worker.deferred_count = 0;
    visit(worker, worker.pairs, nullptr);
    for (std::size_t w = 0; w < walls_.size(); ++w) visit(worker, worker.walls[w].pairs, &walls_[w]);
  }
  return forces;
}

Dem::Engine Dem::Engine::with_histories_of_now() const {
  Engine copy(*this);
  for (Worker& worker : copy.workers_) copy.add_forces(worker, {history_steps_again().before, 0});
  return copy;
}

double Dem::Engine::elastic_energy() const {
  return histories_are_ahead() ? with_histories_of_now().energy_of_springs() : energy_of_springs();
}

double Dem::Engine::energy_of_springs() const {
  double energy = 0;
  const auto add = [&](const Contacts& contacts, const LawRows& rows, const WallView* wall) {
    energy += spring_energy(contacts, rows, [&](std::uint32_t k) {
      const Quad& here = spheres_.position[contacts.first[k]];
      if (wall) return wall->side * (wall->place - (&here.x)[wall->axis]) - here.w;
      const Quad &there = spheres_.position[sphere_of(contacts.second[k])], &shift = images_.shift[image_of(contacts.second[k])];
      return (vector(there) + vector(shift) - vector(here)).norm() - here.w - there.w;
    });
  };
  for (const Worker& worker : workers_) {
    add(worker.pairs.contacts, rows_.each() ? worker.rows : rows_, nullptr);
    for (std::size_t w = 0; w < walls_.size(); ++w)
      add(worker.walls[w].pairs.contacts, rows_.each() ? worker.wall_rows : wall_rows_, &walls_[w]);
  }
  return energy;
}

std::size_t Dem::Engine::bytes() const {
  std::size_t bytes = spheres_.bytes() + moves_.capacity() + pushed_.capacity() + material_.capacity();
  for (const Worker& worker : workers_) {
    bytes += (worker.start.capacity() + worker.neighbours.capacity() + worker.movers.capacity() + worker.pushed.capacity()) *
             sizeof(std::uint32_t);
    bytes += worker.pairs.bytes() + worker.deferred.capacity() * sizeof(Deferred);
    for (const WallPairs& wall : worker.walls) bytes += wall.pairs.bytes();
  }
  return bytes;
}

}  // namespace scalebreak

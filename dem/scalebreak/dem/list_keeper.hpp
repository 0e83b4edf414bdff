#pragma once

#include <scalebreak/dem/engine.hpp>

namespace scalebreak {

/// Begins and ends the contacts of one list.
class Dem::Engine::ListKeeper final : public dem::ContactKeeper {
 public:
  ListKeeper(Engine& engine, Worker& worker, dem::Pairs& pairs, bool wall) : engine_(engine), worker_(worker), pairs_(pairs), wall_(wall) {}

  void meet(dem::ForceTask& task, std::uint32_t first, std::uint32_t second) override {
    const std::uint32_t row = open(first, second);
    pairs_.contacts.add({.first = first, .second = second, .row = row, .begun = engine_.time()});
    engine_.meet(worker_, first);
    if (!wall_) {
      const std::uint32_t other = dem::sphere_of(second);
      other - worker_.begin < worker_.end - worker_.begin ? engine_.meet(worker_, other) : worker_.met.push_back(other);
    }
    show(task);
    task.tally.starts += share();
  }
  void meet_again(dem::ForceTask& task, std::uint32_t k) override {
    const std::uint32_t first = pairs_.contacts.first[k], second = pairs_.contacts.second[k];
    pairs_.contacts.put(k, {.first = first, .second = second, .row = open(first, second), .begun = engine_.time()});
    show(task);
    task.tally.starts += share();
  }
  void part(dem::ForceTask&, std::uint32_t k) override {
    pairs_.contacts.state[k] = dem::apart;
    dem::LawRows& rows = engine_.rows_for(worker_, wall_);
    if (rows.each()) rows.close(pairs_.contacts.row[k]);
  }
  void make_room(dem::ForceTask& task) override {
    worker_.deferred.resize(2 * worker_.deferred.size() + 64);
    task.deferred = worker_.deferred.data(), task.deferred_room = static_cast<std::uint32_t>(worker_.deferred.size());
  }

 private:
  [[nodiscard]] double share() const { return wall_ ? 0.5 : 1.0; }
  [[nodiscard]] std::uint32_t open(std::uint32_t i, std::uint32_t second) {
    const std::uint32_t j = wall_ ? i : dem::sphere_of(second);
    dem::LawRows& rows = engine_.rows_for(worker_, wall_);
    if (rows.each()) return rows.open(engine_.kind_at(i), engine_.kind_at(j));
    return rows.row_of(engine_.spheres_.kind[i], wall_ ? 0 : engine_.spheres_.kind[j]);
  }
  void show(dem::ForceTask& task) {
    const dem::LawRows& rows = engine_.rows_for(worker_, wall_);
    task.contacts = pairs_.contacts.view();
    task.rows = rows.rows(), task.hold = rows.hold(), task.bridge = rows.bridge();
  }

  Engine& engine_;
  Worker& worker_;
  dem::Pairs& pairs_;
  bool wall_;
};

}  // namespace scalebreak

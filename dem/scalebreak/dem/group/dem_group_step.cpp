#include <algorithm>
#include <cmath>

#include <scalebreak/dem/group/dem_group.hpp>

namespace scalebreak {

using namespace dem;

/// Begins and ends the contacts of one list.
class DemGroup::Keeper final : public ContactKeeper {
 public:
  Keeper(DemGroup& group, Pairs& pairs, bool wall) : group_(group), pairs_(pairs), wall_(wall) {}

  void meet(ForceTask& task, std::uint32_t first, std::uint32_t second) override {
    pairs_.contacts.add({.first = first, .second = second, .row = row(first, second), .begun = group_.time_});
    show(task);
    task.tally.starts += wall_ ? 0.5 : 1.0;
  }
  void meet_again(ForceTask& task, std::uint32_t k) override {
    const std::uint32_t first = pairs_.contacts.first[k], second = pairs_.contacts.second[k];
    pairs_.contacts.put(k, {.first = first, .second = second, .row = row(first, second), .begun = group_.time_});
    show(task);
    task.tally.starts += wall_ ? 0.5 : 1.0;
  }
  void part(ForceTask&, std::uint32_t k) override {
    pairs_.contacts.state[k] = apart;
    if (!group_.own_rows_.empty()) group_.own_rows_[wall_ ? 1 : 0].close(pairs_.contacts.row[k]);
  }
  void make_room(ForceTask&) override {}  // nothing is deferred: all spheres are this thread's

 private:
  [[nodiscard]] std::uint32_t row(std::uint32_t first, std::uint32_t second) {
    return group_.open_row(wall_, first, wall_ ? 0 : sphere_of(second));
  }
  void show(ForceTask& task) {
    task.contacts = pairs_.contacts.view();
    group_.show_rows(task, wall_);
  }

  DemGroup& group_;
  Pairs& pairs_;
  bool wall_;
};

void DemGroup::find_near(double margin) {
  each_list([&](Pairs& pairs, const WallView* wall) {
    Contacts& contacts = pairs.contacts;
    contacts.slides = laws_->slides_, contacts.rolls = laws_->rolls_;
    contacts.tidy();
    std::vector<std::uint64_t> known;
    const auto key = [](std::uint64_t a, std::uint64_t b) { return std::min(a, b) << 32 | std::max(a, b); };
    for (std::uint32_t k = 0; k < contacts.count; ++k)
      known.push_back(key(contacts.first[k], wall ? contacts.first[k] : sphere_of(contacts.second[k])));
    std::sort(known.begin(), known.end());
    const auto is_contact = [&](std::uint32_t i, std::uint32_t j) { return std::binary_search(known.begin(), known.end(), key(i, j)); };
    pairs.near_count = 0;
    const auto put = [&](std::uint32_t i, std::uint32_t second) {
      if (pairs.near_count == pairs.near_first.size()) pairs.reserve(2 * pairs.near_count + 8);
      pairs.near_first[pairs.near_count] = i, pairs.near_second[pairs.near_count++] = second;
    };
    for (std::uint32_t i = 0; i < count(); ++i) {
      const Quad& here = spheres_.position[i];
      if (wall) {
        if (wall->side * (wall->place - (&here.x)[wall->axis]) - here.w < margin && !is_contact(i, i)) put(i, no_image);
        continue;
      }
      for (std::uint32_t j = i + 1; j < count(); ++j) {
        const Quad& there = spheres_.position[j];
        const double reach = here.w + there.w + margin;
        if ((vector(there) - vector(here)).squaredNorm() < reach * reach && !is_contact(i, j)) put(i, packed(j, no_image));
      }
    }
  });
}

ForceTask DemGroup::task(Pairs& pairs, const WallView* wall) {
  const LawRows& rows = this->rows(wall != nullptr);
  const MappedLaws& mapped = rows.mapped();
  SpheresView spheres = spheres_.view();
  if (!laws_->turns()) spheres.spin = nullptr;
  return {.spheres = spheres,
          .near = pairs.near(),
          .contacts = pairs.contacts.view(),
          .rows = rows.rows(),
          .one_row = rows.one(),
          .hold = rows.hold(),
          .bridge = rows.bridge(),
          .shift = laws_->images_.shift.data(),
          .shift_velocity = laws_->images_.velocity.data(),
          .wall = wall,
          .length = mapped.length,
          .spin = mapped.spin,
          .force = mapped.force,
          .torque = mapped.torque,
          .radius_share = rows.radius_share(),
          .turns = laws_->turns(),
          .sums_moment = true,
          .own_begin = 0,
          .own_end = count()};
}

void DemGroup::show_rows(ForceTask& task, bool wall) const {
  const LawRows& rows = this->rows(wall);
  task.rows = rows.rows(), task.hold = rows.hold(), task.bridge = rows.bridge();
}

/// One list at work, through all steps of a stretch.
struct DemGroup::Work {
  Pairs& pairs;
  Keeper keeper;
  ForceTask task;
};

void DemGroup::find_contacts(Work& work) {
  if (work.pairs.near_count == 0) return;
  show_rows(work.task, work.task.wall != nullptr);
  work.task.tally.starts = 0;
  laws_->kernel_->find_contacts(work.task);
  totals_.contact_starts += work.task.tally.starts;
}

void DemGroup::add_forces(Work& work, double before, double after, double step) {
  if (work.pairs.contacts.count == 0) return;
  show_rows(work.task, work.task.wall != nullptr);
  work.task.tally = {};
  work.task.history_step = before, work.task.history_after = after;
  laws_->kernel_->forces(work.task);
  const Tally& tally = work.task.tally;
  totals_.contact_starts += tally.starts;
  totals_.contact_time += tally.touches * step;
  totals_.evaluations += tally.touches;
  totals_.wall_work += tally.wall_power * step;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) totals_.contact_moment(a, b) += tally.moment[3 * a + b] * step;
  }
}

MoveTask DemGroup::move_task(double step) {
  const Eigen::Vector3d& gravity = laws_->gravity();
  MoveTask moving{.spheres = spheres_.view(), .estimate = spheres_.seen_velocity.data(), .step = step};
  if (laws_->turns()) {
    moving.estimate_spin = spheres_.seen_spin.data();
  } else {
    moving.spheres.spin = nullptr;
  }
  moving.pushed = everyone_.data(), moving.pushed_count = count();
  moving.end = count();
  moving.gravity = quad(gravity, 0);
  return moving;
}

void DemGroup::kick(double time) {
  const Eigen::Vector3d& gravity = laws_->gravity();
  for (std::uint32_t k = 0; k < count(); ++k) {
    Quad &v = spheres_.velocity[k], &w = spheres_.spin[k];
    const Quad &f = spheres_.force[k], &t = spheres_.torque[k];
    v = {v.x + time * (v.w * f.x + gravity.x()), v.y + time * (v.w * f.y + gravity.y()), v.z + time * (v.w * f.z + gravity.z()), v.w};
    if (laws_->turns()) w = {w.x + time * w.w * t.x, w.y + time * w.w * t.y, w.z + time * w.w * t.z, w.w};
  }
}

void DemGroup::advance_to(double time, double margin) {
  if (!(time > time_)) return;
  const double steps = std::max(1.0, std::ceil((time - time_) / laws_->step() * (1 - 1e-12)));
  const double step = (time - time_) / steps;
  find_near(margin);
  // The forces of now, from which histories go on and velocities are set half a step back.
  spheres_.seen_velocity = spheres_.velocity, spheres_.seen_spin = spheres_.spin;
  std::vector<Work> works;
  works.reserve(1 + walls_.size());
  each_list([&](Pairs& pairs, const WallView* wall) {
    if (pairs.count() > 0) works.push_back({pairs, Keeper(*this, pairs, wall != nullptr), task(pairs, wall)});
  });
  const auto forces = [&](double before, double after, double share) {
    for (Work& work : works) find_contacts(work);
    for (Work& work : works) add_forces(work, before, after, share);
  };
  for (Work& work : works) work.task.keeper = &work.keeper;
  forces(0, step / 2, step / 2);
  kick(-step / 2);
  MoveTask moving = move_task(step);
  const double start = time_;
  for (double k = 1; k <= steps; ++k) {
    laws_->kernel_->move(moving);
    time_ = k < steps ? start + k * step : time;
    forces(step / 2, k < steps ? step / 2 : 0, k < steps ? step : step / 2);  // sums by the trapezoidal rule
  }
  kick(step / 2);
  for (std::uint32_t k = 0; k < count(); ++k) spheres_.force[k] = spheres_.torque[k] = {};
  totals_.steps += static_cast<long>(steps) * count();
}

}  // namespace scalebreak

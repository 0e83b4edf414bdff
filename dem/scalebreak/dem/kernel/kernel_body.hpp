// Included once per instruction set, inside that set's namespace (see kernel_*.cpp).

#include "contact_lanes.hpp"
// in this order
#include "contact_laws.hpp"
// in this order
#include "near_loop.hpp"
// in this order
#include "contact_loop.hpp"

template <bool turns, bool estimates>
void push_spheres(const MoveTask& task) {
  const SpheresView& s = task.spheres;
  const double dt = task.step;
  const Four step = {dt, dt, dt, 0}, ahead_of_step = {1.5 * dt, 1.5 * dt, 1.5 * dt, 0}, gravity = load(task.gravity);
  for (std::uint32_t k = 0; k < task.pushed_count; ++k) {
    if (s.far && k + ahead < task.pushed_count) {
      const std::uint32_t next = task.pushed[k + ahead];
      ask_for(s.velocity[next]), ask_for(s.force[next]);
      if (turns) ask_for(s.spin[next]), ask_for(s.torque[next]);
    }
    const std::uint32_t i = task.pushed[k];
    const Four velocity = load(s.velocity[i]), gain = load(s.force[i]) * all(velocity[3]);
    store(s.velocity[i], velocity + gain * step);
    store(s.force[i], all(0));
    if constexpr (estimates) store(task.estimate[i], velocity + (gain + gravity) * ahead_of_step);
    if constexpr (turns) {
      const Four spin = load(s.spin[i]), turned = load(s.torque[i]) * all(spin[3]);
      store(s.spin[i], spin + turned * step);
      store(s.torque[i], all(0));
      if constexpr (estimates) store(task.estimate_spin[i], spin + turned * ahead_of_step);
    }
  }
}

template <bool falls>
void move_spheres(MoveTask& task) {
  const SpheresView& s = task.spheres;
  const double dt = task.step;
  const Four step = {dt, dt, dt, 0}, gain = load(task.gravity) * step;
  Four fastest = all(0), poison = all(0);  // of what is not a number, not a number comes out
  const auto one = [&](std::uint32_t i) __attribute__((always_inline)) {
    Four velocity = load(s.velocity[i]);
    if constexpr (falls) {
      velocity += gain;
      store(s.velocity[i], velocity);
    }
    const Four there = load(s.position[i]) + velocity * step;
    store(s.position[i], there);
    Four peculiar = velocity;
    peculiar[0] -= task.shear_rate * (there[2] - task.middle);
    peculiar *= peculiar;
    fastest = fastest > peculiar ? fastest : peculiar;
    poison += peculiar - peculiar;
  };
  if (task.movers) {
    for (std::uint32_t k = task.begin; k < task.end; ++k) {
      if (s.far && k + ahead < task.end) ask_for(s.position[task.movers[k + ahead]]), ask_for(s.velocity[task.movers[k + ahead]]);
      one(task.movers[k]);
    }
  } else {
    for (std::uint32_t i = task.begin; i < task.end; ++i) one(i);
  }
  task.fastest_squared = fastest[0] + fastest[1] + fastest[2] + poison[0] + poison[1] + poison[2];
}

inline void move(MoveTask& task) {
  const bool turns = task.spheres.spin != nullptr;
  if (task.estimate) {
    turns ? push_spheres<true, true>(task) : push_spheres<false, true>(task);
  } else {
    turns ? push_spheres<true, false>(task) : push_spheres<false, false>(task);
  }
  const Quad& g = task.gravity;
  g.x != 0 || g.y != 0 || g.z != 0 ? move_spheres<true>(task) : move_spheres<false>(task);
}

inline void select(SelectTask& task) {
  const Quad* position = task.spheres.position;
  std::uint32_t count = 0;
  for (std::uint32_t i = task.begin; i < task.end; ++i) {
    const Four here = load(position[i]);
    const double reach = here[3] + task.margin;
    for (std::uint32_t k = task.start[i]; k < task.start[i + 1]; ++k) {
      const std::uint32_t other = task.neighbour[k];
      const Four there = load(position[sphere_of(other)]);
      Four between = there - here + load(task.shift[image_of(other)]);
      between *= between;
      const double distance = reach + there[3];
      task.first[count] = i;
      task.second[count] = other;
      count += between[0] + between[1] + between[2] < distance * distance ? 1u : 0u;
    }
  }
  task.count = count;
}

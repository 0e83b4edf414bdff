// Included once per instruction set, inside that set's namespace (see kernel_*.cpp).

#include "contact_lanes.hpp"
// in this order
#include "contact_laws.hpp"
// in this order
#include "near_loop.hpp"
// in this order
#include "contact_loop.hpp"

template <bool turns, bool estimates>
void move_spheres(MoveTask& task) {
  const SpheresView& s = task.spheres;
  const double dt = task.step;
  const Four step = {dt, dt, dt, 0}, half = {dt / 2, dt / 2, dt / 2, 0}, gravity = load(task.gravity);
  Four fastest = all(0), poison = all(0);  // of what is not a number, not a number comes out
  const auto one = [&](std::uint32_t i) __attribute__((always_inline)) {
    const Four velocity = load(s.velocity[i]), position = load(s.position[i]);
    const Four acceleration = load(s.force[i]) * all(velocity[3]) + gravity;
    const Four moved = velocity + acceleration * step, there = position + moved * step;
    store(s.velocity[i], moved);
    store(s.position[i], there);
    store(s.force[i], all(0));
    Four peculiar = moved;
    peculiar[0] -= task.shear_rate * (there[2] - task.middle);
    peculiar *= peculiar;
    fastest = fastest > peculiar ? fastest : peculiar;
    poison += peculiar - peculiar;
    if constexpr (estimates) store(task.estimate[i], moved + acceleration * half);
    if constexpr (turns) {
      const Four spin = load(s.spin[i]), turned = load(s.torque[i]) * all(spin[3]);
      store(s.spin[i], spin + turned * step);
      store(s.torque[i], all(0));
      if constexpr (estimates) store(task.estimate_spin[i], spin + turned * step + turned * half);
    }
  };
  if (task.movers) {
    for (std::uint32_t k = task.begin; k < task.end; ++k) one(task.movers[k]);
  } else {
    for (std::uint32_t i = task.begin; i < task.end; ++i) one(i);
  }
  task.fastest_squared = fastest[0] + fastest[1] + fastest[2] + poison[0] + poison[1] + poison[2];
}

inline void move(MoveTask& task) {
  const bool turns = task.spheres.spin != nullptr, estimates = task.estimate != nullptr;
  if (turns) {
    estimates ? move_spheres<true, true>(task) : move_spheres<true, false>(task);
  } else {
    estimates ? move_spheres<false, true>(task) : move_spheres<false, false>(task);
  }
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

// Included once per instruction set, inside that set's namespace (see kernel_*.cpp): which of the near pairs touch.

/// So many pairs ahead spheres are asked for.
inline constexpr std::uint32_t ahead = 128;

inline void meet_spheres(ForceTask& task) {
  const NearView near = task.near;
  const Quad *const position = task.spheres.position, *const shift = task.shift;
  const bool equal = task.diameter > 0;
  const Pack reach_of_all(task.diameter * task.diameter);
  std::uint32_t first[width], second[width];
  for (std::uint32_t k = 0; k < near.count; k += width) {
    const std::uint32_t *ones = near.first + k, *others = near.second + k;
    if (k + width > near.count) {  // the last few, filled up
      each_lane([&](auto lane) {
        const bool real = k + lane < near.count;
        first[lane] = real ? ones[lane] : 0, second[lane] = real ? others[lane] : nowhere;
      });
      ones = first, others = second;
    }
    if (task.spheres.far && k + ahead + width <= near.count) {
      each_lane(
          [&](auto lane) { ask_for(position[sphere_of(near.second[k + ahead + lane])]), ask_for(position[near.first[k + ahead + lane]]); });
    }
    Four between[width], radii[width];
    each_lane([&](auto lane) __attribute__((always_inline)) {
      const Four here = load(position[ones[lane]]), there = load(position[sphere_of(others[lane])]);
      between[lane] = there - here + load(shift[image_of(others[lane])]);
      radii[lane] = here + there;
    });
    const Vectors branch = vectors(between);
    const Pack touch = equal ? reach_of_all : columns(radii).w;
    const auto touches = branch.dot(branch) < (equal ? touch : touch * touch);
    if (none_of(touches)) continue;
    for (std::uint32_t lane = 0; lane < width; ++lane) {
      if (!touches[lane]) continue;
      task.keeper->meet(task, ones[lane], others[lane]);
      near.second[k + lane] = nowhere;
    }
  }
}

inline void meet_wall(ForceTask& task) {
  const NearView near = task.near;
  for (std::uint32_t k = 0; k < near.count; ++k) {
    if (near.second[k] == nowhere) continue;
    const Four here = load(task.spheres.position[near.first[k]]);
    if (!(task.wall->side * (task.wall->place - here[task.wall->axis]) < here[3])) continue;
    task.keeper->meet(task, near.first[k], no_image);
    near.second[k] = nowhere;
  }
}

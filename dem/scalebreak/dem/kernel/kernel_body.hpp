// Included once per instruction set, inside that set's namespace (see kernel_*.cpp).

#include "contact_block.hpp"

/// A normal law as packs, and what it is in the rows.
template <template <class> class Law>
struct Form {
  using Packed = Law<Pack>;
  static Law<double> source();
};
template <class T>
using JkrOnRadius = Jkr<T, DampingOn::contact_radius>;
template <class T>
using JkrOnOverlap = Jkr<T, DampingOn::overlap>;

/// A list of pairs worked through: those near enough are put into blocks, and a full block is worked on.
template <bool turns>
struct ForceLoop {
  ForceTask& task;
  ContactBlock& block;
  const bool slides, rolls, is_wet;

  [[gnu::always_inline]] Four branch_of(std::uint32_t k) const {
    const Four here = load(task.spheres.position[task.pairs.first[k]]);
    if (task.wall) {
      Quad along;
      (&along.x)[task.wall->axis] = task.wall->place - here[task.wall->axis];
      return load(along);
    }
    const std::uint32_t other = task.pairs.second[k];
    return load(task.spheres.position[sphere_of(other)]) - here + load(task.shift[image_of(other)]);
  }

  [[gnu::always_inline]] void run() {
    const PairsView& pairs = task.pairs;
    Quad branch[width];
    for (std::uint32_t k = 0; k < width; ++k) branch[k] = {};
    std::uint32_t begin = 0;
    for (; begin + width <= pairs.count; begin += width) {
      for (std::uint32_t k = 0; k < width; ++k) store(branch[k], branch_of(begin + k));
      const Pack square = vectors(branch).dot(vectors(branch));
      std::uint32_t known = 0;
      for (std::uint32_t k = 0; k < width; ++k) known |= pairs.state[begin + k];
      if (known == 0 && none_of(square < packs(pairs.reach_squared + begin))) continue;
      double squares[width];
      put(squares, square);
      for (std::uint32_t k = 0; k < width; ++k) look(begin + k, branch[k], squares[k]);
    }
    for (; begin < pairs.count; ++begin) {
      store(branch[0], branch_of(begin));
      look(begin, branch[0], branch[0].x * branch[0].x + branch[0].y * branch[0].y + branch[0].z * branch[0].z);
    }
    if (block.count > 0) work();
  }

  [[gnu::always_inline]] void look(std::uint32_t k, const Quad& branch, double square) {
    const PairsView& pairs = task.pairs;
    if (!(square < pairs.reach_squared[k])) {
      if (pairs.state[k] != apart) part(k);
      return;
    }
    if (pairs.state[k] == apart) meet(k);
    if (task.bridge) settle(k, square);
    const std::uint32_t n = block.count++;
    block.pair[n] = k;
    block.branch[n] = {branch.x, branch.y, branch.z, square};
    block.solid[n] = pairs.state[k] == touching ? 1.0 : 0.0;
    collect(n, k);
    if (block.count == block_size) work();
  }

  /// What the spheres of a contact bring to it.
  [[gnu::always_inline]] void collect(std::uint32_t n, std::uint32_t k) {
    const SpheresView& spheres = task.spheres;
    const std::uint32_t i = task.pairs.first[k];
    if (task.wall) {
      store(block.velocity[n], load(spheres.seen_velocity[i]) - load(task.wall->velocity));
      block.radius2[n] = 0;
      if constexpr (turns) {
        store(block.spin1[n], load(spheres.seen_spin[i]));
        block.spin2[n] = {};
      }
    } else {
      const std::uint32_t other = task.pairs.second[k], j = sphere_of(other);
      store(block.velocity[n],
            load(spheres.seen_velocity[i]) - load(spheres.seen_velocity[j]) - load(task.shift_velocity[image_of(other)]));
      block.radius2[n] = spheres.position[j].w;
      if constexpr (turns) {
        store(block.spin1[n], load(spheres.seen_spin[i]));
        store(block.spin2[n], load(spheres.seen_spin[j]));
      }
    }
    block.velocity[n].w = spheres.position[i].w;
  }

  [[nodiscard]] double touch_of(std::uint32_t k) const {
    const double first = task.spheres.position[task.pairs.first[k]].w;
    return task.wall ? first : first + task.spheres.position[sphere_of(task.pairs.second[k])].w;
  }

  [[gnu::noinline]] void meet(std::uint32_t k) {
    const PairsView& pairs = task.pairs;
    if (task.begin) task.begin(task.context, k);
    pairs.state[k] = touching;
    pairs.begun[k] = task.time;
    if (pairs.slide) pairs.slide[k] = {};
    if (pairs.roll) pairs.roll[k] = {};
    const std::uint32_t row = pairs.row[k];
    const double reach = touch_of(k) + (task.bridge && task.bridge[row] > task.hold[row] ? task.bridge[row] : task.hold[row]);
    pairs.reach_squared[k] = reach * reach;
    task.tally.starts += task.wall ? 0.5 : 1.0;
  }

  [[gnu::noinline]] void part(std::uint32_t k) {
    task.pairs.state[k] = apart;
    const double reach = touch_of(k);
    task.pairs.reach_squared[k] = reach * reach;
    if (task.end) task.end(task.context, k);
  }

  /// Whether the solids of a bridged pair touch.
  void settle(std::uint32_t k, double square) {
    const PairsView& pairs = task.pairs;
    const double touch = touch_of(k), reach = touch + (pairs.state[k] == touching ? task.hold[pairs.row[k]] : 0.0);
    const bool solid = square < reach * reach;
    if (solid && pairs.state[k] == bridged) {
      pairs.state[k] = touching;
      task.tally.starts += task.wall ? 0.5 : 1.0;
    } else if (!solid && pairs.state[k] == touching) {
      pairs.state[k] = bridged;
      if (pairs.slide) pairs.slide[k] = {};
      if (pairs.roll) pairs.roll[k] = {};
    }
  }

  [[gnu::noinline]] void work() {
    fill_up();
    find_geometry(task, block);
    switch (task.rows[0].normal.index()) {
      case 0: press<Form<Linear>>(task, block); break;
      case 1: press<Form<Hertz>>(task, block); break;
      case 2: press<Form<JkrOnRadius>>(task, block); break;
      default: press<Form<JkrOnOverlap>>(task, block);
    }
    if (task.rows[0].tangential.acts()) {
      rub(task, block);
    } else if (slides) {
      for (std::uint32_t k = 0; k < block.count; ++k) block.across[k] = {};
    }
    if (rolls) roll(task, block);
    if (is_wet) wet(task, block);
    balance(task, block, slides, rolls);
    for (std::uint32_t k = 0; k < block.count; ++k) scatter(k);
    block.count = 0;
  }

  /// The lanes beyond the last contact repeat it.
  void fill_up() {
    for (std::uint32_t k = block.count; k % width != 0; ++k) {
      const std::uint32_t last = block.count - 1;
      block.pair[k] = block.pair[last];
      block.branch[k] = block.branch[last];
      block.velocity[k] = block.velocity[last];
      block.spin1[k] = block.spin1[last];
      block.spin2[k] = block.spin2[last];
      block.radius2[k] = block.radius2[last];
      block.solid[k] = block.solid[last];
      block.across[k] = block.turning[k] = block.history[k] = {};
    }
  }

  [[gnu::always_inline]] void scatter(std::uint32_t n) {
    const SpheresView& spheres = task.spheres;
    const std::uint32_t k = block.pair[n], i = task.pairs.first[k];
    Four force = load(block.force[n]);
    force[3] = 0;
    store(spheres.force[i], load(spheres.force[i]) - force);
    task.tally.touches += block.solid[n] * (task.wall ? 0.5 : 1.0);
    if (task.sums_moment) sum_moment(n);
    if (task.pair_force) task.pair_force[k] = block.force[n], task.pair_branch[k] = block.branch[n];
    if constexpr (turns) {
      Four torque = load(block.torque1[n]);
      torque[3] = 0;
      store(spheres.torque[i], load(spheres.torque[i]) + torque);
    }
    if (task.wall) {
      task.tally.wall_power -= force[0] * task.wall->velocity.x + force[1] * task.wall->velocity.y + force[2] * task.wall->velocity.z;
      if constexpr (turns) {
        if (task.wall->stops_spin && block.solid[n] > 0) {
          spheres.spin[i].x = spheres.spin[i].y = spheres.spin[i].z = 0;
          spheres.torque[i] = {};
        }
      }
      return;
    }
    const std::uint32_t j = sphere_of(task.pairs.second[k]);
    Four torque = all(0);
    if constexpr (turns) torque = load(block.torque2[n]), torque[3] = 0;
    if (j - task.own_begin < task.own_end - task.own_begin) {
      store(spheres.force[j], load(spheres.force[j]) + force);
      if constexpr (turns) store(spheres.torque[j], load(spheres.torque[j]) + torque);
    } else {
      Deferred& deferred = task.deferred[task.deferred_count++];
      deferred.sphere = j;
      store(deferred.force, force);
      store(deferred.torque, torque);
    }
  }

  void sum_moment(std::uint32_t n) {
    const double force[3] = {block.force[n].x, block.force[n].y, block.force[n].z};
    const double branch[3] = {block.branch[n].x, block.branch[n].y, block.branch[n].z};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) task.tally.moment[3 * a + b] += force[a] * branch[b];
    }
  }
};

inline void forces(ForceTask& task) {
  ContactBlock block;
  const ContactLaws& laws = task.rows[0];
  const bool rolls = laws.rolling.acts(), is_wet = laws.liquid.acts(), slides = laws.tangential.acts() || (is_wet && laws.liquid.viscous);
  if (task.turns) {
    ForceLoop<true>{task, block, slides, rolls, is_wet}.run();
  } else {
    ForceLoop<false>{task, block, slides, rolls, is_wet}.run();
  }
}

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

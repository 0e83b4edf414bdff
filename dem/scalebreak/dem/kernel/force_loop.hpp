// Included once per instruction set, inside that set's namespace (see kernel_*.cpp).

/// A list of pairs worked through: those near enough are put into blocks, and a full block is worked on.
template <Turns turns>
struct ForceLoop {
  ForceTask& task;
  ContactBlock& block;

  [[gnu::always_inline]] Four branch_of(std::uint32_t k, double& touch) const {
    const Four here = load(task.spheres.position[task.pairs.first[k]]);
    if (task.wall) {
      Quad along;
      (&along.x)[task.wall->axis] = task.wall->place - here[task.wall->axis];
      touch = here[3];
      return load(along);
    }
    const std::uint32_t other = task.pairs.second[k];
    const Four there = load(task.spheres.position[sphere_of(other)]);
    touch = here[3] + there[3];
    return there - here + load(task.shift[image_of(other)]);
  }

  void run() {
    const PairsView pairs = task.pairs;
    Quad branch[width];
    double touch[width], squares[width];
    std::uint32_t begin = 0;
    for (; begin + width <= pairs.count; begin += width) {
      std::uint32_t known = 0;
      for (std::uint32_t k = 0; k < width; ++k) {
        store(branch[k], branch_of(begin + k, touch[k]));
        known += pairs.state[begin + k];
      }
      const Vectors between = vectors(branch);
      const Pack square = between.dot(between);
      const auto near = square < packs(pairs.reach_squared + begin);
      if (known == 0 && none_of(near)) continue;
      if (known == width * touching && all_of(near) && !task.bridge && block.count + width <= block_size) {
        append(begin, between, square, touch);  // all touch, as they did
        continue;
      }
      put(squares, square);
      for (std::uint32_t k = 0; k < width; ++k) look(begin + k, branch[k], squares[k], touch[k]);
    }
    for (; begin < pairs.count; ++begin) {
      store(branch[0], branch_of(begin, touch[0]));
      look(begin, branch[0], branch[0].x * branch[0].x + branch[0].y * branch[0].y + branch[0].z * branch[0].z, touch[0]);
    }
    if (block.count > 0) work();
  }

  [[gnu::always_inline]] void append(std::uint32_t begin, const Vectors& between, const Pack& square, const double* touch) {
    const std::uint32_t n = block.count;
    put(block.x + n, between.x);
    put(block.y + n, between.y);
    put(block.z + n, between.z);
    put(block.square + n, square);
    for (std::uint32_t k = 0; k < width; ++k) {
      block.pair[n + k] = begin + k;
      block.touch[n + k] = touch[k];
      block.solid[n + k] = 1;
      collect(n + k, begin + k);
    }
    block.count += width;
    if (block.count == block_size) work();
  }

  [[gnu::always_inline]] void look(std::uint32_t k, const Quad& branch, double square, double touch) {
    const PairsView& pairs = task.pairs;
    if (!(square < pairs.reach_squared[k])) {
      if (pairs.state[k] != apart) part(k, touch);
      return;
    }
    if (pairs.state[k] == apart) meet(k, touch);
    if (task.bridge) settle(k, square, touch);
    const std::uint32_t n = block.count++;
    block.pair[n] = k;
    block.x[n] = branch.x, block.y[n] = branch.y, block.z[n] = branch.z;
    block.square[n] = square;
    block.touch[n] = touch;
    block.solid[n] = pairs.state[k] == touching ? 1.0 : 0.0;
    collect(n, k);
    if (block.count == block_size) work();
  }

  /// What the spheres of a contact bring to it.
  [[gnu::always_inline]] void collect(std::uint32_t n, std::uint32_t k) {
    const SpheresView& spheres = task.spheres;
    const std::uint32_t i = task.pairs.first[k];
    const Four radius1 = all(spheres.position[i].w);
    if (task.wall) {
      store(block.velocity[n], load(spheres.seen_velocity[i]) - load(task.wall->velocity));
      if constexpr (turns == Turns::sliding) store(block.swirl[n], radius1 * load(spheres.seen_spin[i]));
      if constexpr (turns == Turns::all) {
        store(block.spin1[n], task.turns ? load(spheres.seen_spin[i]) : all(0));
        block.spin2[n] = {};
        block.radius1[n] = radius1[0], block.radius2[n] = 0;
      }
      return;
    }
    const std::uint32_t other = task.pairs.second[k], j = sphere_of(other);
    store(block.velocity[n], load(spheres.seen_velocity[i]) - load(spheres.seen_velocity[j]) - load(task.shift_velocity[image_of(other)]));
    const Four radius2 = all(spheres.position[j].w);
    if constexpr (turns == Turns::sliding)
      store(block.swirl[n], radius1 * load(spheres.seen_spin[i]) + radius2 * load(spheres.seen_spin[j]));
    if constexpr (turns == Turns::all) {
      store(block.spin1[n], task.turns ? load(spheres.seen_spin[i]) : all(0));
      store(block.spin2[n], task.turns ? load(spheres.seen_spin[j]) : all(0));
      block.radius1[n] = radius1[0], block.radius2[n] = radius2[0];
    }
  }

  [[gnu::noinline]] void meet(std::uint32_t k, double touch) {
    const PairsView& pairs = task.pairs;
    if (task.begin) task.begin(task.context, k);
    pairs.state[k] = touching;
    pairs.begun[k] = task.time;
    if (pairs.slide) pairs.slide[k] = {};
    if (pairs.roll) pairs.roll[k] = {};
    const std::uint32_t row = pairs.row[k];
    const double reach = touch + (task.bridge && task.bridge[row] > task.hold[row] ? task.bridge[row] : task.hold[row]);
    pairs.reach_squared[k] = reach * reach;
    task.tally.starts += task.wall ? 0.5 : 1.0;
  }

  [[gnu::noinline]] void part(std::uint32_t k, double touch) {
    task.pairs.state[k] = apart;
    task.pairs.reach_squared[k] = touch * touch;
    if (task.end) task.end(task.context, k);
  }

  /// Whether the solids of a bridged pair touch.
  void settle(std::uint32_t k, double square, double touch) {
    const PairsView& pairs = task.pairs;
    const double reach = touch + (pairs.state[k] == touching ? task.hold[pairs.row[k]] : 0.0);
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
    switch (task.rows[0].normal.index()) {
      case 0: press_and_rub<Form<Linear>, turns>(task, block); break;
      case 1: press_and_rub<Form<Hertz>, turns>(task, block); break;
      case 2: press_and_rub<Form<JkrOnRadius>, turns>(task, block); break;
      default: press_and_rub<Form<JkrOnOverlap>, turns>(task, block);
    }
    if constexpr (turns == Turns::all) {
      const ContactLaws& laws = task.rows[0];
      if (laws.rolling.acts()) roll(task, block);
      if (laws.liquid.acts()) wet(task, block);
      balance(task, block, laws.rolling.acts());
    }
    scatter();
    block.count = 0;
  }

  /// The lanes beyond the last contact repeat it.
  void fill_up() {
    const std::uint32_t last = block.count - 1;
    for (std::uint32_t k = block.count; k % width != 0; ++k) {
      block.pair[k] = block.pair[last];
      for (double* list : {block.x, block.y, block.z, block.square, block.touch, block.radius1, block.radius2, block.solid})
        list[k] = list[last];
      for (Quad* list : {block.velocity, block.swirl, block.spin1, block.spin2, block.history}) list[k] = list[last];
    }
  }

  /// Adds what the contacts of a block exert. Those of one first sphere follow each other: their sum stays in registers.
  void scatter() {
    const SpheresView& spheres = task.spheres;
    const double torque_by = -task.torque * task.radius_share;  // of Turns::sliding, whose arms are the radii
    const bool rubs = turns == Turns::sliding || (turns == Turns::all && task.turns);
    // Kept in registers: what is stored below could be any of them, as far as the compiler sees.
    const std::uint32_t *const first = task.pairs.first, *const second = task.pairs.second;
    Quad *const forces = spheres.force, *const torques = spheres.torque;
    const Quad* const positions = spheres.position;
    const std::uint32_t count = block.count, own_begin = task.own_begin, own = task.own_end - task.own_begin;
    const bool wall = task.wall != nullptr;
    std::uint32_t current = first[block.pair[0]];
    Four force_sum = all(0), torque_sum = all(0);
    const auto flush = [&] {
      store(forces[current], load(forces[current]) - force_sum);
      if (!rubs) return;
      if constexpr (turns == Turns::sliding) torque_sum *= all(torque_by * positions[current].w);
      store(torques[current], load(torques[current]) + torque_sum);
    };
    for (std::uint32_t n = 0; n < count; ++n) {
      const std::uint32_t k = block.pair[n], i = first[k];
      if (i != current) {
        flush();
        current = i, force_sum = torque_sum = all(0);
      }
      const Four force = load(block.force[n]), torque = rubs ? load(block.torque1[n]) : all(0);
      force_sum += force;
      torque_sum += torque;
      if (wall) continue;
      const std::uint32_t j = sphere_of(second[k]);
      Four back = all(0);
      if constexpr (turns == Turns::sliding) back = torque * all(torque_by * positions[j].w);
      if constexpr (turns == Turns::all) back = rubs ? load(block.torque2[n]) : all(0);
      if (j - own_begin < own) {
        store(forces[j], load(forces[j]) + force);
        if (rubs) store(torques[j], load(torques[j]) + back);
      } else {
        Deferred& deferred = task.deferred[task.deferred_count++];
        deferred.sphere = j;
        store(deferred.force, force);
        store(deferred.torque, back);
      }
    }
    flush();
    tell();
  }

  /// What is counted and summed of a block.
  void tell() {
    double solids = block.count;
    if (task.bridge) {
      solids = 0;
      for (std::uint32_t n = 0; n < block.count; ++n) solids += block.solid[n];
    }
    task.tally.touches += task.wall ? solids / 2 : solids;
    if (task.wall) {
      for (std::uint32_t n = 0; n < block.count; ++n) {
        const Quad &force = block.force[n], &velocity = task.wall->velocity;
        task.tally.wall_power -= force.x * velocity.x + force.y * velocity.y + force.z * velocity.z;
      }
      if (task.wall->stops_spin && turns != Turns::none) stop_spins();
    }
    if (task.sums_moment) sum_moment();
    if (!task.pair_force) return;
    for (std::uint32_t n = 0; n < block.count; ++n) {
      task.pair_force[block.pair[n]] = block.force[n];
      task.pair_branch[block.pair[n]] = {block.x[n], block.y[n], block.z[n], 0};
    }
  }

  /// W 5: what touches such a wall has no spin.
  void stop_spins() {
    if (!task.turns) return;
    for (std::uint32_t n = 0; n < block.count; ++n) {
      if (block.solid[n] == 0) continue;
      const std::uint32_t i = task.pairs.first[block.pair[n]];
      task.spheres.spin[i].x = task.spheres.spin[i].y = task.spheres.spin[i].z = 0;
      task.spheres.torque[i] = {};
    }
  }

  void sum_moment() {
    Four rows[3] = {all(0), all(0), all(0)};  // of branch x, y, z, by the force's component
    for (std::uint32_t n = 0; n < block.count; ++n) {
      const Four force = load(block.force[n]);
      rows[0] += force * all(block.x[n]);
      rows[1] += force * all(block.y[n]);
      rows[2] += force * all(block.z[n]);
    }
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) task.tally.moment[3 * a + b] += rows[b][a];
    }
  }
};

inline void forces(ForceTask& task) {
  ContactBlock block;
  for (Quad* list : {block.swirl, block.spin1, block.spin2, block.history}) list[0] = {};
  const ContactLaws& laws = task.rows[0];
  const bool all_of_it = laws.rolling.acts() || laws.liquid.acts() || (laws.tangential.acts() && laws.arm == TorqueArm::contact);
  if (all_of_it) {
    ForceLoop<Turns::all>{task, block}.run();
  } else if (laws.tangential.acts()) {
    ForceLoop<Turns::sliding>{task, block}.run();
  } else {
    ForceLoop<Turns::none>{task, block}.run();
  }
}

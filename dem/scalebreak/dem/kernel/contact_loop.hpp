// Included once per instruction set, inside that set's namespace (see kernel_*.cpp).

/// So many packs of contacts are pressed before the rest of their laws follows.
inline constexpr std::uint32_t block_size = 8;

/// All contacts of a list worked through, `width` at a time.
template <class LawForm, Turns turns, bool wall>
struct ContactLoop {
  ForceTask& task;
  const bool turning = turns == Turns::sliding || (turns == Turns::all && task.turns);
  Vectors moment[3];  ///< of the force's x, y and z, by the branch

  [[gnu::noinline]] void run() {
    const Acting acting(task.rows[0]);
    PackedLaws<LawForm, turns> laws{};
    if (task.one_row) laws.make_of_all(task, acting);
    if (task.contacts.count == 0) return;
    const double solids_before = task.tally.touches;
    ContactLanes block[block_size];
    for (std::uint32_t k = 0; k < task.contacts.count;) {
      if (task.spheres.far) fetch_ahead(k + 2 * block_size * width);
      std::uint32_t filled = 0;
      for (; filled < block_size && k < task.contacts.count; k += width) {
        ContactLanes& at = block[filled];
        number(task, k, at);
        locate<wall>(task, at);
        at.square = at.between.dot(at.between);
        if (look(at, at.square)) ++filled;
      }
      for (std::uint32_t n = 0; n < filled; ++n) {
        if (!task.one_row) laws.make_normal_of_rows(task, block[n]);
        press<LawForm>(task, laws.normal, block[n]);
      }
      for (std::uint32_t n = 0; n < filled; ++n) {
        const ContactLanes& at = block[n];
        if (!task.one_row) laws.make_of_rows(task, at, acting);
        const Exerted out = exert<LawForm, turns, wall>(task, acting, laws, at, motion_of<turns, wall>(task, at));
        if (task.sums_moment) add_moment(at, out);
        scatter(at, out);
        if (wall || task.contact_force) tell(at, out);
      }
    }
    if (wall) task.tally.touches = (task.tally.touches + solids_before) / 2;
    if (!task.sums_moment) return;
    for (int a = 0; a < 3; ++a) {
      const Pack* const parts[3] = {&moment[a].x, &moment[a].y, &moment[a].z};
      for (int b = 0; b < 3; ++b) task.tally.moment[3 * a + b] += reduce(*parts[b]);
    }
  }

  /// Asks for all that the next block needs of the spheres.
  [[gnu::noinline]] void fetch_ahead(std::uint32_t begin) const {
    const SpheresView& s = task.spheres;
    const std::uint32_t end = begin + block_size * width < task.contacts.count ? begin + block_size * width : task.contacts.count;
    const auto fetch = [&](std::uint32_t i) {
      ask_for(s.position[i]), ask_for(s.seen_velocity[i]), ask_for(s.force[i]);
      if (turning) ask_for(s.seen_spin[i]), ask_for(s.torque[i]);
    };
    for (std::uint32_t k = begin; k < end; ++k) {
      fetch(task.contacts.first[k]);
      if (!wall) fetch(sphere_of(task.contacts.second[k]));
    }
  }

  /// Which lanes touch; false if none acts. All that touched and do so still is the rule.
  [[gnu::always_inline]] bool look(ContactLanes& at, const Pack& square) {
    const std::uint8_t* const state = task.contacts.state + at.begin;
    at.partly = false;
    if (at.count == width && !task.bridge) {
      const Pack reach = at.touch + (task.one_row ? Pack(task.hold[0]) : Pack([&](auto lane) { return task.hold[at.row[lane]]; }));
      bool known = true;
      each_lane([&](auto lane) { known = known && state[lane] == touching; });
      if (known && all_of(square < reach * reach)) {
        task.tally.touches += width;
        return true;
      }
    }
    return settle(at, square);
  }

  /// Begins and ends contacts one by one.
  [[gnu::noinline]] bool settle(ContactLanes& at, const Pack& square) {
    bool any_acts = false;
    Pack solid(0), acts(0);
    for (std::uint32_t lane = 0; lane < at.count; ++lane) {
      const std::uint32_t k = at.begin + lane;
      settle(k, square[lane], at.touch[lane]);
      if (at.row == at.tail + 2 * width) at.tail[2 * width + lane] = task.contacts.row[k];
      const std::uint8_t state = task.contacts.state[k];
      solid[lane] = state == touching ? 1.0 : 0.0, acts[lane] = state != apart ? 1.0 : 0.0;
      task.tally.touches += state == touching ? 1.0 : 0.0;
      any_acts = any_acts || state != apart;
    }
    at.solid = solid, at.acts = acts, at.partly = true;
    return any_acts;
  }

  void settle(std::uint32_t k, double square, double touch) {
    std::uint8_t* const state = task.contacts.state + k;
    if (*state == apart) {
      if (square < touch * touch) task.keeper->meet_again(task, k);
      return;
    }
    const std::uint32_t row = task.contacts.row[k];
    const double solid_reach = touch + (*state == touching ? task.hold[row] : 0.0);
    const double reach = task.bridge && task.bridge[row] > solid_reach - touch ? touch + task.bridge[row] : solid_reach;
    if (!(square < reach * reach)) {
      task.keeper->part(task, k);
      return;
    }
    const std::uint8_t now = square < solid_reach * solid_reach ? touching : bridged;
    if (now == *state) return;
    *state = now;
    for (double* const list : {task.contacts.slide, task.contacts.roll}) {
      if (list) list[history_place(k)] = list[history_place(k) + history_stride] = list[history_place(k) + 2 * history_stride] = 0;
    }
    if (now == touching) task.tally.starts += wall ? 0.5 : 1.0;
  }

  /// Adds forces and torques to the spheres. Lanes beyond the end of the list add nothing to its last.
  [[gnu::always_inline]] void scatter(const ContactLanes& at, const Exerted& out) {
    const SpheresView spheres = task.spheres;
    const std::uint32_t own_begin = task.own_begin, own = task.own_end - task.own_begin;
    Four force[width], torque1[width], torque2[width];
    spread(out.force, force);
    if constexpr (turns != Turns::none) spread(out.torque1, torque1), spread(out.torque2, torque2);
    each_lane([&](auto lane) __attribute__((always_inline)) {
      const std::uint32_t i = at.first[lane];
      store(spheres.force[i], load(spheres.force[i]) - force[lane]);
      if constexpr (turns != Turns::none) {
        if (turning) store(spheres.torque[i], load(spheres.torque[i]) + torque1[lane]);
      }
      if constexpr (!wall) {
        const std::uint32_t j = sphere_of(at.second[lane]);
        if (j - own_begin < own) {
          store(spheres.force[j], load(spheres.force[j]) + force[lane]);
          if constexpr (turns != Turns::none) {
            if (turning) store(spheres.torque[j], load(spheres.torque[j]) + torque2[lane]);
          }
        } else {
          defer(j, force[lane], turns != Turns::none ? torque2[lane] : all(0));
        }
      }
    });
  }

  void defer(std::uint32_t sphere, Four force, Four torque) {
    if (task.deferred_count == task.deferred_room) task.keeper->make_room(task);
    Deferred& deferred = task.deferred[task.deferred_count++];
    torque[3] = sphere;
    store(deferred.force, force);
    store(deferred.torque, torque);
  }

  [[gnu::always_inline]] void add_moment(const ContactLanes& at, const Exerted& out) {
    moment[0] = moment[0] + out.force.x * at.between;
    moment[1] = moment[1] + out.force.y * at.between;
    moment[2] = moment[2] + out.force.z * at.between;
  }

  /// What walls and those who ask want to know.
  [[gnu::noinline]] void tell(const ContactLanes& at, const Exerted& out) {
    for (std::uint32_t lane = 0; lane < at.count; ++lane) {
      const Quad force{out.force.x[lane], out.force.y[lane], out.force.z[lane], 0};
      if constexpr (wall) {
        const Quad& velocity = task.wall->velocity;
        task.tally.wall_power -= force.x * velocity.x + force.y * velocity.y + force.z * velocity.z;
        if (task.wall->stops_spin && task.turns && (!at.partly || at.solid[lane] != 0)) stop_spin(at.first[lane]);
      }
      if (!task.contact_force) continue;
      task.contact_force[at.begin + lane] = force;
      task.contact_branch[at.begin + lane] = {at.between.x[lane], at.between.y[lane], at.between.z[lane], 0};
    }
  }

  /// W 5: what touches such a wall has no spin.
  void stop_spin(std::uint32_t i) {
    task.spheres.spin[i].x = task.spheres.spin[i].y = task.spheres.spin[i].z = 0;
    task.spheres.torque[i] = {};
  }
};

template <Turns turns, bool wall, template <class> class... Laws>
inline void exert_all(ForceTask& task, LawList<Laws...>) {
  const std::size_t chosen = task.rows[0].normal.index();
  std::size_t law = 0;
  ((law++ == chosen && (ContactLoop<Form<Laws>, turns, wall>{task}.run(), true)) || ...);
}
template <Turns turns, bool wall>
inline void exert_all(ForceTask& task) {
  exert_all<turns, wall>(task, NormalLaws{});
}

inline void find_contacts(ForceTask& task) { task.wall ? meet_wall(task) : meet_spheres(task); }

inline void forces(ForceTask& task) {
  if (task.wall) return exert_all<Turns::all, true>(task);  // few contacts: one loop for all laws of the surfaces
  const ContactLaws& laws = task.rows[0];
  const bool all_of_it = laws.rolling.acts() || laws.liquid.acts() || (laws.tangential.acts() && laws.arm == TorqueArm::contact);
  if (all_of_it) {
    exert_all<Turns::all, false>(task);
  } else if (laws.tangential.acts()) {
    exert_all<Turns::sliding, false>(task);
  } else {
    exert_all<Turns::none, false>(task);
  }
}

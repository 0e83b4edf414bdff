// Included once per instruction set, inside that set's namespace (see kernel_*.cpp): the laws, a block of contacts at a time.

/// A normal law as packs, and what it is in the rows.
template <template <class> class Law>
struct Form {
  using Packed = Law<Pack>;
  using Source = Law<double>;
};
template <class T>
using JkrOnRadius = Jkr<T, DampingOn::contact_radius>;
template <class T>
using JkrOnOverlap = Jkr<T, DampingOn::overlap>;

/// Normal force and friction, in one pass. With Turns::all the numbers of the contact are put down for the passes that follow.
template <class LawForm, Turns turns>
[[gnu::noinline]] void press_and_rub(const ForceTask& task, ContactBlock& block) {
  using std::sqrt;
  using Source = typename LawForm::Source;
  constexpr bool hertz = std::is_same_v<Source, Hertz<double>>;
  constexpr bool adhesive = std::is_same_v<Source, JkrOnRadius<double>> || std::is_same_v<Source, JkrOnOverlap<double>>;
  const auto normal_part = [](const ContactLaws& laws) -> const Source& { return *std::get_if<Source>(&laws.normal); };
  const auto friction_part = [](const ContactLaws& laws) -> const Tangential& { return laws.tangential; };
  const bool rubs = turns != Turns::none && task.rows[0].tangential.acts();
  const bool rooted = hertz || task.rows[0].needs_overlap_root(), bridges = task.bridge != nullptr;
  const Pack time(task.history_step * task.length), after(task.history_after * task.length), force_by(task.force), swirl_by(task.spin * task.radius_share);
  if (rubs) gather_history(task.pairs.slide, block);
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const Pack distance = sqrt(packs(block.square + k)), inverse = 1.0 / distance;
    const Vectors normal = inverse * Vectors{packs(block.x + k), packs(block.y + k), packs(block.z + k)};
    const Vectors velocity = vectors(block.velocity + k);
    const Pack approach = normal.dot(velocity), depth = task.length * (packs(block.touch + k) - distance);
    const Pack overlap = adhesive ? depth : positive_part(depth);
    const auto law = packed_law<typename LawForm::Packed>(task, block, k, normal_part);
    const Pack x = law.coordinate(overlap);
    Pack total = law.force(x) + law.damping(x) * approach;
    ContactPointOf<Pack> point{.overlap = depth, .root = law.root_radius(x), .load = abs(law.load(x, total))};
    if (hertz) {
      point.overlap_root = x;
    } else if (rooted) {
      const Pack radius = of_rows(task, block, k, [](const ContactLaws& laws) { return laws.radius; });
      point.overlap_root = sqrt(sqrt(radius * positive_part(overlap)));
    }
    if (bridges) {
      const Pack solid = packs(block.solid + k);
      total *= solid;
      point.load *= solid;
    }
    Vectors force = total * normal, across;
    if (rubs) {
      Vectors speed = velocity - approach * normal;
      if constexpr (turns == Turns::sliding) {
        speed = speed + swirl_by * vectors(block.swirl + k).cross(normal);
      } else {
        const Turning turning = turning_of(task, block, k, normal, depth);
        speed = speed + turning.arm1 * turning.first + turning.arm2 * turning.second;
      }
      Vectors history = in_plane(vectors(block.history + k), normal);
      const auto friction = packed_law<TangentialOf<Pack>>(task, block, k, friction_part);
      across = step_slider(friction.at(point), false, history, speed, time, after);
      if (bridges) across = packs(block.solid + k) * across;
      put(block.history + k, history);
      force = force + across;
      if constexpr (turns == Turns::sliding) put(block.torque1 + k, normal.cross(across));
    }
    if constexpr (turns == Turns::all) {
      put(block.normal + k, normal);
      put(block.overlap + k, depth);
      put(block.approach + k, approach);
      put(block.root + k, point.root);
      put(block.overlap_root + k, point.overlap_root);
      put(block.load + k, point.load);
      put(block.along + k, total);
      put(block.across + k, across);
    } else {
      put(block.force + k, force_by * force);
    }
  }
  if (rubs) scatter_history(task.pairs.slide, block);
}

[[gnu::noinline]] inline void roll(const ForceTask& task, ContactBlock& block) {
  const auto part = [](const ContactLaws& laws) -> const Rolling& { return laws.rolling; };
  const Pack time(task.history_step * task.length), after(task.history_after * task.length);
  const bool rigid = task.rows[0].rolling.rigid(), bridges = task.bridge != nullptr;
  if (!rigid) gather_history(task.pairs.roll, block);
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const auto law = packed_law<RollingOf<Pack>>(task, block, k, part);
    const Turning turning = turning_of(task, block, k);
    Vectors history = rigid ? Vectors{} : in_plane(vectors(block.history + k), vectors(block.normal + k));
    const ContactPointOf<Pack> point{packs(block.overlap + k), packs(block.root + k), packs(block.overlap_root + k), packs(block.load + k)};
    Vectors torque = step_slider(law.at(point), rigid, history, turning.first - turning.second, time, after);
    if (bridges) torque = packs(block.solid + k) * torque;
    put(block.turning + k, torque);
    if (!rigid) put(block.history + k, history);
  }
  if (!rigid) scatter_history(task.pairs.roll, block);
}

[[gnu::noinline]] inline void wet(const ForceTask& task, ContactBlock& block) {
  const auto part = [](const ContactLaws& laws) -> const Liquid& { return laws.liquid; };
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const auto law = packed_law<LiquidOf<Pack>>(task, block, k, part);
    const Pack separation = max(-packs(block.overlap + k), law.separation_min), approach = packs(block.approach + k);
    put(block.along + k, Pack(packs(block.along + k) + law.normal_drag(separation) * approach - law.capillary_force(separation)));
    if (!law.viscous) continue;
    const Turning turning = turning_of(task, block, k);
    const Vectors centres = vectors(block.velocity + k) - approach * vectors(block.normal + k);
    const Pack radius1 = task.radius_share * packs(block.radius1 + k), radius2 = task.radius_share * packs(block.radius2 + k);
    put(block.across + k, vectors(block.across + k) + law.tangential_drag(separation) * centres +
                              law.rolling_drag(separation) * (radius1 * turning.first + radius2 * turning.second));
  }
}

/// Forces and torques of the scaled pair, of all that the passes before have put down.
[[gnu::noinline]] inline void balance(const ForceTask& task, ContactBlock& block, bool rolls) {
  const Pack force_by(task.force), torque_by(-task.torque);
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const Vectors normal = vectors(block.normal + k), across = vectors(block.across + k);
    put(block.force + k, force_by * (packs(block.along + k) * normal + across));
    if (!task.turns) continue;
    const Turning turning = turning_of(task, block, k);
    Vectors first = turning.arm1 * across, second = turning.arm2 * across;
    if (rolls) {
      const Vectors torque = vectors(block.turning + k);
      first = first + torque;
      second = second - torque;
    }
    put(block.torque1 + k, torque_by * normal.cross(first));
    put(block.torque2 + k, torque_by * normal.cross(second));
  }
}

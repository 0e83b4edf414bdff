// Included once per instruction set, inside that set's namespace (see kernel_*.cpp).

#include "lanes.hpp"

/// So many contacts are worked on at a time, law by law: all that is known of them lies in the first-level cache.
inline constexpr std::uint32_t block_size = 32;

struct ContactBlock {
  std::uint32_t count = 0;
  std::uint32_t pair[block_size];
  // Collected of the spheres:
  Quad branch[block_size];    ///< from the first centre to the second; w: its square
  Quad velocity[block_size];  ///< of the first past the second; w: radius of the first
  Quad spin1[block_size], spin2[block_size];
  double radius2[block_size];
  double solid[block_size];  ///< 1; 0 where only a bridge holds them
  // Worked out:
  Quad normal[block_size];
  double overlap[block_size], approach[block_size];  ///< of the original pair
  double root[block_size], overlap_root[block_size], load[block_size];
  double along[block_size];  ///< force between the centres, repulsion positive
  Quad across[block_size];   ///< force against sliding, on the original pair
  Quad turning[block_size];  ///< the same of torques: see FewBodySystem's rolling
  Quad history[block_size];
  Quad force[block_size], torque1[block_size], torque2[block_size];
};

/// The laws of `width` contacts of a block from k on.
template <class Law, class Member>
[[gnu::always_inline]] inline Pack of_rows(const ForceTask& task, const ContactBlock& block, std::uint32_t k, Law part, Member member) {
  if (task.one_row) return Pack(part(task.rows[0]).*member);
  return Pack([&](auto lane) { return part(task.rows[task.pairs.row[block.pair[k + lane]]]).*member; });
}

/// A law of lib as packs, of the rows that the contacts have.
template <class LawOf, class Part>
[[gnu::always_inline]] inline LawOf packed_law(const ForceTask& task, const ContactBlock& block, std::uint32_t k, Part part) {
  return LawOf::from(part(task.rows[0]), [&](auto member) { return of_rows(task, block, k, part, member); });
}

/// What a surface does at a contact: how the normal turns the spheres' surfaces.
struct Turning {
  Vector3Of<Pack> first, second;  ///< ω × n of the original pair
  Pack arm1, arm2;
};
[[gnu::always_inline]] inline Turning turning_of(const ForceTask& task, const ContactBlock& block, std::uint32_t k) {
  const Vector3Of<Pack> normal = vectors(block.normal + k);
  const Pack spin(task.spin), share(task.radius_share);
  Turning turning{spin * vectors(block.spin1 + k).cross(normal), spin * vectors(block.spin2 + k).cross(normal),
                  share * lanes<&Quad::w>(block.velocity + k), share * packs(block.radius2 + k)};
  if (task.rows[0].arm == TorqueArm::contact) {
    const Pack depth = packs(block.overlap + k);
    turning.arm1 -= (task.wall ? 1.0 : 0.5) * depth;
    if (!task.wall) turning.arm2 -= 0.5 * depth;
  }
  return turning;
}

[[gnu::always_inline]] inline ContactPointOf<Pack> point_at(const ContactBlock& block, std::uint32_t k) {
  return {packs(block.overlap + k), packs(block.root + k), packs(block.overlap_root + k), packs(block.load + k)};
}

inline void find_geometry(const ForceTask& task, ContactBlock& block) {
  using std::sqrt;
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const Pack distance = sqrt(lanes<&Quad::w>(block.branch + k));
    const Vector3Of<Pack> normal = (1.0 / distance) * vectors(block.branch + k);
    put(block.normal + k, normal);
    const Pack gap = distance - lanes<&Quad::w>(block.velocity + k) - packs(block.radius2 + k);
    put(block.overlap + k, Pack(-task.length * gap));
    put(block.approach + k, normal.dot(vectors(block.velocity + k)));
  }
}

template <class LawOf>
inline void press(const ForceTask& task, ContactBlock& block) {
  using std::sqrt;
  using Source = decltype(LawOf::source());
  const auto part = [](const ContactLaws& laws) -> const Source& { return *std::get_if<Source>(&laws.normal); };
  const auto radius_of = [](const ContactLaws& laws) -> const ContactLaws& { return laws; };
  const bool adhesive = task.hold[0] > 0 || std::is_same_v<Source, Jkr<double, DampingOn::contact_radius>> ||
                        std::is_same_v<Source, Jkr<double, DampingOn::overlap>>;
  const bool rooted = task.rows[0].needs_overlap_root() || std::is_same_v<Source, Hertz<double>>;
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const auto law = packed_law<typename LawOf::Packed>(task, block, k, part);
    Pack overlap = packs(block.overlap + k);
    if (!adhesive) overlap = positive_part(overlap);
    const Pack x = law.coordinate(overlap), approach = packs(block.approach + k), solid = packs(block.solid + k);
    const Pack total = law.force(x) + law.damping(x) * approach;
    put(block.along + k, Pack(solid * total));
    put(block.load + k, Pack(solid * abs(law.load(x, total))));
    put(block.root + k, law.root_radius(x));
    if (!rooted) continue;
    const Pack radius = of_rows(task, block, k, radius_of, &ContactLaws::radius);
    put(block.overlap_root + k, Pack(std::is_same_v<Source, Hertz<double>> ? x : Pack(sqrt(sqrt(radius * positive_part(overlap))))));
  }
}

inline void gather_history(const Quad* histories, ContactBlock& block) {
  for (std::uint32_t k = 0; k < block.count; ++k) store(block.history[k], load(histories[block.pair[k]]));
}
inline void scatter_history(Quad* histories, const ContactBlock& block) {
  for (std::uint32_t k = 0; k < block.count; ++k) store(histories[block.pair[k]], load(block.history[k]));
}

inline void rub(const ForceTask& task, ContactBlock& block) {
  const auto part = [](const ContactLaws& laws) -> const Tangential& { return laws.tangential; };
  const Pack time(task.history_step * task.length);
  gather_history(task.pairs.slide, block);
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const auto law = packed_law<TangentialOf<Pack>>(task, block, k, part);
    const Turning turning = turning_of(task, block, k);
    const Vector3Of<Pack> normal = vectors(block.normal + k);
    const Vector3Of<Pack> speed =
        vectors(block.velocity + k) - packs(block.approach + k) * normal + turning.arm1 * turning.first + turning.arm2 * turning.second;
    Vector3Of<Pack> history = turned_into_plane(vectors(block.history + k), normal);
    put(block.across + k, packs(block.solid + k) * step_slider(law.at(point_at(block, k)), false, history, speed, time));
    put(block.history + k, history);
  }
  scatter_history(task.pairs.slide, block);
}

inline void roll(const ForceTask& task, ContactBlock& block) {
  const auto part = [](const ContactLaws& laws) -> const Rolling& { return laws.rolling; };
  const Pack time(task.history_step * task.length);
  const bool rigid = task.rows[0].rolling.rigid();
  if (!rigid) gather_history(task.pairs.roll, block);
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const auto law = packed_law<RollingOf<Pack>>(task, block, k, part);
    const Turning turning = turning_of(task, block, k);
    const Vector3Of<Pack> normal = vectors(block.normal + k);
    Vector3Of<Pack> history = rigid ? Vector3Of<Pack>{} : turned_into_plane(vectors(block.history + k), normal);
    put(block.turning + k,
        packs(block.solid + k) * step_slider(law.at(point_at(block, k)), rigid, history, turning.first - turning.second, time));
    if (!rigid) put(block.history + k, history);
  }
  if (!rigid) scatter_history(task.pairs.roll, block);
}

inline void wet(const ForceTask& task, ContactBlock& block) {
  const auto part = [](const ContactLaws& laws) -> const Liquid& { return laws.liquid; };
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const auto law = packed_law<LiquidOf<Pack>>(task, block, k, part);
    const Pack separation = max(-packs(block.overlap + k), law.separation_min), approach = packs(block.approach + k);
    put(block.along + k, Pack(packs(block.along + k) + law.normal_drag(separation) * approach - law.capillary_force(separation)));
    if (!law.viscous) continue;
    const Turning turning = turning_of(task, block, k);
    const Vector3Of<Pack> normal = vectors(block.normal + k), centres = vectors(block.velocity + k) - approach * normal;
    const Pack radius1 = task.radius_share * lanes<&Quad::w>(block.velocity + k), radius2 = task.radius_share * packs(block.radius2 + k);
    put(block.across + k, vectors(block.across + k) + law.tangential_drag(separation) * centres +
                              law.rolling_drag(separation) * (radius1 * turning.first + radius2 * turning.second));
  }
}

/// Forces and torques on the first sphere and on the second, of the scaled pair. `turning` is what the rolling law gave.
inline void balance(const ForceTask& task, ContactBlock& block, bool slides, bool rolls) {
  const Pack force_by(task.force), torque_by(-task.torque);
  for (std::uint32_t k = 0; k < block.count; k += width) {
    const Vector3Of<Pack> normal = vectors(block.normal + k);
    Vector3Of<Pack> force = packs(block.along + k) * normal;
    if (slides) force = force + vectors(block.across + k);
    put(block.force + k, force_by * force);
    if (!task.turns) continue;
    const Turning turning = turning_of(task, block, k);
    Vector3Of<Pack> first, second;
    if (slides) {
      const Vector3Of<Pack> across = vectors(block.across + k);
      first = turning.arm1 * across;
      second = turning.arm2 * across;
    }
    if (rolls) {
      const Vector3Of<Pack> torque = vectors(block.turning + k);
      first = first + torque;
      second = second - torque;
    }
    put(block.torque1 + k, torque_by * normal.cross(first));
    put(block.torque2 + k, torque_by * normal.cross(second));
  }
}

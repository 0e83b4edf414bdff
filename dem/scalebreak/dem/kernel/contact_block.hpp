// Included once per instruction set, inside that set's namespace (see kernel_*.cpp).

#include "lanes.hpp"

/// So many contacts are worked on at a time, law by law: all that is known of them lies in the first-level cache.
inline constexpr std::uint32_t block_size = 64;

/// What of the spins a scene needs: nothing; how the surfaces slide, with the radii as arms; or all.
enum class Turns { none, sliding, all };

struct ContactBlock {
  std::uint32_t count = 0;
  std::uint32_t pair[block_size];
  // Collected of the spheres:
  double x[block_size], y[block_size], z[block_size], square[block_size];  ///< from the first centre to the second
  double touch[block_size];                                                ///< sum of the radii
  Quad velocity[block_size];                                               ///< of the first past the second
  Quad swirl[block_size];                                                  ///< radius1 ω1 + radius2 ω2
  Quad spin1[block_size], spin2[block_size];
  double radius1[block_size], radius2[block_size];
  double solid[block_size];  ///< 1; 0 where only a bridge holds them
  // Worked out, for the laws that follow:
  Quad normal[block_size];
  double overlap[block_size], approach[block_size];  ///< of the original pair
  double root[block_size], overlap_root[block_size], load[block_size];
  double along[block_size];  ///< force between the centres, repulsion positive
  Quad across[block_size];   ///< force against sliding, on the original pair
  Quad turning[block_size];  ///< the same of rolling
  Quad history[block_size];
  // What comes of it: on the second sphere, and torques; of Turns::sliding the torque per arm.
  Quad force[block_size], torque1[block_size], torque2[block_size];
};

/// A number of the laws of `width` contacts from k on; `part` takes it out of a row.
template <class Part>
[[gnu::always_inline]] inline Pack of_rows(const ForceTask& task, const ContactBlock& block, std::uint32_t k, Part part) {
  if (task.one_row) return Pack(part(task.rows[0]));
  return Pack([&](auto lane) { return part(task.rows[task.pairs.row[block.pair[k + lane]]]); });
}

/// A law of lib as packs, of the rows that the contacts have.
template <class LawOf, class Part>
[[gnu::always_inline]] inline LawOf packed_law(const ForceTask& task, const ContactBlock& block, std::uint32_t k, Part part) {
  return LawOf::from(part(task.rows[0]),
                     [&](auto member) { return of_rows(task, block, k, [&](const ContactLaws& row) { return part(row).*member; }); });
}

/// How the normal turns the spheres' surfaces, and at which arms.
struct Turning {
  Vectors first, second;  ///< ω × n of the original pair
  Pack arm1, arm2;
};
[[gnu::always_inline]] inline Turning turning_of(const ForceTask& task, const ContactBlock& block, std::uint32_t k, const Vectors& normal,
                                                 const Pack& overlap) {
  const Pack spin(task.spin), share(task.radius_share);
  Turning turning{spin * vectors(block.spin1 + k).cross(normal), spin * vectors(block.spin2 + k).cross(normal),
                  share * packs(block.radius1 + k), share * packs(block.radius2 + k)};
  if (task.rows[0].arm == TorqueArm::contact) {
    turning.arm1 -= (task.wall ? 1.0 : 0.5) * overlap;
    if (!task.wall) turning.arm2 -= 0.5 * overlap;
  }
  return turning;
}
[[gnu::always_inline]] inline Turning turning_of(const ForceTask& task, const ContactBlock& block, std::uint32_t k) {
  return turning_of(task, block, k, vectors(block.normal + k), packs(block.overlap + k));
}

[[gnu::always_inline]] inline void gather_history(const Quad* histories, ContactBlock& block) {
  for (std::uint32_t k = 0; k < block.count; ++k) store(block.history[k], load(histories[block.pair[k]]));
}
[[gnu::always_inline]] inline void scatter_history(Quad* histories, const ContactBlock& block) {
  for (std::uint32_t k = 0; k < block.count; ++k) store(histories[block.pair[k]], load(block.history[k]));
}

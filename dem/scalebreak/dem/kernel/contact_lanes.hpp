// Included once per instruction set, inside that set's namespace (see kernel_*.cpp): contacts side by side.

#include "lanes.hpp"

/// What of the spins a scene needs: nothing; how the surfaces slide, with the radii as arms; or all.
enum class Turns { none, sliding, all };

/// `width` contacts that follow each other in the list. Lanes beyond its end repeat the last.
struct ContactLanes {
  std::uint32_t begin, count;
  const std::uint32_t *first, *second, *row;
  std::uint32_t tail[3 * width];  ///< where these lie, if they are filled up
  Vectors between;                ///< from the first centre to the second
  Pack touch;                     ///< sum of the radii
  Pack square, inverse;           ///< of the distance of the centres
  Pack overlap, coordinate;       ///< of the original pair
  bool partly;                    ///< does something not act everywhere?
  Pack solid, acts;               ///< then 1 where solids touch, where anything acts; else 0
};

/// How they move past each other.
struct Motion {
  Vectors velocity;       ///< of the first past the second
  Vectors swirl;          ///< radius1 ω1 + radius2 ω2, of Turns::sliding
  Vectors spin1, spin2;   ///< of Turns::all
  Pack radius1, radius2;  ///< where spheres turn
};

/// The places of the contacts from k on.
[[gnu::always_inline]] inline void number(const ForceTask& task, std::uint32_t k, ContactLanes& at) {
  const ContactsView& contacts = task.contacts;
  at.begin = k, at.count = contacts.count - k < width ? contacts.count - k : width;
  at.first = contacts.first + k, at.second = contacts.second + k, at.row = contacts.row + k;
  if (at.count == width) return;
  for (std::uint32_t lane = 0; lane < width; ++lane) {
    const std::uint32_t c = lane < at.count ? lane : at.count - 1;
    at.tail[lane] = at.first[c], at.tail[width + lane] = at.second[c], at.tail[2 * width + lane] = at.row[c];
  }
  at.first = at.tail, at.second = at.tail + width, at.row = at.tail + 2 * width;
}

/// How the centres lie to each other.
template <bool wall>
[[gnu::always_inline]] inline void locate(const ForceTask& task, ContactLanes& at) {
  const Quad* const position = task.spheres.position;
  Four between[width], radii[width];
  each_lane([&](auto lane) __attribute__((always_inline)) {
    const Four here = load(position[at.first[lane]]);
    if constexpr (wall) {
      Quad along;
      (&along.x)[task.wall->axis] = task.wall->place - here[task.wall->axis];
      between[lane] = load(along), radii[lane] = here;
    } else {
      const std::uint32_t other = at.second[lane];
      const Four there = load(position[sphere_of(other)]);
      between[lane] = there - here + load(task.shift[image_of(other)]);
      radii[lane] = here + there;
    }
  });
  at.between = vectors(between);
  at.touch = !wall && task.diameter > 0 ? Pack(task.diameter) : columns(radii).w;
}

/// w of the quads of the lanes' first or second spheres.
template <class Place>
[[gnu::always_inline]] inline Pack radii(const ForceTask& task, Place place) {
  Four rows[width];
  each_lane([&](auto lane) { rows[lane] = load(task.spheres.position[place(lane)]); });
  return columns(rows).w;
}
template <class Place>
[[gnu::always_inline]] inline Vectors spins(const ForceTask& task, Place place) {
  Four rows[width];
  each_lane([&](auto lane) { rows[lane] = load(task.spheres.seen_spin[place(lane)]); });
  return vectors(rows);
}

template <Turns turns, bool wall>
[[gnu::always_inline]] inline Motion motion_of(const ForceTask& task, const ContactLanes& at) {
  Motion motion;
  const SpheresView& spheres = task.spheres;
  Four velocity[width];
  each_lane([&](auto lane) __attribute__((always_inline)) {
    const Four own = load(spheres.seen_velocity[at.first[lane]]);
    if constexpr (wall) {
      velocity[lane] = own - load(task.wall->velocity);
    } else {
      const std::uint32_t other = at.second[lane];
      velocity[lane] = own - load(spheres.seen_velocity[sphere_of(other)]) - load(task.shift_velocity[image_of(other)]);
    }
  });
  motion.velocity = vectors(velocity);
  if (!wall && task.stretch_rate != 0) motion.velocity.z = motion.velocity.z - Pack(task.stretch_rate) * at.between.z;
  if constexpr (turns == Turns::none) return motion;
  const auto first = [&](auto lane) { return at.first[lane]; };
  const auto second = [&](auto lane) { return sphere_of(at.second[lane]); };
  const bool equal = !wall && task.diameter > 0;
  motion.radius1 = equal ? Pack(task.diameter / 2) : radii(task, first);
  motion.radius2 = equal ? motion.radius1 : wall ? Pack(0) : radii(task, second);
  if (turns == Turns::sliding && equal) {
    Four sum[width];
    each_lane([&](auto lane) { sum[lane] = load(spheres.seen_spin[first(lane)]) + load(spheres.seen_spin[second(lane)]); });
    motion.swirl = motion.radius1 * vectors(sum);
  } else if (turns == Turns::sliding) {
    motion.swirl = motion.radius1 * spins(task, first) + motion.radius2 * spins(task, second);
  } else {
    motion.spin1 = task.turns ? spins(task, first) : Vectors{};
    motion.spin2 = task.turns && !wall ? spins(task, second) : Vectors{};
  }
  return motion;
}

/// A law of lib as packs, of the rows that the contacts have; `part` takes it out of a row.
template <class LawOf, class Part>
[[gnu::always_inline]] inline LawOf law_of_rows(const ForceTask& task, const ContactLanes& at, Part part) {
  return LawOf::from(part(task.rows[0]),
                     [&](auto member) { return Pack([&](auto lane) { return part(task.rows[at.row[lane]]).*member; }); });
}
template <class LawOf, class Part>
[[gnu::always_inline]] inline LawOf law_of_all(const ForceTask& task, Part part) {
  return LawOf::from(part(task.rows[0]), [&](auto member) { return Pack(part(task.rows[0]).*member); });
}

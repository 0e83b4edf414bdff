#pragma once

#include <cstdint>

#include <scalebreak/contact/contact_laws.hpp>

// What the hot loops work on: plain arrays, seen through pointers. The loops are compiled once per instruction set (kernel_*.cpp) and
// hold no physics of their own: they call the laws of lib with packs of doubles.

namespace scalebreak::dem {

/// Four doubles in one vector register. What stands in w is said where a list of them is declared.
struct alignas(32) Quad {
  double x = 0, y = 0, z = 0, w = 0;
};

/// The other sphere of a pair and the image in which it is met, in one number.
inline constexpr unsigned image_bits = 5;
inline constexpr std::uint32_t no_image = 13;  ///< of 27: (kx + 1) + 3 (ky + 1) + 9 (kz + 1)
[[nodiscard]] constexpr std::uint32_t packed(std::uint32_t sphere, std::uint32_t image) { return sphere << image_bits | image; }
[[nodiscard]] constexpr std::uint32_t sphere_of(std::uint32_t packed) { return packed >> image_bits; }
[[nodiscard]] constexpr std::uint32_t image_of(std::uint32_t packed) { return packed & ((1u << image_bits) - 1); }

/// The image of no cell, too far away for anything: what a pair that has become a contact leaves behind.
inline constexpr std::uint32_t nowhere = packed(0, 27);
inline constexpr std::size_t image_places = 28;

/// How two spheres of a contact are to each other.
enum PairState : std::uint8_t { apart = 0, touching = 1, bridged = 2 };

/// The pairs that may touch before the list is made anew, in the order of their first spheres. A wall's pairs have no second.
struct NearView {
  std::uint32_t count = 0;
  const std::uint32_t* first = nullptr;
  std::uint32_t* second = nullptr;  ///< packed; `nowhere` once they have touched
};

/// Where the x of a contact's history lies: eight contacts have their x side by side, then y, then z, so that packs need no turning.
inline constexpr std::uint32_t history_stride = 8;
[[nodiscard]] constexpr std::size_t history_place(std::uint32_t contact) {
  return static_cast<std::size_t>(contact / history_stride) * 3 * history_stride + contact % history_stride;
}

/// The pairs that have touched since the list was made, or did before. All lists go on for some places beyond the last contact, so that
/// whole packs can be read and written.
struct ContactsView {
  std::uint32_t count = 0;
  const std::uint32_t* first = nullptr;
  const std::uint32_t* second = nullptr;  ///< packed
  std::uint8_t* state = nullptr;
  const std::uint32_t* row = nullptr;  ///< of the laws
  double* slide = nullptr;             ///< histories, see history_place; null where no law has one
  double* roll = nullptr;
};

/// A face that particles touch; `axis` 0 to 2, `side` −1 (lower) or +1.
struct WallView {
  int axis = 2;
  double side = -1;
  double place = 0;  ///< coordinate of the plane
  Quad velocity;
  bool stops_spin = false;  ///< W 5: a sphere that touches has no spin
};

/// The spheres, sorted in space. position.w is the radius, velocity.w and spin.w what turns forces into accelerations.
struct SpheresView {
  Quad* position = nullptr;
  Quad* velocity = nullptr;
  Quad* spin = nullptr;  ///< null where nothing turns
  Quad* force = nullptr;
  Quad* torque = nullptr;
  const Quad* seen_velocity = nullptr;  ///< that dashpots see: velocity, or what it will be when the step is done
  const Quad* seen_spin = nullptr;
  bool far = false;  ///< more than the caches hold: worth asking for ahead of time
};

/// What a force on a sphere of another thread is kept as until all have come to it.
struct alignas(64) Deferred {
  Quad force, torque;  ///< torque.w: the sphere's number, so that all of it is one cache line, as the other thread fetches it

  [[nodiscard]] std::uint32_t sphere() const { return static_cast<std::uint32_t>(torque.w); }
};

/// What one thread counts and sums over a step.
struct Tally {
  double starts = 0;      ///< of touches; at a wall a half
  double touches = 0;     ///< pairs in touch, at a wall a half
  double wall_power = 0;  ///< of moving walls on the spheres [W]
  double moment[9] = {};  ///< Σ force on the second × branch to it, rows the force's component [N m]; where asked
};

struct ForceTask;

/// What the keeper of the lists does when contacts begin and end; `task` shows its lists, and is shown them anew.
struct ContactKeeper {
  /// A near pair touches: it becomes the last contact.
  virtual void meet(ForceTask& task, std::uint32_t first, std::uint32_t second) = 0;
  /// A contact that was apart touches again.
  virtual void meet_again(ForceTask& task, std::uint32_t contact) = 0;
  virtual void part(ForceTask& task, std::uint32_t contact) = 0;
  /// There is no room for what is deferred.
  virtual void make_room(ForceTask& task) = 0;

 protected:
  ~ContactKeeper() = default;
};

/// The forces of one list of pairs, on one thread.
struct ForceTask {
  SpheresView spheres;
  NearView near;
  ContactsView contacts;
  ContactKeeper* keeper = nullptr;
  double diameter = 0;                ///< sum of the radii of any two, where all are equal; else 0 [m]
  const ContactLaws* rows = nullptr;  ///< at the variables of the original pair
  bool one_row = true;
  const double* hold = nullptr;    ///< of a row: how far beyond touch a contact lasts [m]
  const double* bridge = nullptr;  ///< of a row: how far beyond touch a bridge lasts [m]; null without bridges
  const Quad* shift = nullptr;     ///< of the images
  const Quad* shift_velocity = nullptr;
  double stretch_rate = 0;                             ///< of the cell along z, which velocities are without [1/s]
  const WallView* wall = nullptr;                      ///< null: pairs of spheres
  double length = 1, spin = 1, force = 1, torque = 1;  ///< see MappedLaws
  double radius_share = 1;                             ///< original over scaled radius
  double history_step = 0;                             ///< by which histories go on before the force [s]; 0: they do not
  double history_after = 0;                            ///< and after it
  bool turns = false;                                  ///< do spheres have spins?
  bool sums_moment = false;
  std::uint32_t own_begin = 0, own_end = 0;  ///< spheres of this thread; others are deferred
  Quad* contact_force = nullptr;             ///< where told of: of each contact, on its second; w is not used
  Quad* contact_branch = nullptr;            ///< from its first centre to its second, or to the wall's plane
  Deferred* deferred = nullptr;
  std::uint32_t deferred_count = 0, deferred_room = 0;
  Tally tally;
};

/// One step: v += a dt, x += v dt. Forces are taken from the spheres `pushed` alone, as those of all others are zero.
struct MoveTask {
  SpheresView spheres;
  Quad* estimate = nullptr;  ///< of the velocity at the step's end, or null
  Quad* estimate_spin = nullptr;
  const std::uint32_t* pushed = nullptr;
  std::uint32_t pushed_count = 0;
  const std::uint32_t* movers = nullptr;  ///< those that move, null: all of [begin, end)
  std::uint32_t begin = 0, end = 0;
  double step = 0;
  Quad gravity;
  double shear_rate = 0, middle = 0;  ///< the mean flow shear_rate (z − middle) along x, which the largest speed is without
  double fastest_squared = 0;         ///< a bound on the largest square of the speed about the mean flow, given back
};

/// Which of the neighbours of the spheres [begin, end) come into the list of pairs: those nearer than touch and `margin`.
struct SelectTask {
  SpheresView spheres;
  const std::uint32_t* start = nullptr;      ///< of a sphere's neighbours, count + 1 of them
  const std::uint32_t* neighbour = nullptr;  ///< packed
  const Quad* shift = nullptr;
  std::uint32_t begin = 0, end = 0;
  double margin = 0;
  std::uint32_t* first = nullptr;  ///< room for all neighbours
  std::uint32_t* second = nullptr;
  std::uint32_t count = 0;  ///< given back
};

/// The hot loops for one instruction set.
struct Kernel {
  const char* name;
  void (*find_contacts)(ForceTask&);  ///< among the near pairs
  void (*forces)(ForceTask&);         ///< of the contacts
  void (*move)(MoveTask&);
  void (*select)(SelectTask&);
};

/// The fastest kernel that this processor runs, or the one of a name: "baseline", "avx2", "avx512". Throws InputError for a name
/// that there is not, or that this processor cannot run.
[[nodiscard]] const Kernel& kernel(const char* name = nullptr);
/// The fastest for lists of a few contacts, which do not fill the widest vectors.
[[nodiscard]] const Kernel& kernel_for_few();

}  // namespace scalebreak::dem

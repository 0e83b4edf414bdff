#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace scalebreak {

/// When a sphere's next event is due. Ordered by time and then by number, so that every queue gives the same order.
struct Due {
  double time = 0;  ///< [s]; infinite: never
  std::uint32_t sphere = 0;

  friend auto operator<=>(const Due&, const Due&) = default;
};

/// A future event list with one event a sphere (Smallenburg, Eur. Phys. J. E 45, 22 (2022)).
///
/// `reset(n)` sets n spheres whose events are never due; `schedule` replaces a sphere's event, by one not before the last that was due;
/// `next` is the first of all, which stays until it is replaced; `time_of` is when a sphere's is due. `operations` counts comparisons and moves of entries since the reset.
template <class Queue>
concept EventQueue = requires(Queue queue, const Queue& constant, std::size_t spheres, std::uint32_t sphere, double time) {
  queue.reset(spheres);
  queue.schedule(sphere, time);
  { queue.next() } -> std::same_as<Due>;
  { constant.time_of(sphere) } -> std::same_as<double>;
  { constant.operations() } -> std::same_as<std::uint64_t>;
};

}  // namespace scalebreak

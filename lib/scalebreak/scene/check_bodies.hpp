#pragma once

#include <utility>
#include <vector>

#include <scalebreak/scene/given.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

inline constexpr std::size_t fewest_bodies = 2, most_bodies = 50;

/// Overlap over radius up to which spheres count as touching at the start.
inline constexpr double touching_overlap = 1e-9;
/// The same of a gap: one by rounding alone is none.
inline constexpr double touching_gap = 1e-12;
/// Surfaces that approach or part slower than this share of the largest speed are at rest to each other.
inline constexpr double resting_speed = 1e-12;

/// Throws InputError: so many bodies there cannot be. `item` is one of those too many, or the only one.
[[noreturn]] void refuse_number_of_bodies(const Assignment& item, std::size_t bodies);

/// Every pair of bodies, by index, that can collide: not those of two that are fixed.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> meeting_pairs(const Input& input);

/// Are there two bodies at least, each with what has no default? Throws InputError.
void check_bodies_are_whole(const Input& input, const Given& given);

/// Do the bodies stand apart, and will two of them meet? Throws InputError.
void check_bodies(const Input& input, const Given& given);

}  // namespace scalebreak

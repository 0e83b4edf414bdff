#pragma once

#include <functional>
#include <vector>

#include <scalebreak/collisions/bodies/few_bodies.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// An input as its bodies move: the scaled system, and the laws between its bodies.
struct MovingScene {
  std::vector<MovingBody> bodies;
  std::vector<MappedLaws> laws;  ///< of the pairs (0, 1), (0, 2) … (1, 2) …

  /// The laws between bodies i < j.
  [[nodiscard]] const MappedLaws& between(int i, int j) const {
    const int count = static_cast<int>(bodies.size());
    return laws[static_cast<std::size_t>(i * (2 * count - i - 1) / 2 + j - i - 1)];
  }
  /// Moves it to its end.
  [[nodiscard]] MotionOutcome move(const MotionOptions& options) const {
    return move_bodies(
        bodies, [this](int i, int j) { return between(i, j); }, options);
  }
};

/// The scene of an input under a scaling law. A pair is placed as the axes have it: body 1 at first touch at +z of body 2, which
/// rests, or above the wall z = 0. A size law enlarges the distances of [[body]] about their centre of mass, and divides all spins.
[[nodiscard]] MovingScene moving_scene(const Input& input, const ScalingLaw& law, double factor);
/// Under the input's own law.
[[nodiscard]] MovingScene moving_scene(const Input& input);

}  // namespace scalebreak

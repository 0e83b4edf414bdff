#pragma once

#include <vector>

#include <scalebreak/collisions/bodies/scene_collision.hpp>

namespace scalebreak {

/// A motion as it was followed once more, closely enough to be drawn.
struct MotionRecord {
  struct Instant {
    double time;
    std::vector<MovingBody> bodies;
    EnergyAccount energy;
    double largest_overlap;
    std::vector<ContactState> contacts;
  };
  struct Change {
    double time;
    int first, second;
    ContactChange what;
  };
  std::vector<Instant> instants;
  std::vector<Change> changes;
};

/// Records the motion of an input with at least `points` instants in its shortest contact, but with no more than a few thousand in all.
[[nodiscard]] MotionRecord record_motion(const Input& input, int points);

}  // namespace scalebreak

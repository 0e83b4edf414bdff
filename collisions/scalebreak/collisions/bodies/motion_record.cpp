#include <scalebreak/collisions/bodies/motion_record.hpp>

#include <algorithm>
#include <map>

#include <scalebreak/collisions/bodies/moving_scene.hpp>

namespace scalebreak {
namespace {

/// What a file of all bodies can hold and a plot still draws.
int most_instants(std::size_t bodies) { return std::clamp(20'000 / static_cast<int>(bodies), 400, 5000); }

/// Steps that show the shortest contact well, unless contacts and bridges last too long for it.
double interval(const std::vector<MotionRecord::Change>& changes, double end, int points, int most) {
  std::map<std::pair<int, int>, double> touched;
  double shortest = end, together = 0;
  for (const auto& change : changes) {
    const std::pair pair{change.first, change.second};
    if (change.what == ContactChange::touch) touched[pair] = change.time;
    if (change.what != ContactChange::separation) continue;
    shortest = std::min(shortest, change.time - touched[pair]);
  }
  if (!changes.empty()) together = end - changes.front().time;
  return std::max(shortest / points, together / most);
}

}  // namespace

MotionRecord record_motion(const Input& input, int points) {
  const MovingScene scene = moving_scene(input);
  MotionRecord record;
  MotionOptions options{.tolerance = input.tolerance, .duration = input.run.duration};
  options.on_change = [&](double time, int first, int second, ContactChange what) {
    record.changes.push_back({time, first, second, what});
  };
  const MotionOutcome outcome = scene.move(options);
  options.on_change = {};
  options.sample_contacts = true;
  options.sample_interval = interval(record.changes, outcome.time, points, most_instants(scene.bodies.size()));
  // Where the motion itself asks for finer steps than this, they are not all kept.
  bool pending = false;
  options.observer = [&](const MotionSample& sample) {
    if (pending) record.instants.pop_back();
    record.instants.push_back({sample.time, sample.bodies, sample.energy, sample.largest_overlap, sample.contacts});
    const auto count = record.instants.size();
    pending = count > 1 && sample.time - record.instants[count - 2].time < options.sample_interval / 2;
  };
  (void)scene.move(options);
  return record;
}

}  // namespace scalebreak

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/ensembles/tradeoff/collision_scene.hpp>

namespace scalebreak {

/// A scene made ready for a method at one setting, or why it has no answer. Keeps a reference to the scene.
struct PreparedCollision {
  /// Steps of `stretch` times the setting, of which the first begins `phase` before touch; all else is the same at each.
  std::function<CollisionOutcome(double stretch, double phase)> resolve = {};
  std::string refusal = {};  ///< a sentence without its stop; empty: it is resolved
};

/// A way to resolve a collision, with one setting that makes it better the smaller it is.
struct CollisionMethod {
  Method word;                                                        ///< of study.methods
  const char* setting;                                                ///< "step_fraction", "tolerance"; "" where there is none
  bool steps = false;                                                 ///< has it steps of time, and so phases of them?
  std::function<std::vector<double>(const TradeoffInput&)> settings;  ///< those to compare
  std::function<PreparedCollision(const CollisionScene&, double setting, const TableStore&)> prepare;

  [[nodiscard]] const char* name() const { return method_words[static_cast<std::size_t>(word)]; }
  [[nodiscard]] bool has_setting() const { return *setting != 0; }
};

/// All of them, in the order of their words.
[[nodiscard]] const std::vector<CollisionMethod>& collision_methods();

/// A method at one setting. Errors are those of CollisionError over the phases at which the collision begins.
struct CollisionPoint {
  const CollisionMethod* method = nullptr;
  double setting = 0;                            ///< 0 where the method has none
  double step = 0;                               ///< [s]; 0 without steps
  int phases = 0, unparted = 0;                  ///< runs, one without steps, and those in which what should have parted had not
  double motion_rms = 0, motion_largest = 0;     ///< over the scene's speed
  double energy_mean = 0;                        ///< gained, over that at the start
  std::optional<double> time_rms, time_largest;  ///< of the contact time, relative
  double force_evaluations = 0;                  ///< mean; a lookup and a formula count as one
  double seconds = 0;                            ///< of wall time, the fastest run
  bool on_front = false;                         ///< no other has both a smaller motion_rms and fewer force evaluations
};

/// Each phase has its own length of the step, within ± 5 % of the setting, so that what happens later comes at all phases too.
[[nodiscard]] CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting,
                                               const PreparedCollision& prepared, int phases);
/// Of a method that refuses nothing and has no tables: by steps, or the exact engine.
[[nodiscard]] CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting, int phases);

}  // namespace scalebreak

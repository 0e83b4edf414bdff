#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/tradeoff/collision_scene.hpp>

namespace scalebreak {

/// A way to resolve a collision, with one setting that makes it better the smaller it is.
struct CollisionMethod {
  Method method;
  const char* setting;                           ///< "step_fraction", "tolerance"
  bool steps;                                    ///< has it steps of time, and so phases of them?
  std::vector<double> TradeoffInput::*settings;  ///< those to compare
  std::function<CollisionOutcome(const CollisionScene&, double setting, double phase)> resolve;

  [[nodiscard]] std::string name() const { return method_words[static_cast<std::size_t>(method)]; }
};

/// All of them, in the order of Method.
[[nodiscard]] const std::vector<CollisionMethod>& collision_methods();

/// A method at one setting. Errors are those of CollisionError over the phases at which the collision begins.
struct CollisionPoint {
  Method method = Method::exact;
  double setting = 0;
  double step = 0;                               ///< [s]; 0 without steps
  int phases = 0, unparted = 0;                  ///< runs, and those in which what should have parted had not
  double motion_rms = 0, motion_largest = 0;     ///< over the scene's speed
  double energy_mean = 0;                        ///< gained, over that at the start
  std::optional<double> time_rms, time_largest;  ///< of the contact time, relative
  double force_evaluations = 0;                  ///< mean
  double seconds = 0;                            ///< of wall time, the fastest run
  bool on_front = false;                         ///< no other has both a smaller motion_rms and fewer force evaluations
};

/// Each phase has its own length of the step, within ± 5 % of the setting, so that what happens later comes at all phases too.
[[nodiscard]] CollisionPoint measure_collision(const CollisionScene& scene, const CollisionMethod& method, double setting, int phases);

}  // namespace scalebreak

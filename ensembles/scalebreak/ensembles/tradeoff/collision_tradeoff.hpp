#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>
#include <scalebreak/ensembles/tradeoff/convergence.hpp>

namespace scalebreak {

/// How the errors of a method fall with its setting, over the finer half of the settings at which all runs parted and that are above
/// the reference's own error.
struct CollisionConvergence {
  const CollisionMethod* method = nullptr;
  ConvergenceOrder motion, contact_time;  ///< NaN where there are fewer than three such settings
};

/// Accuracy against cost of the methods on one collision.
struct CollisionTradeoff {
  double speed = 0;                    ///< that errors are relative to [m/s]
  std::optional<double> contact_time;  ///< exactly; of a pair [s]
  double rayleigh_step = 0;            ///< [s]
  std::vector<CollisionPoint> points;  ///< by method, then in the order of the settings
  std::vector<CollisionConvergence> convergence;
  std::vector<std::string> refusals;  ///< sentences on the methods that have no point, or not at each setting
};

/// Steps of the soft-sphere engine that the study of a collision takes, about.
[[nodiscard]] double soft_sphere_steps(const Input& input);

/// Of the input's pair or bodies, by the methods and settings of [study]. `progress` is told the share that is done. Serial, as it
/// measures wall times. Throws what `collision_scene` throws, and InputError where run.duration takes steps without end.
[[nodiscard]] CollisionTradeoff collision_tradeoff(const Input& input, const TableStore& store,
                                                   const std::function<void(double)>& progress = {});

}  // namespace scalebreak

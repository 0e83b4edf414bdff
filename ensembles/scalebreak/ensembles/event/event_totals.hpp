#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace scalebreak {

/// Running totals of an event-driven flow since its start.
struct EventTotals {
  long collisions = 0;                                       ///< of two spheres
  long wall_collisions = 0;                                  ///< of a sphere and a wall
  long stale = 0;                                            ///< events that another had overtaken
  long lists = 0;                                            ///< of one sphere, made anew
  long renewals = 0;                                         ///< of everything: order in memory, lists, time
  long patches = 0;                                          ///< groups of spheres that were begun to be integrated
  long taken_back = 0;                                       ///< collisions that a third body disturbed before their contacts had ended
  long patch_steps = 0;                                      ///< of time, of single spheres
  double patch_evaluations = 0;                              ///< of contact forces in patches; at a wall ½
  double patch_starts = 0;                                   ///< of contacts in patches, at a wall ½
  double patch_time = 0;                                     ///< that spheres have spent in patches [s]
  double wall_work = 0;                                      ///< done by moving walls on the spheres [J]
  double dissipated = 0;                                     ///< by collisions [J]
  double contact_time = 0;                                   ///< [s]; of a sphere at a wall ½
  Eigen::Matrix3d contact_moment = Eigen::Matrix3d::Zero();  ///< of impulse and branch, compression positive [N m s]
};

}  // namespace scalebreak

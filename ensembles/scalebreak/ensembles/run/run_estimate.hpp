#pragma once

#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// What a run will come to, before it starts.
struct RunEstimate {
  double particles = 0, steps = 0;  ///< of one replica
  double seconds = 0;               ///< wall time of all replicas; a guess, within a factor of about 10
  double bytes = 0;                 ///< of memory
  double file_bytes = 0;            ///< of particle files, of all replicas
  double contact_time = 0;          ///< of the shortest contact that occurs [s]
  double collision_rate = 0;        ///< of a sphere at the speed of the fastest meeting, by Enskog's theory [1/s]
  double hybrid_seconds = 0;        ///< wall time of all replicas by the hybrid; the same kind of guess
};

/// Of a flow that starts from a file, the file is read. `threads` at least 1. Throws InputError.
[[nodiscard]] RunEstimate estimate_run(const Input& input, int threads);

}  // namespace scalebreak

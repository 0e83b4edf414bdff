#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/ensembles/engine/flow_engine.hpp>
#include <scalebreak/ensembles/engine/step_choice.hpp>
#include <scalebreak/ensembles/run/run_schedule.hpp>

namespace scalebreak {

/// Work of a run as counts, which no machine changes.
struct RunWork {
  double evaluations = 0;   ///< of contact forces of what touches, in patches too; of a sphere at a wall ½
  double lookups = 0;       ///< collisions asked of tables, those included that tables did not answer or that were taken back
  double sphere_steps = 0;  ///< of single spheres, in patches too

  [[nodiscard]] static RunWork of(const EngineTotals& totals, double particles);
  /// Evaluations and lookups together.
  [[nodiscard]] double counted() const { return evaluations + lookups; }
};

/// What there is to say of a run beside what it measured.
struct RunRecord {
  std::string engine = "dem";  ///< or "event", "hybrid"
  std::uint64_t replica = 0;
  std::uint64_t particles = 0;
  Eigen::Vector3d cell{0, 0, 0};  ///< its edges [m]
  double volume_fraction = 0;     ///< at the start
  StepChoice step;                ///< of an engine that has one
  RunSchedule schedule;
  double gravity_energy = 0;  ///< Σ m g·x at the start [J]
  double time = 0;            ///< reached [s]
  long steps = 0;
  std::optional<long> events, integrated, delayed;  ///< as in EngineTotals
  std::optional<PatchTotals> patches;
  long handovers = 0;
  double contact_starts = 0;
  RunWork warmup, work;  ///< of the warm-up, as far as it was counted, and since
  std::vector<std::string> warnings;

  void save(std::string& bytes) const;
  /// Takes its own part off the front. WorkError where it is cut short.
  void load(std::string_view& bytes);
};

}  // namespace scalebreak

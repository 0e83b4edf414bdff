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
  std::vector<std::string> warnings;

  void save(std::string& bytes) const;
  /// Takes its own part off the front. WorkError where it is cut short.
  void load(std::string_view& bytes);
};

}  // namespace scalebreak

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/ensembles/engine/flow_engine.hpp>
#include <scalebreak/ensembles/run/run_record.hpp>
#include <scalebreak/measure/flow_measurement.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// What an engine says at one instant.
struct FlowInstant {
  System system;
  std::vector<ContactForce> contacts;
  EngineTotals totals;
  double elastic_energy = 0;  ///< [J]
  double work = 0;            ///< of walls and gravity since the start [J]
  bool forces_known = true;   ///< of the contacts

  [[nodiscard]] Sample sample() const;
};

/// One run of a flow with an engine, "dem", "event" or "hybrid", from its start through the warm-up and the measurement, sample by sample.
class FlowRun {
 public:
  static constexpr int slabs = 20;

  /// Starts. `threads` at least 1; `tables` as choose_step has them, and for engines of tables in the user's cache without. Throws
  /// InputError, and WorkError where the cell cannot be filled.
  FlowRun(const Input& input, std::uint64_t replica, int threads, const TableStore* tables, const std::string& engine);
  /// Goes on where `saved` was left: bit for bit with the same input and threads.
  FlowRun(const Input& input, std::string_view saved, int threads, const TableStore* tables);

  /// To the next sample. Throws WorkError where the engine fails.
  void advance();
  [[nodiscard]] bool done() const { return sample_ == record_.schedule.samples; }
  /// Is this sample one of the series?
  [[nodiscard]] bool row_is_due() const { return sample_ % record_.schedule.samples_per_row == 0; }
  /// At this sample, where a row is due.
  [[nodiscard]] const FlowInstant& instant() const { return instant_; }
  [[nodiscard]] bool measures() const { return sample_ >= record_.schedule.warmup_samples; }
  /// Of the way to the end.
  [[nodiscard]] double share() const { return static_cast<double>(sample_) / static_cast<double>(record_.schedule.samples); }

  [[nodiscard]] const RunRecord& record() const { return record_; }
  [[nodiscard]] const FlowMeasurement& measurement() const { return measurement_; }
  [[nodiscard]] std::string save() const;

 private:
  void plan(const Input& input, const System& start, double speed, const TableStore* tables);
  void look();
  /// Of a start, or of what an engine left.
  template <class Start>
  [[nodiscard]] std::unique_ptr<FlowEngine> make_engine(const Start& start, const Input& input, int threads,
                                                        const TableStore* tables) const;

  Eigen::Vector3d gravity_;
  RunRecord record_;
  FlowMeasurement measurement_{slabs};
  long sample_ = 0;
  std::unique_ptr<FlowEngine> engine_;
  FlowInstant instant_;
};

}  // namespace scalebreak

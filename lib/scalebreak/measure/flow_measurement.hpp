#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <scalebreak/measure/flow_result.hpp>
#include <scalebreak/measure/sums/flow_state.hpp>
#include <scalebreak/measure/sums/velocity_profile.hpp>
#include <scalebreak/statistics/block_series.hpp>

namespace scalebreak {

/// Measures a flow from samples of its state, whatever engine made them. Means weigh each interval between samples by its length,
/// so begin it at the end of the warm-up.
class FlowMeasurement {
 public:
  /// Slabs of the gap, at least 1.
  explicit FlowMeasurement(int slabs = 20);

  /// In order of time, WorkError otherwise; a sample at the time of the last one replaces it and measures nothing.
  void add(const Sample& sample);
  [[nodiscard]] FlowResult result() const;

  /// The state for a checkpoint: after `load` it goes on bit for bit. WorkError where the bytes are of another cut or cut short.
  [[nodiscard]] std::string save() const;
  void load(std::string_view bytes);

 private:
  int slabs_;
  ProfileKind profile_ = ProfileKind::uniform;
  std::optional<FlowState> last_;
  BlockSeries blocks_;
};

}  // namespace scalebreak

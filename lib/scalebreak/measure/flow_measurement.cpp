#include <scalebreak/measure/flow_measurement.hpp>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/sums/evaluate_flow.hpp>

namespace scalebreak {

FlowMeasurement::FlowMeasurement(int slabs) : slabs_(slabs) {
  if (slabs < 1) throw WorkError(fmt::format("a flow was to be measured in {} slabs; at least 1 is needed", slabs));
}

void FlowMeasurement::add(const Sample& sample) {
  FlowState state = flow_state(sample, slabs_);
  if (!last_) profile_ = profile_kind(sample.system.cell);
  if (last_ && state.time < last_->time) {
    throw WorkError(fmt::format("a flow was measured at {} s after {} s", state.time, last_->time));
  }
  if (last_ && state.time > last_->time) blocks_.add(interval_sums(*last_, state));
  last_ = std::move(state);
}

FlowResult FlowMeasurement::result() const { return evaluate_flow(blocks_.blocks(), profile_, last_ ? last_->shear_rate : 0); }

std::string FlowMeasurement::save() const {
  std::string bytes;
  put_bytes(bytes, slabs_);
  put_bytes(bytes, static_cast<int>(profile_));
  put_bytes(bytes, last_.has_value());
  if (last_) scalebreak::save(bytes, *last_);
  blocks_.save(bytes);
  return bytes;
}

void FlowMeasurement::load(std::string_view bytes) {
  int slabs = 0, profile = 0;
  bool begun = false;
  take_bytes(bytes, slabs);
  if (slabs != slabs_) throw WorkError(fmt::format("a saved measurement has {} slabs; this one has {}", slabs, slabs_));
  take_bytes(bytes, profile);
  take_bytes(bytes, begun);
  FlowMeasurement loaded(slabs);
  loaded.profile_ = static_cast<ProfileKind>(profile);
  if (begun) scalebreak::load(bytes, loaded.last_.emplace());
  loaded.blocks_.load(bytes);
  *this = std::move(loaded);
}

}  // namespace scalebreak

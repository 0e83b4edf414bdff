#include <scalebreak/ensembles/run/replica_mean.hpp>

#include <cmath>
#include <limits>

namespace scalebreak {
namespace {

/// Of one number in every replica.
template <class Get>
Measured mean(const std::vector<FlowResult>& replicas, const Get& get) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  double sum = 0, squares = 0, count = 0;
  for (const FlowResult& replica : replicas) {
    if (const double value = get(replica); std::isfinite(value)) sum += value, count += 1;
  }
  const double middle = count > 0 ? sum / count : nothing;
  for (const FlowResult& replica : replicas) {
    if (const double value = get(replica); std::isfinite(value)) squares += (value - middle) * (value - middle);
  }
  return {middle, count > 1 ? std::sqrt(squares / (count - 1) / count) : nothing};
}

MeasuredTensor mean_tensor(const std::vector<FlowResult>& replicas, MeasuredTensor FlowResult::*tensor) {
  MeasuredTensor result;
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2}) {
      const Measured entry = mean(replicas, [&](const FlowResult& r) { return (r.*tensor).value(i, j); });
      result.value(i, j) = entry.value, result.error(i, j) = entry.error;
    }
  }
  return result;
}

}  // namespace

FlowResult replica_mean(const std::vector<FlowResult>& replicas) {
  if (replicas.size() == 1) return replicas.front();
  FlowResult result = replicas.front();
  result.duration = mean(replicas, [](const FlowResult& r) { return r.duration; }).value;
  result.outside = mean(replicas, [](const FlowResult& r) { return r.outside; }).value;
  for (std::size_t k = 0; k < result.quantities.size(); ++k)
    result.quantities[k].measured = mean(replicas, [&](const FlowResult& r) { return r.quantities[k].measured.value; });
  result.stress = mean_tensor(replicas, &FlowResult::stress);
  result.stress_contact = mean_tensor(replicas, &FlowResult::stress_contact);
  for (std::size_t s = 0; s < result.profile.height.size(); ++s)
    result.profile.height[s] = mean(replicas, [&](const FlowResult& r) { return r.profile.height[s]; }).value;
  for (std::size_t c = 0; c < result.profile.columns.size(); ++c) {
    for (std::size_t s = 0; s < result.profile.columns[c].slabs.size(); ++s)
      result.profile.columns[c].slabs[s] = mean(replicas, [&](const FlowResult& r) { return r.profile.columns[c].slabs[s].value; });
  }
  return result;
}

}  // namespace scalebreak

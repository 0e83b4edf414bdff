#include <scalebreak/ensembles/run/replica_mean.hpp>

#include <scalebreak/statistics/pooled_mean.hpp>

namespace scalebreak {
namespace {

/// Of one number in every replica.
template <class Get>
Measured mean(const std::vector<FlowResult>& replicas, const Get& get) {
  std::vector<Measured> values;
  for (const FlowResult& replica : replicas) values.push_back(get(replica));
  return pooled_mean(values);
}

/// Of one that has no error.
template <class Get>
double plain_mean(const std::vector<FlowResult>& replicas, const Get& get) {
  return mean(replicas, [&](const FlowResult& r) { return Measured{get(r), 0}; }).value;
}

MeasuredTensor mean_tensor(const std::vector<FlowResult>& replicas, MeasuredTensor FlowResult::*tensor) {
  MeasuredTensor result;
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2}) {
      const Measured entry = mean(replicas, [&](const FlowResult& r) {
        return Measured{(r.*tensor).value(i, j), (r.*tensor).error(i, j)};
      });
      result.value(i, j) = entry.value, result.error(i, j) = entry.error;
    }
  }
  return result;
}

}  // namespace

FlowResult replica_mean(const std::vector<FlowResult>& replicas) {
  if (replicas.size() == 1) return replicas.front();
  FlowResult result = replicas.front();
  result.duration = plain_mean(replicas, [](const FlowResult& r) { return r.duration; });
  result.outside = plain_mean(replicas, [](const FlowResult& r) { return r.outside; });
  for (std::size_t k = 0; k < result.quantities.size(); ++k)
    result.quantities[k].measured = mean(replicas, [&](const FlowResult& r) { return r.quantities[k].measured; });
  result.stress = mean_tensor(replicas, &FlowResult::stress);
  result.stress_contact = mean_tensor(replicas, &FlowResult::stress_contact);
  for (std::size_t s = 0; s < result.profile.height.size(); ++s)
    result.profile.height[s] = plain_mean(replicas, [&](const FlowResult& r) { return r.profile.height[s]; });
  for (std::size_t c = 0; c < result.profile.columns.size(); ++c) {
    for (std::size_t s = 0; s < result.profile.columns[c].slabs.size(); ++s)
      result.profile.columns[c].slabs[s] = mean(replicas, [&](const FlowResult& r) { return r.profile.columns[c].slabs[s]; });
  }
  return result;
}

}  // namespace scalebreak

#include <scalebreak/table/rolling_lookup.hpp>

namespace scalebreak {

RollingGroups rolling_groups(const RollingKey& key) {
  switch (key.model) {
    case RollingModel::epsd: return {key.inertia * key.limit, key.inertia * key.limit * key.limit};
    case RollingModel::epsd2: return {key.inertia * key.limit, key.inertia * key.stiffness};
    case RollingModel::ar: return {key.limit, key.inertia * key.stiffness};
    default: return {key.inertia * key.limit, 1};
  }
}

RollingLookup::RollingLookup(const RollingTable& weaker, const RollingTable& stronger, const RollingKey& pair) : weaker_(&weaker) {
  const RollingGroups own = rolling_groups(pair), low = rolling_groups(weaker.key()), high = rolling_groups(stronger.key());
  weaker_ratio_ = low.unit / own.unit;
  if (high.strength == low.strength) return;
  stronger_ = &stronger, stronger_ratio_ = high.unit / own.unit;
  const double place = (own.strength - low.strength) / (high.strength - low.strength);
  weaker_share_ = (1 - place) * own.strength / low.strength, stronger_share_ = place * own.strength / high.strength;
}

std::optional<double> RollingLookup::find(double speed, double ratio) const {
  const auto left = weaker_->find(speed, ratio * weaker_ratio_);
  if (!stronger_ || !left) return left;
  return 1 - weaker_share_ * (1 - *left) - stronger_share_ * (1 - *stronger_->find(speed, ratio * stronger_ratio_));
}

}  // namespace scalebreak

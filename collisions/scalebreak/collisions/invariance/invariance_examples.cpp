#include <scalebreak/collisions/invariance/invariance_examples.hpp>

#include <algorithm>
#include <cmath>

namespace scalebreak {

std::vector<Example> examples(const InvarianceStudy& study, bool farthest) {
  std::vector<Example> list;
  for (const InvarianceRecord& r : study.records) {
    const ScalingLaw* law = find_scaling_law(r.law);
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const Example& e) { return e.law == law && (e.factor < 1) == (r.factor < 1); });
    const auto distance = [](double factor) { return std::abs(std::log(factor)); };
    if (at == list.end()) {
      list.push_back({law, r.factor, 1 + static_cast<int>(list.size())});
    } else if (farthest == (distance(r.factor) > distance(at->factor))) {
      at->factor = r.factor;
    }
  }
  return list;
}

std::string readable(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace scalebreak

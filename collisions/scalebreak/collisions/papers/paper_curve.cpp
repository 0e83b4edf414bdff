#include <scalebreak/collisions/papers/paper_curve.hpp>

#include <algorithm>
#include <cmath>

namespace scalebreak {

double PaperCurve::at(double t) const {
  const auto next = std::lower_bound(time.begin(), time.end(), t);
  if (next == time.begin()) return value.front();
  if (next == time.end()) return value.back();
  const auto i = static_cast<std::size_t>(next - time.begin());
  const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return value[i - 1] + share * (value[i] - value[i - 1]);
}

std::optional<double> curve_distance(const PaperCurve& original, const PaperCurve& other, double end, int points) {
  double low = original.at(0), high = low, largest = 0;
  for (int i = 0; i <= points; ++i) {
    const double t = end * i / points, y = original.at(t);
    low = std::min(low, y), high = std::max(high, y);
    largest = std::max(largest, std::abs(other.at(t) - y));
  }
  return high > low ? std::optional(largest / (high - low)) : std::nullopt;
}

}  // namespace scalebreak

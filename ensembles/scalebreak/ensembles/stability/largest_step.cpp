#include <scalebreak/ensembles/stability/largest_step.hpp>

#include <algorithm>
#include <cmath>

namespace scalebreak {
namespace {

constexpr double first_tried = 0.25, smallest_tried = 1e-3, largest_tried = 4, bracket = 1.02;

}  // namespace

double LargestStep::fraction() const { return std::sqrt(stable->fraction * unstable->fraction); }
double LargestStep::half_width() const { return (unstable->fraction - stable->fraction) / 2; }

LargestStep largest_step(const std::function<StepTrial(double)>& at, const std::function<bool(const StepTrial&)>& is_stable) {
  LargestStep largest;
  const auto attempt = [&](double fraction) {
    largest.tried.push_back(at(fraction));
    (is_stable(largest.tried.back()) ? largest.stable : largest.unstable) = largest.tried.back();
  };
  attempt(first_tried);
  while (!largest.unstable && largest.stable->fraction < largest_tried) attempt(std::min(2 * largest.stable->fraction, largest_tried));
  while (!largest.stable && largest.unstable->fraction > smallest_tried) attempt(std::max(largest.unstable->fraction / 2, smallest_tried));
  while (largest.found() && largest.unstable->fraction > bracket * largest.stable->fraction) attempt(largest.fraction());
  return largest;
}

}  // namespace scalebreak

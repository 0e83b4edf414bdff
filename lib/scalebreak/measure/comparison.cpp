#include <scalebreak/measure/comparison.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace scalebreak {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Measured relative_difference(const Measured& first, const Measured& second) {
  if (first.value == 0) return {nothing, nothing};
  // Of second/first: the first's error counts by the ratio.
  const double ratio = second.value / first.value;
  return {(second.value - first.value) / first.value, std::hypot(second.error, ratio * first.error) / std::abs(first.value)};
}

Verdict judge(const Comparison& c, double standard_errors) {
  if (!std::isfinite(c.difference.value) || !std::isfinite(c.difference.error)) return Verdict::unknown;
  const double rounding = 1e-12 * std::max(std::abs(c.first.value), std::abs(c.second.value));
  const bool exceeds = std::abs(c.difference.value) > standard_errors * c.difference.error + rounding;
  return exceeds ? Verdict::difference : Verdict::no_difference;
}

std::string amount(const Comparison& c) {
  const bool in_percent = std::isfinite(c.relative.value);
  const Measured shown = in_percent ? Measured{100 * c.relative.value, 100 * c.relative.error} : c.difference;
  const std::string unit = in_percent ? " %" : c.unit == "-" ? "" : " " + c.unit;
  if (!std::isfinite(shown.error)) return fmt::format("{:+.3g}{}", shown.value, unit);
  const bool fixed = in_percent && shown.error > 1e-6 && std::abs(shown.value) < 1e6;
  if (!fixed) return fmt::format("{:+.3g}{} ± {:.2g}{}", shown.value, unit, shown.error, unit);
  const int decimals = std::max(1, static_cast<int>(std::ceil(-std::log10(shown.error))));
  return fmt::format("{:+.{}f}{} ± {:.{}f}{}", shown.value, decimals, unit, shown.error, decimals, unit);
}

}  // namespace

Comparison compare(const Quantity& first, const Quantity& second, double standard_errors) {
  const Measured &a = first.measured, &b = second.measured;
  Comparison c{first.name, first.unit, a, b, {b.value - a.value, std::hypot(a.error, b.error)}, relative_difference(a, b), {}};
  c.verdict = judge(c, standard_errors);
  return c;
}

std::vector<Comparison> compare(const std::vector<Quantity>& first, const std::vector<Quantity>& second, double standard_errors) {
  std::vector<Comparison> comparisons;
  for (const Quantity& quantity : first) {
    const auto same = std::find_if(second.begin(), second.end(), [&](const Quantity& other) { return other.name == quantity.name; });
    if (same != second.end()) comparisons.push_back(compare(quantity, *same, standard_errors));
  }
  return comparisons;
}

std::string sentence(const Comparison& c) {
  if (!std::isfinite(c.difference.value)) return fmt::format("{} is not in both runs: nothing to compare", c.name);
  if (c.verdict == Verdict::unknown) return fmt::format("{} differs by {}, but a run is too short to tell its error", c.name, amount(c));
  return fmt::format("{} differs by {}: {}", c.name, amount(c),
                     c.verdict == Verdict::difference ? "a difference" : "no difference beyond the error");
}

}  // namespace scalebreak

#pragma once

#include <string>
#include <vector>

#include <scalebreak/measure/flow_result.hpp>

namespace scalebreak {

enum class Verdict {
  no_difference,  ///< beyond the error
  difference,
  unknown,  ///< a value or an error is missing
};

/// A quantity of two independent runs.
struct Comparison {
  std::string name, unit;
  Measured first, second;
  Measured difference;  ///< second − first, and its standard error
  Measured relative;    ///< difference over first, and its standard error to first order; NaN where the first is zero
  Verdict verdict;
};

/// A difference is one if it exceeds so many of its standard errors, and rounding (1e-12 of the values).
[[nodiscard]] Comparison compare(const Quantity& first, const Quantity& second, double standard_errors = 2);

/// Those that both have, in the order of the first.
[[nodiscard]] std::vector<Comparison> compare(const std::vector<Quantity>& first, const std::vector<Quantity>& second,
                                              double standard_errors = 2);

/// "temperature differs by +8.1 % ± 0.9 %: a difference".
[[nodiscard]] std::string sentence(const Comparison& comparison);

}  // namespace scalebreak

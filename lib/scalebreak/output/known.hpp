#pragma once

#include <cmath>

#include <nlohmann/json.hpp>

#include <scalebreak/output/csv.hpp>

namespace scalebreak {

/// A number, or null where it is not known (NaN, infinite).
[[nodiscard]] inline nlohmann::json known_number(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }

/// The same as a cell: empty where it is not known.
[[nodiscard]] inline CsvCell known_cell(double value) { return std::isfinite(value) ? CsvCell(value) : CsvCell(); }

}  // namespace scalebreak
